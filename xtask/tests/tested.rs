//! The tested firmware in `firmware/` is what this tree builds. It needs what `cargo xtask firmware` leaves: `cargo
//! xtask test` runs it.

use std::fs;

use unoclp_boot::{Image, Model};
use xtask::tested;
use xtask::toolset::{Pinned, Tools};

#[test]
fn the_pinned_tools_have_built_what_the_suite_runs_on() {
    let (pinned, here) = (Pinned::read().unwrap().tools, Tools::of_build().unwrap());
    assert!(
        here == pinned,
        "untested: target/firmware was not built by the tools of firmware/tools.toml:\n{}\
         `cargo xtask test --kept` runs the suite on the tested firmware. To test what these tools build, pin them: \
         cargo xtask firmware --keep",
        pinned.difference(&here)
    );
}

#[test]
fn the_files_are_what_this_tree_builds() {
    let unlike = tested::unlike().unwrap();
    assert!(
        unlike.is_empty(),
        "firmware/ is not what this tree builds: {}; once all else passes: cargo xtask firmware --keep",
        unlike.join(", ")
    );
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
