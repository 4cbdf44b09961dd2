//! The core against an interpreter that was written from docs/numeric-code.md alone.

use crate::naive::{Naive, World};
use unoclp_core::{Inputs, Millis};
use unoclp_host_sim::engine::Machine;
use unoclp_host_sim::random::{Random, random_inputs, random_program};
use unoclp_host_sim::scenario::Cell;

/// Set `UNOCLP_SEED` to repeat a run, or to make another one.
const SEED: u64 = 1;
/// Without optimisation, generating as many would take minutes.
const PROGRAMS: u64 = if cfg!(debug_assertions) {
    2_000
} else {
    20_000
};
const SCANS: u32 = 60;

/// What can be seen of a program: outputs, markers, registers, PWM, timers and counters.
#[derive(Debug, PartialEq, Eq)]
struct Seen {
    outputs: u16,
    markers: Vec<bool>,
    registers: Vec<i64>,
    pwm: [i64; 2],
    timers: Vec<(i64, i64, bool)>,
    counters: Vec<(i64, i64)>,
}

fn seen(machine: &Machine, now: i64) -> Seen {
    let plc = machine.plc();
    let timer =
        |timer: unoclp_core::TimerState| (timer.preset.into(), timer.elapsed.into(), timer.q);
    Seen {
        outputs: plc.outputs().0,
        markers: (1..=64)
            .map(|n| machine.look(Cell::Marker(n)) == 1)
            .collect(),
        registers: plc
            .registers()
            .iter()
            .map(|&register| register.into())
            .collect(),
        pwm: [1, 4].map(|output| plc.pwm(output).into()),
        timers: plc.timers(now as Millis).map(timer).collect(),
        counters: plc
            .counters()
            .map(|c| (c.value.into(), c.preset.into()))
            .collect(),
    }
}

fn expected(naive: &Naive, counters: usize, now: i64) -> Seen {
    let bit = |output: usize| u16::from(naive.outputs[output]) << (output - 1);
    let timers = naive.timers.iter();
    let counters = naive.counters[1..=counters].iter();
    Seen {
        outputs: (1..=4).map(bit).sum(),
        markers: naive.markers[1..].to_vec(),
        registers: naive.registers[1..].to_vec(),
        pwm: [naive.pwm[1], naive.pwm[4]],
        timers: timers
            .map(|timer| (timer.preset, timer.elapsed(now), timer.q))
            .collect(),
        counters: counters
            .map(|counter| (counter.value, counter.preset))
            .collect(),
    }
}

/// NC-5 to NC-9, NC-12 to NC-19, and NC-21 to NC-28.
#[test]
fn the_core_does_what_the_page_says() {
    let seed = std::env::var("UNOCLP_SEED").map_or(SEED, |seed| seed.parse().expect("a number"));
    let (mut changes, mut faults, mut restarts) = (0u64, 0u64, 0u64);
    for seed in seed..seed + PROGRAMS {
        let random = &mut Random::new(seed);
        let program = random_program(random);
        let mut machine = Machine::new(unoclp_source::load(program.as_bytes()).unwrap());
        let mut naive = Naive::new(&program);
        let needs = machine.plc().needs();
        let mut inputs = Inputs::default();
        // Across the wrap of the clock in one of four programs.
        let mut now = match random.percent(25) {
            true => (1 << 32) - i64::from(random.below(500)),
            false => i64::from(random.below(u32::MAX)),
        };
        let cuts = random.percent(25);
        let mut before = None;
        for scan in 0..SCANS {
            inputs = random_inputs(random, needs, inputs);
            if cuts && random.percent(5) {
                machine.with_plc(|plc| plc.restart());
                naive.restart();
                restarts += 1;
            }
            let world = World {
                inputs: std::array::from_fn(|input| inputs.points.0 >> input & 1 == 1),
                analogue: inputs.analogue.map(i64::from),
            };
            let came = machine.scan_observed(inputs, now as Millis, |_, _| ());
            let right = naive.scan(&world, now);
            let line = came.map_err(|fault| (fault.cause.number(), fault.line));
            let right = right.map_err(|line| (75, Some(line)));
            assert_eq!(
                line.map(|_| ()),
                right,
                "seed {seed}, scan {scan}:\n{program}"
            );
            if right.is_err() {
                assert_eq!(machine.plc().outputs().0, 0);
                faults += 1;
                break;
            }
            let came = seen(&machine, now);
            let right = expected(&naive, came.counters.len(), now);
            assert_eq!(
                came, right,
                "seed {seed}, scan {scan}, time {now}:\n{program}"
            );
            changes += u64::from(before.replace(came) != Some(right));
            now += i64::from(match random.below(100) {
                0..70 => random.below(4),
                70..99 => random.below(60),
                _ => random.below(20_000_000),
            });
        }
    }
    println!(
        "{PROGRAMS} random programs, changed {changes} times, {faults} faults, {restarts} power cuts; seeds from {seed}"
    );
    assert!(
        changes > PROGRAMS * 5 && faults > PROGRAMS / 200 && restarts > PROGRAMS / 4,
        "{changes}, {faults}, {restarts}"
    );
}
