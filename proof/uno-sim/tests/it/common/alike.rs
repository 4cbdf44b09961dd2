//! A program that the core and the firmware have loaded, compared after every scan.

use unoclp_core::isa::REGISTERS;
use unoclp_core::{Image, Inputs};
use unoclp_host_sim::engine::{Cell, Engine, HostEngine};
use unoclp_host_sim::random::{Random, random_inputs_on};
use unoclp_uno_sim::engine::{FirmwareEngine, Simulated};

const SCANS: u32 = 120;

/// What a program has done.
#[derive(Default)]
pub struct Counts {
    pub scans: u64,
    pub changes: u64,
    pub faults: u64,
}

/// Runs a program that both have loaded, and compares after each scan outputs, markers, registers and PWM.
pub fn alike<S: Simulated>(
    uno: &mut FirmwareEngine<S>,
    host: &mut HostEngine,
    random: &mut Random,
    seed: u64,
    program: &str,
) -> Counts {
    let mut counts = Counts::default();
    let board = uno.board();
    let needs = host.machine().map(|machine| machine.plc().needs()).unwrap();

    // Start close to the wrap of the clock in one of four programs.
    let mut now = if random.percent(25) {
        u32::MAX - random.below(500)
    } else {
        random.below(u32::MAX)
    };
    let (mut inputs, mut before) = (Inputs::default(), Ok(Image::default()));
    let mut memory_before = Vec::new();
    for scan in 0..SCANS {
        inputs = random_inputs_on(random, (needs, board), inputs);
        now = now.wrapping_add(random.below(20));
        let Ok(expected) = host.scan(&inputs, now);
        let came = uno
            .scan(&inputs, now)
            .unwrap_or_else(|e| panic!("seed {seed}: {e}"));
        assert_eq!(
            came, expected,
            "seed {seed}, scan {scan}, clock {now}:\n{program}"
        );
        counts.changes += u64::from(came != before);
        before = came;
        counts.scans += 1;
        if came.is_err() {
            counts.faults += 1;
            break;
        }
        let mut memory = Vec::new();
        for cell in (1..=board.markers)
            .map(Cell::Marker)
            .chain((1..=REGISTERS).map(Cell::Register))
        {
            let Ok(expected) = host.look(cell);
            let came = uno.look(cell).unwrap();
            assert_eq!(
                came, expected,
                "seed {seed}, scan {scan}, {cell:?}:\n{program}"
            );
            memory.push(came);
        }
        counts.changes += u64::from(memory != memory_before);
        memory_before = memory;
        for output in board.pwm_outputs() {
            let Ok(expected) = host.pwm(output);
            let came = uno.pwm(output).unwrap();
            assert_eq!(
                came, expected,
                "seed {seed}, scan {scan}, PWM {output}:\n{program}"
            );
        }
    }
    counts
}
