//! `cargo xtask firmware`: builds the firmware of each board, measures and checks it.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use unoclp_boot::Model;
use unoclp_core::Board;
use unoclp_core::isa::Opcode;
use unoclp_modbus::map;

use crate::budget::{Size, thousands};
use crate::link::{self, Link};
use crate::shell::{self, say};
use crate::tested;
use crate::toolchain::Toolchain;
use crate::{arguments, mulcheck, parts, setup};

/// `cargo xtask firmware`
#[derive(clap::Args)]
pub struct Args {
    /// Store this build in firmware/ as the tested firmware: the hex files, their symbols and checksums, and tools.toml
    #[arg(long)]
    keep: bool,
    /// Build the firmware of one board only: uno, nano or mega
    #[arg(long, value_parser = only())]
    board: Option<Model>,
}

fn only() -> impl TypedValueParser<Value = Model> {
    PossibleValuesParser::new(BOARDS.map(Model::name)).map(|name| {
        let named = BOARDS.into_iter().find(|board| board.name() == name);
        named.unwrap_or_default()
    })
}

/// The boards that have a firmware of their own.
pub const BOARDS: [Model; 3] = [Model::Uno, Model::Nano, Model::Mega];

/// A build that is within its limits and has no product of the compiler's.
pub struct Firmware {
    /// `target/firmware/unoclp.elf`, of another board than the UNO `unoclp-nano.elf`.
    pub elf: PathBuf,
    /// `target/firmware/unoclp.hex`, for a boot loader.
    pub hex: PathBuf,
}

impl Firmware {
    /// Where that of this board is built.
    pub fn of(board: Model) -> Firmware {
        let folder = folder();
        let name = name(board);
        Firmware {
            elf: folder.join(format!("{name}.elf")),
            hex: folder.join(format!("{name}.hex")),
        }
    }
}

/// Sets up, builds, says where the results are, and whether they are the tested firmware.
///
/// # Errors
/// As [`build`], and if a tool is missing.
pub fn run(args: &Args) -> Result<()> {
    let toolchain = setup::for_firmware()?;
    if let Some(board) = args.board {
        let Firmware { elf, hex } = build(&toolchain, board)?;
        say(&format!("firmware: {}", elf.display()));
        say(&format!("firmware: {}", hex.display()));
        return Ok(());
    }
    let firmwares = build_all(&toolchain)?;
    for Firmware { elf, hex } in &firmwares {
        say(&format!("firmware: {}", elf.display()));
        say(&format!("firmware: {}", hex.display()));
    }
    if args.keep {
        return tested::keep(&toolchain.tools()?);
    }
    println!("{}", tested::verdict(&toolchain.tools()?)?);
    Ok(())
}

/// Builds the firmware of each board, and notes what has built it.
///
/// # Errors
/// As [`build`].
pub fn build_all(toolchain: &Toolchain) -> Result<Vec<Firmware>> {
    let firmwares = BOARDS.map(|board| build(toolchain, board));
    let firmwares = firmwares.into_iter().collect::<Result<_>>()?;
    toolchain.tools()?.note()?;
    Ok(firmwares)
}

/// Builds the firmware of a board. Where this fails, no older build is left that could be taken for it.
///
/// # Errors
/// If it does not compile, exceeds a limit of [`crate::budget::budgets`], or the compiler has made
/// a product, which may be wrong.
pub fn build(toolchain: &Toolchain, board: Model) -> Result<Firmware> {
    let firmware = Firmware::of(board);
    shell::make_folder_of(&firmware.elf)?;
    let unshortened = folder().join(format!("{}-unshortened.elf", name(board)));
    for old in [&firmware.elf, &firmware.hex, &unshortened] {
        if old.exists() {
            fs::remove_file(old).with_context(|| format!("cannot remove {}", old.display()))?;
        }
    }

    say(&format!("firmware: compiling {}", product(board)));
    let link = compile(toolchain, board)?;

    let built = if is_shortened(board) {
        say("firmware: shortening the compiler's output");
        let shortened = shortened(board);
        let rules = link::link(&link, &shortened)?;
        println!("{}", link::savings(&rules));
        shortened
    } else {
        arguments::accept(&link.assembly()?)?;
        link.result()?
    };
    let elf = fs::read(&built).with_context(|| format!("cannot read {}", built.display()))?;

    say("firmware: measuring and checking it");
    let size = Size::of(&elf)?;
    let table = size.table(board);
    println!(
        "{table}\n{}\n{}",
        parts::table(&elf)?,
        program_room(&core(board))
    );
    let exceeded = size.exceeded(board);
    ensure!(
        exceeded.is_empty(),
        "the firmware does not fit: too much {}",
        exceeded.join(" and ")
    );
    mulcheck::accept(&elf)?;

    if board != Model::Mega {
        // It does not fit the chip; the simulated one is made larger for it.
        fs::copy(link.result()?, &unshortened)
            .with_context(|| format!("cannot write {}", unshortened.display()))?;
    }
    fs::write(&firmware.elf, elf)
        .with_context(|| format!("cannot write {}", firmware.elf.display()))?;
    let mut objcopy = Command::new("avr-objcopy");
    objcopy.args(["-O", "ihex", "-R", ".eeprom"]);
    shell::run(objcopy.arg(&firmware.elf).arg(&firmware.hex))?;
    Ok(firmware)
}

