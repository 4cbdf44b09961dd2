//! Where the firmware lies that is to be simulated, and how its file is read.

use crate::chip::FLASH_LEN;
use crate::program::{ENLARGED_FLASH_LEN, Program};
use crate::{Error, elf, hex};
use std::path::{Path, PathBuf};

/// The firmware of the UNO: the file that the environment variable `UNOCLP_FIRMWARE` names where it is set, an ELF file
/// or one in Intel HEX with its symbols beside it; else `target/firmware/unoclp.elf` in the workspace, where `cargo
/// xtask firmware` leaves it.
///
/// # Errors
/// [`Error::NoFirmware`] where there is no such file.
pub fn firmware_file() -> Result<PathBuf, Error> {
    existing(match std::env::var_os("UNOCLP_FIRMWARE") {
        Some(path) => PathBuf::from(path),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/firmware/unoclp.elf"),
    })
}

/// The firmware as the compiler made it, for [`Program::read_enlarged`]: it stands beside
/// [`firmware_file`].
///
/// # Errors
/// [`Error::NoFirmware`] where there is no such file.
pub fn unshortened_file() -> Result<PathBuf, Error> {
    beside("unoclp-unshortened")
}

/// The firmware of Nanos: it stands beside [`firmware_file`].
///
/// # Errors
/// [`Error::NoFirmware`] where there is no such file.
pub fn nano_file() -> Result<PathBuf, Error> {
    beside("unoclp-nano")
}

/// The firmware of the Mega: it stands beside [`firmware_file`].
///
/// # Errors
/// [`Error::NoFirmware`] where there is no such file.
pub fn mega_file() -> Result<PathBuf, Error> {
    beside("unoclp-mega")
}

/// A file of this name and of the form of [`firmware_file`].
fn beside(name: &str) -> Result<PathBuf, Error> {
    let uno = firmware_file()?;
    let form = uno.extension().unwrap_or_default();
    existing(uno.with_file_name(name).with_extension(form))
}

fn existing(path: PathBuf) -> Result<PathBuf, Error> {
    match path.is_file() {
        true => Ok(path),
        false => Err(Error::NoFirmware(path)),
    }
}

impl Program {
    /// Reads a program from an ELF file, or from a file in Intel HEX with its symbols beside it: `unoclp-uno.symbols`
    /// beside `unoclp-uno.hex`, as `avr-nm -S` prints them.
    ///
    /// # Errors
    /// Where a file cannot be read, is of another form or for another chip, or does not fit into this one.
    pub fn read(path: &Path) -> Result<Program, Error> {
        match path.extension().is_some_and(|end| end == "hex") {
            true => hex::read(path),
            false => elf::read(path, FLASH_LEN),
        }
    }

    /// Reads an ELF file for a chip that has all that an ATmega328P has, and [`ENLARGED_FLASH_LEN`] of flash:
    /// the firmware before it is shortened does not fit the real one.
    ///
    /// # Errors
    /// As [`Program::read`].
    pub fn read_enlarged(path: &Path) -> Result<Program, Error> {
        elf::read(path, ENLARGED_FLASH_LEN)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Chip, Slot, Uno};

    /// A file in Intel HEX does not say for which chip it is; its symbols do.
    #[test]
    fn the_tested_firmware_of_each_board_is_read_for_its_chip() {
        let firmware = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../firmware");
        for (name, chip) in [
            ("uno", Chip::Atmega328p),
            ("nano", Chip::Atmega328p),
            ("mega", Chip::Atmega2560),
        ] {
            let hex = firmware.join(format!("unoclp-{name}.hex"));
            let program = Program::read(&hex).unwrap();
            assert_eq!(program.chip(), chip, "{name}");
            let mut uno = Uno::with_program(program, Slot::Empty).unwrap();
            uno.run_ms(1_000).unwrap();
            let said = uno.serial();
            assert!(said.contains("unoclp 0."), "{name}: {said}");
        }
    }

    #[test]
    fn only_an_elf_file_for_avr_is_taken() {
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        let read = |path: &Path| Program::read(path).map(drop);
        assert!(matches!(
            read(&here.join("missing.elf")),
            Err(Error::Read { .. })
        ));
        assert!(matches!(
            read(&here.join("Cargo.toml")),
            Err(Error::Elf { .. })
        ));
        let own = std::env::current_exe().expect("the test runs from a file");
        assert!(matches!(
            read(&own),
            Err(Error::Elf { .. } | Error::NotForThisChip { .. })
        ));
    }
}
