//! How fast a Mega is: what `cargo xtask bench` measures, held to its targets.

use crate::common::firmware;

#[path = "../../src/bin/bench/mega.rs"]
#[allow(dead_code, reason = "the page has them in one piece")]
mod measured;

use measured::{LARGE, RUNGS, SMALL, START};

#[test]
fn a_rung_of_four_contacts_and_a_coil() {
    let firmware = firmware();
    for (inputs, output, most) in RUNGS {
        let cycles = measured::rung(&firmware, inputs, output).unwrap();
        let rung = format!("inputs {inputs:?}, output {output}: {cycles} cycles");
        assert!(cycles <= most, "{rung}");
    }
}

#[test]
fn a_whole_scan_of_500_such_rungs() {
    let cycles = measured::large(&firmware()).unwrap();
    assert!(cycles <= LARGE, "{cycles}");
}

#[test]
fn a_program_of_full_size_runs_within_a_second() {
    let ms = measured::start(&firmware()).unwrap();
    assert!(ms <= START, "{ms}");
}

/// All inputs are read and all outputs are written in it.
#[test]
fn a_small_scan() {
    let cycles = measured::small(&firmware()).unwrap();
    assert!(cycles <= SMALL, "{cycles}");
}
