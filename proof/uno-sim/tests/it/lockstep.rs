//! Random programs on the core and on the firmware, compared after every scan.

use crate::common;
use crate::common::alike::alike;
use unoclp_checked::numeric;
use unoclp_core::Board;
use unoclp_host_sim::engine::{Engine, HostEngine};
use unoclp_host_sim::random::{Random, random_program};
use unoclp_testing::{held, rounds};
use unoclp_uno_sim::Uno;
use unoclp_uno_sim::avr8js::Avr8js;
use unoclp_uno_sim::engine::{Clock, FirmwareEngine, Simulated};
use unoclp_uno_sim::{Program, nano_file};

const PROGRAMS: u32 = 600;
/// As many as a quick run takes too: of fewer, chance decides how much they do.
const LEAST_PROGRAMS: u32 = 150;
/// Set `UNOCLP_SEED` to repeat a run, or to make another one.
const SEED: u64 = 0x0C19;

#[test]
fn random_programs_behave_alike() {
    compare::<Uno>(common::firmware(), Board::UNO, 20);
}

/// The same programs on avr8js, which the lab's page runs the firmware on.
#[test]
fn random_programs_behave_alike_on_avr8js() {
    compare::<Avr8js>(common::firmware(), Board::UNO, 20);
}

/// Of the programs that it takes; the others it refuses. Those are the longest, and the rest do less.
#[test]
fn random_programs_behave_alike_on_a_nano() {
    let firmware = Program::read(&nano_file().unwrap()).unwrap();
    compare::<Uno>(firmware, Board::NANO, 50);
}

/// In one of `few` scans at least something must change.
fn compare<S: Simulated>(firmware: Program, board: Board, few: u64) {
    let seed = std::env::var("UNOCLP_SEED").map_or(SEED, |seed| seed.parse().expect("a number"));
    let mut uno = FirmwareEngine::<S>::new(firmware, Clock::Lockstep).unwrap();
    let (mut scans, mut changes, mut faults, mut refused) = (0u64, 0u64, 0u64, 0u32);
    let programs = rounds(PROGRAMS).max(LEAST_PROGRAMS);
    let mut run = |n: u32| {
        let seed = seed.wrapping_add(n.into());
        let random = &mut Random::new(seed);
        let program = random_program(random);
        let mut host = HostEngine::new(unoclp_core::Board::UNO);
        let Ok(accepted) = host.load(program.as_bytes());
        assert_eq!(accepted, Ok(()), "seed {seed} on the host:\n{program}");
        let accepted = uno
            .load(program.as_bytes())
            .unwrap_or_else(|e| panic!("seed {seed}: {e}"));
        if let Err(fault) = numeric(program.as_bytes(), board) {
            let first = fault.first().map(|first| Err(first.fault.into()));
            assert_eq!(Some(accepted), first, "seed {seed}:\n{program}");
            refused += 1;
            return;
        }
        assert_eq!(accepted, Ok(()), "seed {seed} on the firmware:\n{program}");

        let counts = alike(&mut uno, &mut host, random, seed, &program);
        scans += counts.scans;
        changes += counts.changes;
        faults += counts.faults;
    };
    (0..programs).for_each(|n| held(|| run(n)));
    println!(
        "{programs} random programs, {refused} refused, {scans} scans alike, {changes} changes of outputs or of memory, {faults} faults; seeds from {seed}"
    );
    assert!(
        refused < programs / 2,
        "{refused} of {programs} were refused"
    );
    assert!(
        changes > scans / few,
        "the programs do too little to be compared: {changes}"
    );
}
