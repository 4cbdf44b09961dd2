//! Whatever a program does, nothing leaves its range, and the same comes of the same.

use crate::plants;
use unoclp_core::Image;
use unoclp_plant::{Fault, Outputs, Plant, Run};

/// Numbers of chance, the same each time.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn outputs(&mut self) -> Outputs {
        let bits = self.next();
        let mut outputs = Outputs {
            points: Image((bits & 0xFFFF).into()),
            ..Outputs::default()
        };
        outputs
            .pwm
            .iter_mut()
            .take(5)
            .for_each(|duty| *duty = (bits >> 8) as u8);
        outputs
    }

    /// Somebody changes something, or something fails.
    fn meddle(&mut self, run: &mut Run<'_>) {
        let plant = run.plant();
        let part = self.next() as usize % plant.parts.len();
        let values = plant.parts[part].kind.values.len();
        let (value, to) = (self.next() as usize % values, self.next() as i32);
        let fault = Fault::ALL[self.next() as usize % Fault::ALL.len()];
        match self.next() % 3 {
            0 => run.hand(part, value, to),
            1 => run.fault(part, fault, true),
            _ => run.fault(part, fault, false),
        }
    }
}

fn check(name: &str, run: &Run<'_>, ranges: &[(i32, i32)]) {
    for (cell, (value, (low, high))) in run.cells().iter().zip(ranges).enumerate() {
        assert!(
            (low..=high).contains(&value),
            "{name}, cell {cell}: {value} of {low} to {high}"
        );
    }
    assert!(
        run.inputs().analogue.iter().all(|reading| *reading <= 1023),
        "{name}"
    );
}

#[test]
fn a_million_patterns_of_outputs_leave_every_value_in_its_range() {
    let plants = plants();
    let mut chance = Chance(0x1234_5678_9ABC_DEF1);
    let each = 1_000_000 / plants.len();
    for (name, plant) in &plants {
        let ranges = plant.ranges();
        let mut run = Run::new(plant, 7);
        let mut outputs = Outputs::default();
        for step in 0..=each {
            // Some stay for a while, so that things move.
            if chance
                .next()
                .is_multiple_of(if step % 40_000 < 20_000 { 2 } else { 3000 })
            {
                outputs = chance.outputs();
            }
            if chance.next().is_multiple_of(400) {
                chance.meddle(&mut run);
            }
            run.step(&outputs);
            if step % 16 == 0 {
                check(name, &run, &ranges);
            }
        }
        assert_eq!(ranges.len(), run.cells().len());
    }
}

/// A number for a run of ten minutes: the outputs are of chance, and the state at each second counts.
fn trace(plant: &Plant, seed: u64) -> u64 {
    let mut chance = Chance(42);
    let mut run = Run::new(plant, seed);
    let mut outputs = Outputs::default();
    let mut trace = 0_u64;
    for step in 0..600_000 {
        if step % 700 == 0 {
            outputs = chance.outputs();
        }
        run.step(&outputs);
        if step % 1000 == 0 {
            trace = trace.rotate_left(5) ^ run.hash();
        }
    }
    trace
}

/// What each plant comes to in ten minutes stands in a file: on every machine the same. With UPDATE=1 it is written.
#[test]
fn the_same_file_seed_and_outputs_give_the_same_trace() {
    let file = crate::folder("tools/plant/tests/traces.txt");
    let line = |(name, plant): &(String, Plant)| format!("{name} {:016x}\n", trace(plant, 5));
    let lines: String = plants().iter().map(line).collect();
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(&file, &lines).unwrap();
    }
    assert_eq!(std::fs::read_to_string(&file).unwrap_or_default(), lines);
}

#[test]
fn chance_changes_with_the_seed_and_the_reset_begins_anew() {
    let plants = plants();
    let (_, crossing) = plants.iter().find(|(name, _)| name == "crossing").unwrap();
    assert_ne!(trace(crossing, 1), trace(crossing, 2));
    let mut run = Run::new(crossing, 3);
    let begin = run.hash();
    (0..5000).for_each(|_| {
        run.step(&Outputs::default());
    });
    assert_ne!(run.hash(), begin);
    run.reset();
    assert_eq!(run.hash(), begin);
}
