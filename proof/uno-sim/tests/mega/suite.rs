//! Every scenario of the project on the firmware of the Mega: what the UNO has too runs as there.

use crate::BOARD;
use crate::common::cases::{Of, every_scenario, first_fault, is_of_mega};
use crate::common::firmware;
use unoclp_core::Board;
use unoclp_exercise::scenario::check;
use unoclp_host_sim::engine::{Engine, HostEngine, Refusal};
use unoclp_uno_sim::Uno;
use unoclp_uno_sim::avr8js::Avr8js;
use unoclp_uno_sim::engine::{Clock, FirmwareEngine, Simulated};

/// What scenarios say of the UNO alone: there inputs 05 to 08 read as 0 where no code names them.
const OF_AN_UNO: [&str; 2] = ["load-inputs.toml", "load-inputs-named.toml"];

/// Where a program is too much for a UNO and not for a Mega, or asks for a point that only this has, it is accepted as the
/// core accepts it.
#[test]
fn every_scenario_in_lockstep() {
    run_all::<Uno>(Of::Each);
}

/// The same on avr8js, which the page runs the firmware on.
#[test]
fn every_scenario_in_lockstep_on_avr8js() {
    run_all::<Avr8js>(Of::First);
}

fn run_all<S: Simulated>(of: Of) {
    let mut mega = FirmwareEngine::<S>::new(firmware(), Clock::Lockstep).unwrap();
    let (mut passed, mut other, mut failed) = (0, 0, Vec::new());
    for (path, scenario) in every_scenario(&["programs", "proof/suite"], of) {
        let program = &scenario.program().bytes;
        let [uno, here] = [Board::UNO, BOARD].map(|board| first_fault(program, board));
        if uno != here && !is_of_mega(&path) {
            let told = mega.load(program).unwrap().err();
            assert_eq!(told, here.map(Refusal::from), "{}", path.display());
            other += 1;
            continue;
        }
        let report = check(&scenario, &mut mega);
        if report.passed() {
            passed += 1;
            continue;
        }
        let core = check(&scenario, &mut HostEngine::new(BOARD));
        let is_of_an_uno = OF_AN_UNO.iter().any(|name| path.ends_with(name));
        if is_of_an_uno && core.to_string() == report.to_string() {
            other += 1;
        } else {
            failed.push(report.to_string());
        }
    }
    println!(
        "{passed} scenarios passed, {other} are of a UNO, {} failed",
        failed.len()
    );
    assert!(failed.is_empty(), "{}", failed.join("\n\n"));
    assert!(passed > 10 * other && other > 0);
}
