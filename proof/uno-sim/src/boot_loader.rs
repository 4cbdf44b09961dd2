//! A board as it comes out of its box: its boot loader, and a sketch that does nothing.
//!
//! The boot loaders come with Debian's Arduino core. That core's own Optiboot for this chip is larger than the 512 bytes
//! that the fuses of a UNO leave it: its compiler unrolls more than Arduino's did. So its source is compiled here with
//! what makes it fit.

use crate::{Chip, Error, Program};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

const CORE: &str = "/usr/share/arduino/hardware/arduino/avr/bootloaders";

/// `nop` and `rjmp .-4`.
const SKETCH: [u16; 2] = [0x0000, 0xCFFE];

/// What makes Optiboot fit; the last two spare 32 bytes.
const OPTIBOOT: &str = "-mmcu=atmega328p -DF_CPU=16000000L -w -DLED_START_FLASHES=3 -DBAUD_RATE=115200 -Os -mrelax \
    -fno-inline-small-functions -fno-split-wide-types -nostartfiles -nostdlib -Wl,--relax \
    -Wl,--section-start=.text=0x7e00 -Wl,--section-start=.version=0x7ffe \
    -fno-tree-scev-cprop -fno-move-loop-invariants";
const HEX: &str = "-O ihex -j .text -j .version --set-section-flags .version=alloc,load";

/// The boot loader of a board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BootLoader {
    /// That of UNOs and newer Nanos.
    Optiboot,
    /// The one that Nanos had before.
    Old,
    /// That of Megas.
    Mega,
}

impl BootLoader {
    /// Bits per second that it speaks.
    pub const fn rate(self) -> u32 {
        match self {
            BootLoader::Optiboot | BootLoader::Mega => 115_200,
            BootLoader::Old => 57_600,
        }
    }

    /// The chip of a board that has it.
    ///
    /// # Errors
    /// Where it cannot be built or read.
    pub fn program(self) -> Result<Program, Error> {
        match self {
            BootLoader::Optiboot => Program::boot_loader(Chip::Atmega328p, &optiboot()?, &SKETCH),
            BootLoader::Old => {
                let hex = Path::new(CORE).join("atmega/ATmegaBOOT_168_atmega328.hex");
                Program::boot_loader(Chip::Atmega328p, &hex, &SKETCH)
            }
            BootLoader::Mega => {
                let hex = Path::new(CORE).join("stk500v2/stk500boot_v2_mega2560.hex");
                Program::boot_loader(Chip::Atmega2560, &hex, &SKETCH)
            }
        }
    }
}

/// Optiboot as a file in Intel HEX, built once for this process.
fn optiboot() -> Result<PathBuf, Error> {
    static BUILT: OnceLock<Result<PathBuf, String>> = OnceLock::new();
    let built = BUILT.get_or_init(build).clone();
    built.map_err(Error::NoBootLoader)
}

fn build() -> Result<PathBuf, String> {
    let name = format!("unoclp-optiboot-{}.elf", std::process::id());
    let elf = std::env::temp_dir().join(name);
    let hex = elf.with_extension("hex");
    let mut gcc = Command::new("avr-gcc");
    gcc.args(OPTIBOOT.split_whitespace());
    gcc.arg(Path::new(CORE).join("optiboot/optiboot.c"));
    run(gcc.arg("-o").arg(&elf))?;
    let mut objcopy = Command::new("avr-objcopy");
    run(objcopy.args(HEX.split_whitespace()).arg(&elf).arg(&hex))?;
    let _ = std::fs::remove_file(&elf);
    Ok(hex)
}

fn run(command: &mut Command) -> Result<(), String> {
    let name = command.get_program().display().to_string();
    let output = command
        .output()
        .map_err(|error| format!("{name}: {error}"))?;
    match output.status.success() {
        true => Ok(()),
        false => Err(format!(
            "{name}: {}",
            String::from_utf8_lossy(&output.stderr)
        )),
    }
}
