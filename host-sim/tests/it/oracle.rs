//! The core against an interpreter that was written from docs/numeric-code.md alone.

use crate::naive::{self, Naive, World};
use unoclp_checked::Checked;
use unoclp_core::{Board, Inputs, Millis, real};
use unoclp_host_sim::engine::{Cell, Machine};
use unoclp_host_sim::random::{Random, random_inputs_on, random_program_on};
use unoclp_testing::held;

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
    outputs: u128,
    markers: Vec<bool>,
    registers: Vec<i64>,
    pwm: Vec<i64>,
    timers: Vec<(i64, i64, bool)>,
    counters: Vec<(i64, i64)>,
}

fn seen(machine: &Machine, now: i64) -> Seen {
    let plc = machine.plc();
    let timer =
        |timer: unoclp_core::TimerState| (timer.preset.into(), timer.elapsed.into(), timer.q);
    Seen {
        outputs: plc.outputs().0,
        markers: (1..=plc.board().markers)
            .map(|n| machine.look(Cell::Marker(n)) == 1)
            .collect(),
        registers: plc
            .registers()
            .iter()
            .map(|&register| register.into())
            .collect(),
        pwm: (1..=plc.board().outputs)
            .map(|output| plc.pwm(output).into())
            .collect(),
        timers: plc.timers(now as Millis).map(timer).collect(),
        counters: plc
            .counters()
            .map(|c| (c.value.into(), c.preset.into()))
            .collect(),
    }
}

fn expected(naive: &Naive, board: Board, counters: usize, now: i64) -> Seen {
    let outputs = usize::from(board.outputs);
    let bit = |output: usize| u128::from(naive.outputs[output]) << (output - 1);
    let timers = naive.timers.iter();
    let counters = naive.counters[1..=counters].iter();
    Seen {
        outputs: (1..=outputs).map(bit).sum(),
        markers: naive.markers[1..=board.markers.into()].to_vec(),
        registers: naive.registers[1..].to_vec(),
        pwm: naive.pwm[1..=outputs].to_vec(),
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
    compare(Board::UNO, PROGRAMS);
}

/// The same with all points that codes of two digits name.
#[test]
fn the_core_does_so_with_the_points_of_a_pc() {
    compare(Board::PC, PROGRAMS / 4);
}

fn compare(board: Board, programs: u64) {
    let seed = std::env::var("UNOCLP_SEED").map_or(SEED, |seed| seed.parse().expect("a number"));
    let (mut changes, mut faults, mut restarts) = (0u64, 0u64, 0u64);
    let mut run = |seed: u64| {
        let random = &mut Random::new(seed);
        let program = random_program_on(random, board);
        let mut machine = Machine::new(Checked::read(program.as_bytes(), board).unwrap());
        let mut naive = Naive::new(&program, board);
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
            inputs = random_inputs_on(random, (needs, board), inputs);
            if cuts && random.percent(5) {
                machine.with_plc(|plc| plc.restart());
                naive.restart();
                restarts += 1;
            }
            let world = World {
                inputs: std::array::from_fn(|input| inputs.points.0 >> input & 1 == 1),
                analogue: std::array::from_fn(|input| inputs.analogue[input].into()),
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
            let right = expected(&naive, board, came.counters.len(), now);
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
    };
    (seed..seed + programs).for_each(|seed| held(|| run(seed)));
    println!(
        "{programs} random programs, changed {changes} times, {faults} faults, {restarts} power cuts; seeds from {seed}"
    );
    assert!(
        changes > programs * 5 && faults > programs / 200 && restarts > programs / 4,
        "{changes}, {faults}, {restarts}"
    );
}

/// NC-23: each operation on REAL numbers of any size, those that are subnormal, infinite or none among them.
#[test]
fn real_numbers_are_what_the_page_says() {
    type Operation = fn(i32, i32) -> (i32, bool);
    type Change = fn(i32) -> (i32, bool);
    let operations: [(&str, Operation); 4] = [
        ("RAD", real::add),
        ("RSU", real::subtract),
        ("RMU", real::multiply),
        ("RDI", real::divide),
    ];
    let changes: [(&str, Change); 7] = [
        ("ITR", real::from_signed),
        ("UTR", real::from_unsigned),
        ("RND", real::round),
        ("TRC", real::cut),
        ("RNG", real::negate),
        ("RAB", real::absolute),
        ("RRT", real::square_root),
    ];
    let told = |(value, error): (i32, bool)| (!error).then_some(i64::from(value));
    let random = &mut Random::new(SEED);
    let mut small = 0;
    for _ in 0..PROGRAMS * 100 {
        let a = random.bits() as u32;
        // Half of the second make the result about as small as can be.
        let exponent = match random.below(4) {
            0 => 127_u32.saturating_sub((a >> 23 & 0xFF) + random.below(26)),
            1 => (a >> 23 & 0xFF) + 126 + random.below(26),
            2 => 0,
            _ => random.below(256),
        };
        let b = random.bits() as u32 & 0x807F_FFFF | exponent.min(255) << 23;
        let (a, b) = (a.cast_signed(), b.cast_signed());
        for (name, operation) in operations {
            let came = told(operation(a, b));
            let right = naive::real::operate(name, a.into(), b.into());
            assert_eq!(came, right, "{a:#X} {name} {b:#X}");
            small +=
                u64::from(came.is_some_and(|bits| (1..1 << 23).contains(&(bits & 0x7FFF_FFFF))));
        }
        for (name, change) in changes {
            let (came, right) = (told(change(b)), naive::real::change(name, b.into()));
            assert_eq!(came, right, "{name} {b:#X}");
        }
        let came = real::comparable(b);
        assert_eq!(naive::real::change("CMR", b.into()), Some(came.into()));
    }
    assert!(small > PROGRAMS * 20, "{small}");
}
