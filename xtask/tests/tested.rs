//! The tested firmware in `firmware/` is what this tree builds. It needs what `cargo xtask firmware` leaves: `cargo
//! xtask test` runs it.

use std::fs;

use unoclp_boot::{Image, Model};
use xtask::firmware::{BOARDS, Firmware};
use xtask::tested::{self, Compiler};

#[test]
fn the_sums_are_those_of_the_files() {
    let (compiler, kept) = tested::kept().unwrap();
    assert_eq!(tested::text(&compiler, tested::hex).unwrap(), kept);
}

#[test]
fn the_files_are_what_this_tree_builds() {
    let (tested, _) = tested::kept().unwrap();
    let here = Compiler::of_build().unwrap();
    if here != tested {
        // The sums and the boards hold on every machine; the bytes on one with the compiler that is named.
        println!("not compared: built by {here}, tested with {tested}");
        return;
    }
    for board in BOARDS {
        let (built, kept) = (Firmware::of(board).hex, tested::hex(board));
        assert!(
            fs::read(&built).unwrap() == fs::read(&kept).unwrap(),
            "{} is not what this tree builds; once all else passes: cargo xtask firmware --keep",
            kept.display()
        );
    }
}

#[test]
fn each_file_fits_the_boards_that_take_it() {
    for board in Model::ALL {
        let file = fs::read(tested::hex(board)).unwrap();
        let image =
            Image::read(&file, board).unwrap_or_else(|unfit| panic!("{board:?}: {unfit:?}"));
        assert!(image.bytes().len() > 20_000);
    }
}

#[test]
fn the_firmware_of_the_uno_does_not_fit_a_nano() {
    let file = fs::read(tested::hex(Model::Uno)).unwrap();
    assert!(Image::read(&file, Model::Nano).is_err());
}
