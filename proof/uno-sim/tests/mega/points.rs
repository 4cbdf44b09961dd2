//! The points of the Mega 2560, of its firmware on simavr and on avr8js.

use crate::common::alike::{Counts, alike};
use crate::common::firmware;
use unoclp_checked::Checked;
use unoclp_core::{Board, Inputs};
use unoclp_host_sim::engine::{Engine, HostEngine, Refusal};
use unoclp_host_sim::random::{Random, random_program_on};
use unoclp_testing::{held, rounds};
use unoclp_uno_sim::Uno;
use unoclp_uno_sim::avr8js::Avr8js;
use unoclp_uno_sim::engine::{Clock, EngineError, FirmwareEngine, Simulated, UnoEngine};

const PROGRAMS: u32 = 600;
const LEAST_PROGRAMS: u32 = 150;
const SEED: u64 = 0x2560;

/// Random programs up to full size, with all of its points, on the core and on the firmware.
#[test]
fn random_programs_behave_alike_on_a_mega() {
    // Its EEPROM takes seconds for a program of full size.
    compare::<Uno>(|mega, _, checked| mega.start_kept(checked.program()));
}

/// The same on avr8js, which the page runs the firmware on.
#[test]
fn random_programs_behave_alike_on_a_mega_on_avr8js() {
    compare::<Avr8js>(|mega, text, _| mega.load(text.as_bytes()));
}

type Started = Result<Result<(), Refusal>, EngineError>;

fn compare<S: Simulated>(start: fn(&mut FirmwareEngine<S>, &str, &Checked) -> Started) {
    let seed = std::env::var("UNOCLP_SEED").map_or(SEED, |seed| seed.parse().expect("a number"));
    let mut mega = FirmwareEngine::<S>::new(firmware(), Clock::Lockstep).unwrap();
    let (mut all, mut longest) = (Counts::default(), 0);
    let programs = rounds(PROGRAMS).max(LEAST_PROGRAMS);
    let mut run = |n: u32| {
        let seed = seed.wrapping_add(n.into());
        let random = &mut Random::new(seed);
        let text = random_program_on(random, Board::MEGA);
        let mut host = HostEngine::new(Board::MEGA);
        let Ok(accepted) = host.load(text.as_bytes());
        assert_eq!(accepted, Ok(()), "seed {seed} on the host:\n{text}");
        let checked = Checked::read(text.as_bytes(), Board::MEGA).unwrap();
        longest = longest.max(checked.program().stored_bytes());
        let started = start(&mut mega, &text, &checked);
        let started = started.unwrap_or_else(|e| panic!("seed {seed}: {e}\n{text}"));
        assert_eq!(started, Ok(()), "seed {seed} on the firmware:\n{text}");
        let counts = alike(&mut mega, &mut host, random, seed, &text);
        all.scans += counts.scans;
        all.changes += counts.changes;
        all.faults += counts.faults;
    };
    (0..programs).for_each(|n| held(|| run(n)));
    let Counts {
        scans,
        changes,
        faults,
    } = all;
    println!(
        "{programs} random programs, {scans} scans alike, {changes} changes, {faults} faults, {longest} B the longest; seeds from {seed}"
    );
    assert!(changes > scans / 20, "{changes}");
    assert!(
        longest > usize::from(Board::MEGA.stored_bytes) * 3 / 4,
        "{longest}"
    );
}

/// Each input alone is seen by each kind of contact, and each output is driven, read, set and reset alone.
#[test]
fn each_point_has_its_pin() {
    let mut mega = UnoEngine::new(firmware(), Clock::Lockstep).unwrap();
    let (inputs, outputs) = (Board::MEGA.inputs, Board::MEGA.outputs);
    let mut told = Vec::new();
    for first in (0..outputs).step_by(8) {
        // Output n follows input n, and the inputs after those in turn.
        for shift in [0, 8, 16] {
            let input = |output: u8| (output + shift) % inputs;
            let rungs: String = (first..first + 8)
                .map(|output| {
                    format!(
                        "787600\n8273{:02}\n8779{:02}\n",
                        input(output) + 1,
                        output + 1
                    )
                })
                .collect();
            let text = format!("0\n{rungs}");
            let checked = Checked::read(text.as_bytes(), Board::MEGA).unwrap();
            assert_eq!(
                mega.start_kept(checked.program()).unwrap(),
                Ok(()),
                "{text}"
            );
            let mut now = 0;
            for on in 0..inputs {
                let mut pins = Inputs::default();
                pins.points.0 = 1 << on;
                now += 1;
                let came = mega.scan(&pins, now).unwrap().unwrap();
                let expected: u128 = (first..first + 8)
                    .filter(|&output| input(output) == on)
                    .map(|output| 1 << output)
                    .sum();
                if came.0 != expected {
                    told.push(format!(
                        "input {}: {:#x}, not {expected:#x}",
                        on + 1,
                        came.0
                    ));
                }
            }
        }
    }
    assert_eq!(told, [""; 0]);
}
