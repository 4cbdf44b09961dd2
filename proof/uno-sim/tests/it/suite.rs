//! Every scenario of the project on the firmware.

use crate::common;
use crate::common::cases::{Of, every_scenario, first_fault};
use std::ffi::OsStr;
use unoclp_boot::{Image, Model};
use unoclp_core::{Board, Millis};
use unoclp_exercise::scenario::check;
use unoclp_host_sim::engine::{Engine, Refusal};
use unoclp_uno_sim::avr8js::Avr8js;
use unoclp_uno_sim::engine::{Clock, FirmwareEngine, Simulated};
use unoclp_uno_sim::{Program, Slot, Uno, firmware_file, nano_file, unshortened_file};

fn run_all<S: Simulated>(
    firmware: Program,
    clock: Clock,
    folders: &[&str],
    longest: Millis,
    of: Of,
) {
    let mut engine = FirmwareEngine::<S>::new(firmware, clock).unwrap();
    let (mut passed, mut failed) = (0, Vec::new());
    for (path, scenario) in every_scenario(folders, of) {
        let running = clock == Clock::Running;
        // Listings of a course: some hold only if the inputs are what they say from the very first scan. Exercises are
        // many and take seconds each; what they show beside the others is no matter of the clock.
        let left_out = ["il", "exercises"];
        let is_left_out = |name: &OsStr| left_out.iter().any(|one| name == *one);
        let is_left_out = path.components().any(|part| is_left_out(part.as_os_str()));
        if scenario.duration() > longest || running && (scenario.is_for_lockstep() || is_left_out) {
            continue;
        }
        let report = check(&scenario, &mut engine);
        if report.passed() {
            passed += 1;
        } else {
            failed.push(report.to_string());
        }
    }
    println!(
        "{clock:?}: {passed} scenarios passed, {} failed",
        failed.len()
    );
    assert!(failed.is_empty(), "{}", failed.join("\n\n"));
    assert!(passed > 0);
}

/// NC-1 … NC-19, each scan with the time stamp that the scenario says.
#[test]
fn every_scenario_in_lockstep() {
    let firmware = common::firmware();
    run_all::<Uno>(
        firmware,
        Clock::Lockstep,
        &["programs", "proof/suite"],
        Millis::MAX,
        Of::Each,
    );
}

/// The same on avr8js, which the lab's page runs the firmware on.
#[test]
fn every_scenario_in_lockstep_on_avr8js() {
    let firmware = common::firmware();
    run_all::<Avr8js>(
        firmware,
        Clock::Lockstep,
        &["programs", "proof/suite"],
        Millis::MAX,
        Of::First,
    );
}

/// What is flashed, and what the lab's page runs, is what the suite ran on.
#[test]
fn the_hex_holds_the_firmware_of_the_suite() {
    let elf = firmware_file().unwrap();
    let hex = std::fs::read(elf.with_extension("hex")).unwrap();
    let hex = Image::read(&hex, Model::Uno).unwrap();
    let uno = Uno::with_program(common::firmware(), Slot::Empty).unwrap();
    let length = common::firmware().flash_bytes();
    assert_eq!(hex.bytes(), uno.read_flash(0, length).unwrap());
}

/// The same on the firmware before its assembly is shortened: a scenario that fails in the other test alone
/// is the pass's fault, one that fails in both is not.
#[test]
fn every_scenario_in_lockstep_before_the_firmware_is_shortened() {
    let firmware = Program::read_enlarged(&unshortened_file().unwrap()).unwrap();
    assert!(firmware.flash_bytes() > common::firmware().flash_bytes());
    run_all::<Uno>(
        firmware,
        Clock::Lockstep,
        &["programs", "proof/suite"],
        Millis::MAX,
        Of::First,
    );
}

/// The same on the firmware of Nanos: what it has runs as on the UNO, and what it does not have it refuses in the line in
/// which a PC does.
#[test]
fn every_scenario_in_lockstep_on_a_nano() {
    let firmware = Program::read(&nano_file().unwrap()).unwrap();
    let mut engine = FirmwareEngine::<Uno>::new(firmware, Clock::Lockstep).unwrap();
    let (mut passed, mut refused, mut failed) = (0, 0, Vec::new());
    for (path, scenario) in every_scenario(&["programs", "proof/suite"], Of::First) {
        let program = &scenario.program().bytes;
        match (
            first_fault(program, Board::UNO),
            first_fault(program, Board::NANO),
        ) {
            (uno, nano) if uno == nano => {
                let report = check(&scenario, &mut engine);
                match report.passed() {
                    true => passed += 1,
                    false => failed.push(report.to_string()),
                }
            }
            (_, nano) => {
                let told = engine.load(program).unwrap().err();
                assert_eq!(told, nano.map(Refusal::from), "{}", path.display());
                refused += 1;
            }
        }
    }
    println!(
        "{passed} scenarios passed, {refused} need REAL, {} failed",
        failed.len()
    );
    assert!(failed.is_empty(), "{}", failed.join("\n\n"));
    assert!(passed > 10 * refused && refused > 5);
}

/// The samples and the timers with the board's own clock, which the timer interrupt drives: exact
/// to one millisecond, however many scans go into it. Longer ones than 40 s are left to the other
/// test, where time costs nothing.
#[test]
fn programs_and_timers_on_the_running_clock() {
    let firmware = common::firmware();
    run_all::<Uno>(
        firmware,
        Clock::Running,
        &["programs", "proof/suite/timers"],
        40_000,
        Of::First,
    );
}
