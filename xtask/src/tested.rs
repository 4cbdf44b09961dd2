//! The tested firmware: the files in `firmware/` that users write to their boards.
//!
//! The suite has run on this firmware and on no other. So the symbols of each file stand beside it, for the suite to run
//! on the very file, and the sums of all; a test builds it again, and `cargo xtask firmware` says where the result is
//! another.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};
use sha2::{Digest, Sha256};
use unoclp_boot::Model;

use crate::firmware::{self, BOARDS, Firmware};
use crate::shell::{self, say};
use crate::toolset::{Pinned, Tools};

/// The tested firmware of a board: `firmware/unoclp-uno.hex`.
pub fn hex(board: Model) -> PathBuf {
    folder().join(name(board)).with_extension(HEX)
}

const HEX: &str = "hex";
const SYMBOLS: &str = "symbols";

fn folder() -> PathBuf {
    shell::root().join("firmware")
}

fn name(board: Model) -> String {
    format!("unoclp-{}", board.firmware().name())
}

/// Copies what was built into a folder, under the names of the tested firmware: of each board the file for its boot
/// loader and the symbols, and the sums of all in the form of `sha256sum`. Gives the names.
///
/// # Errors
/// If a file cannot be read or written.
pub fn copy_build(to: &Path) -> Result<Vec<String>> {
    let (mut names, mut sums) = (Vec::new(), String::new());
    for board in BOARDS {
        let built = Firmware::of(board);
        let hex = fs::read(&built.hex);
        let hex = hex.with_context(|| format!("cannot read {}", built.hex.display()))?;
        let symbols = symbols(&built.elf)?.into_bytes();
        for (bytes, form) in [(hex, HEX), (symbols, SYMBOLS)] {
            let name = format!("{}.{form}", name(board));
            sums += &format!("{:x}  {name}\n", Sha256::digest(&bytes));
            write(&to.join(&name), &bytes)?;
            names.push(name);
        }
    }
    write(&to.join(SUMS), sums.as_bytes())?;
    names.push(SUMS.to_owned());
    Ok(names)
}

const SUMS: &str = "SHA256SUMS";

fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    fs::write(path, bytes).with_context(|| format!("cannot write {}", path.display()))
}

/// What has an address in a build, as `avr-nm -S` prints it.
fn symbols(elf: &Path) -> Result<String> {
    let printed = shell::output(Command::new("avr-nm").arg("-S").arg(elf));
    let printed = printed.with_context(|| format!("avr-nm cannot read {}", elf.display()))?;
    let is_placed = |line: &&str| !line.contains(" a ") && !line.contains(" N ");
    let lines = printed.lines().filter(is_placed);
    Ok(lines.map(|line| format!("{line}\n")).collect())
}

/// Takes what was just built for the tested firmware.
///
/// # Errors
/// If a file cannot be written.
pub fn keep(tools: &Tools) -> Result<()> {
    for name in copy_build(&folder())? {
        say(&format!(
            "firmware: stored as {}",
            folder().join(name).display()
        ));
    }
    tools.pin()
}

/// The names of the files in which what was just built is another than the tested firmware.
///
/// # Errors
/// If a file cannot be read or written.
pub fn unlike() -> Result<Vec<String>> {
    let built = firmware::folder().join("as-tested");
    fs::create_dir_all(&built).with_context(|| format!("cannot create {}", built.display()))?;
    let mut names = copy_build(&built)?;
    names.retain(|name| fs::read(built.join(name)).ok() != fs::read(folder().join(name)).ok());
    Ok(names)
}

/// How what was just built compares with the tested firmware, in a sentence.
///
/// # Errors
/// If there is no tested firmware.
pub fn verdict(here: &Tools) -> Result<String> {
    let pinned = Pinned::read()?.tools;
    Ok(sentence(unlike()?.is_empty(), here, &pinned))
}

fn sentence(is_same: bool, here: &Tools, pinned: &Tools) -> String {
    match (is_same, here == pinned) {
        (true, _) => "this is the tested firmware, byte for byte".to_owned(),
        (false, true) => {
            "untested: this is not the tested firmware, since the source has changed. When all other \
             tests of `cargo xtask test` pass, `cargo xtask firmware --keep` makes it the tested one"
                .to_owned()
        }
        (false, false) => format!(
            "untested: these tools are not the pinned ones, and the suite has not run on their output.\n{}\
             `cargo xtask flash` writes the tested firmware; `cargo xtask test --kept` runs the suite on it",
            pinned.difference(here)
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::sentence;
    use crate::toolset::{Pinned, Tools};

    #[test]
    fn other_tools_are_told_where_they_make_another_firmware() {
        let pinned = Pinned::read().unwrap().tools;
        let other: Tools = {
            let text = toml::to_string(&pinned).unwrap();
            toml::from_str(&text.replace("avr-gcc (GCC) 5.4.0", "avr-gcc (GCC) 14.1.0")).unwrap()
        };
        let told = sentence(false, &other, &pinned);
        assert!(told.starts_with("untested"), "{told}");
        assert!(told.contains("avr-gcc (GCC) 14.1.0"), "{told}");
        assert!(!told.contains("avr-as"), "{told}");
        assert!(sentence(false, &pinned, &pinned).contains("--keep"));
        for here in [&pinned, &other] {
            let told = sentence(true, here, &pinned);
            assert_eq!(told, "this is the tested firmware, byte for byte");
        }
    }
}
