//! The picture of the Mega's wiring shows each point of the board, and is as it is written.

use std::collections::BTreeSet;
use std::fs;
use unoclp_core::Board;
use xtask::shell::root;
use xtask::wiring::{PICTURE, picture, wired};

#[test]
fn each_point_has_a_pin_of_its_own() {
    let all = wired().unwrap();
    let board = Board::MEGA;
    let inputs = (1..=board.inputs).map(|n| format!("I{n}"));
    let outputs = (1..=board.outputs).map(|n| format!("Q{n}"));
    let analogue = (0..board.analogue).map(|n| format!("A{n}"));
    for name in inputs
        .chain(outputs)
        .chain(analogue)
        .chain(["STOP".to_owned()])
    {
        let pins = all.iter().filter(|one| one.name == name).count();
        assert_eq!(pins, 1, "{name}");
    }
    let pins: BTreeSet<&str> = all.iter().map(|one| &*one.pin).collect();
    assert_eq!(pins.len(), all.len(), "{all:?}");
}

#[test]
fn the_picture_is_as_it_is_written() {
    let written = fs::read_to_string(root().join(PICTURE)).unwrap_or_default();
    assert_eq!(written, picture().unwrap(), "run `cargo xtask wiring`");
}
