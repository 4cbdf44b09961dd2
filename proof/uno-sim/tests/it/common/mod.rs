//! What the tests on the firmware share.

pub mod alike;
pub mod cases;
pub mod line;
pub mod modbus;
pub mod state;

use std::path::{Path, PathBuf};
use unoclp_card::image::{Fat, Image};
use unoclp_core::Board;
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{CYCLES_PER_MS, Program, Slot, Uno, firmware_file, mega_file};

/// The firmware under test.
pub fn firmware() -> Program {
    let elf = match crate::BOARD == Board::MEGA {
        true => mega_file(),
        false => firmware_file(),
    };
    let elf = elf.unwrap_or_else(|error| panic!("{error}"));
    Program::read(&elf).unwrap_or_else(|error| panic!("{error}"))
}

/// Where in the EEPROM of the board that stands which stands here on a UNO, after the program: there is more room for one.
pub fn place(on_uno: u16) -> u16 {
    on_uno + crate::BOARD.stored_bytes - Board::UNO.stored_bytes
}

/// All scenario files in these folders of the project, in order.
pub fn scenarios(folders: &[&str]) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .nth(2)
        .unwrap();
    let mut files = Vec::new();
    for folder in folders {
        let before = files.len();
        collect(&root.join(folder), &mut files);
        assert!(files.len() > before, "no scenarios in {folder}");
    }
    files.sort();
    files
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.ends_with("programs/plants") || path.ends_with("exercises/machines") {
            // Machines, and what controls them.
            continue;
        }
        if path.is_dir() {
            collect(&path, files);
        } else if path
            .extension()
            .is_some_and(|extension| extension == "toml")
        {
            files.push(path);
        }
    }
}

/// A card with this file as its program.
pub fn card(text: &str) -> SdCard {
    let image = Image::new(Fat::Fat16)
        .file("PROGRAM.TXT", text)
        .build()
        .unwrap();
    SdCard::new(Kind::Sdhc, image).unwrap()
}

/// A card with a volume and no program on it.
pub fn empty_card() -> SdCard {
    let image = Image::new(Fat::Fat16).build().unwrap();
    SdCard::new(Kind::Sdhc, image).unwrap()
}

/// A board with this in its slot, just powered.
pub fn uno(slot: Slot) -> Uno {
    Uno::with_program(firmware(), slot).unwrap()
}

/// Runs until the serial port has said one of these; gives the time in ms, and forgets what the
/// port said.
pub fn ms_until(uno: &mut Uno, texts: &[&str]) -> (u64, String) {
    let begun = uno.cycles();
    // Each byte of a program takes a while to be kept.
    for _ in 0..9 * u32::from(crate::BOARD.stored_bytes) {
        uno.run_ms(1).unwrap();
        if texts.iter().any(|text| uno.serial().contains(text)) {
            let said = String::from_utf8(uno.take_serial()).unwrap();
            return ((uno.cycles() - begun) / CYCLES_PER_MS, said);
        }
    }
    panic!(
        "none of {texts:?} came; the serial port said {:?}",
        uno.serial()
    );
}

/// Runs to the first scan; gives what the serial port said until then.
pub fn to_run(uno: &mut Uno) -> String {
    ms_until(uno, &["RUN\r\n"]).1
}

/// Runs to a fault, or to the first scan.
pub fn to_run_or_fault(uno: &mut Uno) -> String {
    let said = ms_until(uno, &["RUN\r\n", "\r\nfault "]).1;
    // The rest of a fault's line.
    uno.run_ms(15).unwrap();
    said + std::str::from_utf8(&uno.take_serial()).unwrap()
}