/// Has the firmware compiled to assembly, and says how rustc has linked it.
fn compile(toolchain: &Toolchain, board: Model) -> Result<Link> {
    // Where cargo finds an ELF that was made with the same flags, rustc does not run, and what is printed
    // may be of a build with others.
    let results = target_folder(board).join("avr-none/firmware/deps");
    for file in fs::read_dir(&results).into_iter().flatten() {
        let path = file?.path();
        if path.extension().is_some_and(|extension| extension == "elf") {
            fs::remove_file(&path).with_context(|| format!("cannot remove {}", path.display()))?;
        }
    }
    let printed = target_folder(board).join("link-args");
    let mut rustc = cargo(toolchain, "rustc", board);
    rustc.args(["--", "--emit=asm,link"]);
    shell::run(rustc.arg(format!("--print=link-args={}", printed.display())))?;
    let text = fs::read_to_string(&printed)
        .with_context(|| format!("cannot read {}", printed.display()))?;
    Link::parse(&text)
}

/// What the compiler is told of the Mega beside what `.cargo/config.toml` tells: the last chip counts.
const MEGA: &str = "target.avr-none.rustflags = ['-Ctarget-cpu=atmega2560', '--cfg=mega']";

/// A cargo command on the firmware of a board.
pub fn cargo(toolchain: &Toolchain, subcommand: &str, board: Model) -> Command {
    let mut cargo = toolchain.cargo(subcommand);
    cargo
        // For `firmware/build.rs`.
        .env("UNOCLP_BOARD", board.name())
        .args(["--package=unoclp-firmware", "--profile=firmware"])
        .arg("--target-dir")
        .arg(target_folder(board));
    if board == Model::Mega {
        cargo.args(["--config", MEGA]);
    }
    cargo
}

/// Whether the firmware of a board is shortened: a Mega has room for it as it is.
pub fn is_shortened(board: Model) -> bool {
    board != Model::Mega
}

/// The shortened firmware of a board before it is checked, with its assembly beside it.
pub fn shortened(board: Model) -> PathBuf {
    let folder = target_folder(board).join("shortened").join(board.name());
    folder.join("unoclp.elf")
}

/// Where builds are left.
pub fn folder() -> PathBuf {
    shell::root().join("target/firmware")
}

/// What the files of a build are called.
fn name(board: Model) -> &'static str {
    match board.firmware() {
        Model::Uno => "unoclp",
        Model::Mega => "unoclp-mega",
        _ => "unoclp-nano",
    }
}

/// What it says that it is, over Modbus.
fn product(board: Model) -> &'static str {
    match board.firmware() {
        Model::Uno => map::PRODUCT,
        Model::Mega => map::MEGA,
        _ => map::NANO,
    }
}

/// The AVR build has a folder of its own: the simulator's tests may run cargo meanwhile.
fn target_folder(board: Model) -> PathBuf {
    let folder = match board {
        Model::Mega => "target/avr-mega",
        _ => "target/avr",
    };
    shell::root().join(folder)
}

/// What the core knows of a board.
fn core(board: Model) -> Board {
    Board::named(board.firmware().name()).unwrap_or(Board::UNO)
}

/// What room a program has on the board.
fn program_room(board: &Board) -> String {
    const TIMERS: usize = 16;
    let Board {
        stored_bytes,
        linked_bytes,
        ..
    } = *board;
    format!(
        "programs of up to {} codes, or {} codes and {TIMERS} timers: {} B stored, {} B in run memory",
        codes_beside(0, board),
        codes_beside(TIMERS, board),
        thousands(stored_bytes.into()),
        thousands(linked_bytes.into())
    )
}

/// How many contacts, coils and branches, of one byte each, there is room for beside so many timers
/// (NC-10).
fn codes_beside(timers: usize, board: &Board) -> usize {
    // Its code, its preset and its output.
    let (stored_bytes, linked_bytes) = (6, usize::from(board.engine.run_bytes(Opcode::OnDelay)));
    let stored = usize::from(board.stored_bytes).checked_sub(timers * stored_bytes);
    let linked = usize::from(board.linked_bytes).checked_sub(timers * linked_bytes);
    stored.min(linked).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use unoclp_core::Board;

    use super::codes_beside;

    #[test]
    fn the_smaller_of_both_memories_sets_the_limit() {
        let board = |stored_bytes, linked_bytes| Board {
            stored_bytes,
            linked_bytes,
            ..Board::UNO
        };
        // A timer takes 6 bytes stored and 11 in run memory.
        let cases = [
            (board(900, 960), 0, 900),
            (board(900, 960), 16, 960 - 16 * 11),
            (board(900, 2_000), 16, 900 - 16 * 6),
            (board(900, 11), 1, 0),
            (board(900, 10), 1, 0),
            (board(5, 2_000), 1, 0),
        ];
        for (board, timers, codes) in cases {
            assert_eq!(codes_beside(timers, &board), codes, "{board:?}, {timers}");
        }
    }

    #[test]
    fn the_uno_has_room_for_500_codes_and_16_timers() {
        assert!(codes_beside(16, &Board::UNO) >= 500);
    }
}
