//! The programs that stand in several languages, in each of them on the firmware.

use crate::common;
use std::fs;
use std::path::Path;
use unoclp_core::Board;
use unoclp_exercise::scenario::{ProgramFile, Scenario, check};
use unoclp_program::Written;
use unoclp_testing::in_languages;
use unoclp_uno_sim::engine::{Clock, UnoEngine};

#[test]
fn every_language_passes_the_scenario() {
    let mut engine = UnoEngine::new(common::firmware(), Clock::Lockstep).unwrap();
    for twins in in_languages() {
        for text in twins.texts() {
            let name = text.display().to_string();
            let source =
                Written::new(name.clone(), fs::read(&text).unwrap(), Board::UNO).check(None);
            let program = ProgramFile {
                name: name.clone(),
                bytes: source.unwrap_or_else(|refused| panic!("{refused:?}")).code,
            };
            let scenario = Scenario::load_for(&twins.scenario(), program, Board::UNO);
            let report = check(&scenario.unwrap(), &mut engine);
            assert!(report.passed(), "{name}: {report}");
        }
    }
}

/// The example of a language that unoclp does not bring.
#[test]
fn a_language_from_elsewhere_passes_its_scenario() {
    unoclp_lang::register(&unoclp_when::WHEN);
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/when/motor.toml");
    let scenario = Scenario::load(&file, Board::UNO).unwrap();
    let mut engine = UnoEngine::new(common::firmware(), Clock::Lockstep).unwrap();
    let report = check(&scenario, &mut engine);
    assert!(report.passed(), "{report}");
}
