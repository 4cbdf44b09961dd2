//! The longest scan with each of the jobs at work that run beside the program.

use crate::meter::{self, Meter, Scan, Times};
use crate::programs;
use anyhow::{Context, Result};
use std::path::Path;
use unoclp_card::image::{Fat, Image};
use unoclp_core::Cause;
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{CYCLES_PER_MS, Halt, Program, RAM_START, Uno};

/// Rungs of the program whose scans are told apart by turns.
pub const RUNGS: usize = 8;
/// The most turns that are looked for.
const MOST_TURNS: usize = 12;
/// Scans of the same turn may differ by so many cycles: what the program does depends on the level of output 04.
const SLACK: u64 = 2;
/// In how many of a hundred pairs a scan must be as long as that of its turn's next round: the job itself may take
/// longer once in a while.
const ALIKE: usize = 85;
/// Scans before something is broken.
const BEFORE: usize = 500;
/// Within this time every job has had its turns, and the fault shows, ms.
const FOUND: u64 = 5_000;
/// How long a card is busy after a block, ms (SD Physical Layer Simplified Specification, 4.6.2.2).
const BUSY: u64 = 250;
/// How long a run with saving takes, ms: several savings.
const SAVING: u64 = 6_000;

/// Scans of one of the turns that the jobs take.
#[derive(Clone, Debug)]
pub struct Turn {
    /// The jobs found in it.
    pub jobs: Vec<&'static str>,
    /// Its scans, without those that a millisecond interrupt lengthens.
    pub scans: Times,
}

/// Scans beside which STATE.TXT is saved, or could be.
#[derive(Clone, Copy, Debug)]
pub struct Saving {
    /// Blocks that the firmware wrote; none where it does not save.
    pub blocks: u64,
    /// The scans.
    pub scans: Times,
    /// The scans with the same inputs where the card has no such file.
    pub without: Times,
}

/// What is measured of the jobs.
#[derive(Clone, Debug)]
pub struct Jobs {
    /// The turns, in their order.
    pub turns: Vec<Turn>,
    /// All scans without an interrupt.
    pub quiet: Times,
    /// All scans with one.
    pub ticked: Times,
    /// The saving.
    pub saving: Saving,
    /// The saving, with the largest program.
    pub full: Saving,
}

/// A job, the fault that it tells, and what breaks what it looks at, in one of so many ways.
struct Job {
    name: &'static str,
    cause: Cause,
    ways: u32,
    spoil: fn(&mut Uno, u32) -> Result<()>,
}

const JOBS: [Job; 3] = [
    Job {
        name: "program check",
        cause: Cause::ProgramDamaged,
        ways: 16,
        spoil: spoil_program,
    },
    Job {
        name: "stack guard",
        cause: Cause::StackOverflow,
        ways: 1,
        spoil: spoil_guard,
    },
    Job {
        name: "supply",
        cause: Cause::SupplyLow,
        ways: 1,
        spoil: |uno, _| {
            uno.set_supply(4000);
            Ok(())
        },
    },
];

/// Turns one bit somewhere in static RAM, most of which is the program's.
fn spoil_program(uno: &mut Uno, way: u32) -> Result<()> {
    let room = uno.static_ram_end() - RAM_START;
    let address = RAM_START + room * (2 * way + 1) / 32;
    let byte = uno.read_ram(address, 1)?.first().copied().unwrap_or(0);
    Ok(uno.write_ram(address, &[byte ^ 1])?)
}

/// Overwrites the last byte of static RAM, as a stack that grows too far would.
fn spoil_guard(uno: &mut Uno, _: u32) -> Result<()> {
    let address = uno.static_ram_end() - 1;
    let byte = uno.read_ram(address, 1)?.first().copied().unwrap_or(0);
    Ok(uno.write_ram(address, &[!byte])?)
}

/// Measures it all. `template` is the file STATE.TXT.
pub fn measure(firmware: &Program, template: &Path) -> Result<Jobs> {
    let state =
        std::fs::read(template).with_context(|| format!("cannot read {}", template.display()))?;
    let codes = programs::program(&programs::rungs(RUNGS));
    let mut meter = Meter::firmware(firmware, &codes)?;
    meter.run_ms(20)?;
    let first = meter.edges();
    let scans = meter.run_ms(1000)?;
    let (ticked, quiet): (Vec<Scan>, Vec<Scan>) = scans.iter().partition(|scan| scan.ticks > 0);
    Ok(Jobs {
        turns: turns(firmware, &scans, first)?,
        quiet: Times::of(quiet)?,
        ticked: Times::of(ticked)?,
        saving: saving(firmware, &codes, &state)?,
        full: saving(firmware, &programs::full(), &state)?,
    })
}

/// Sorts scans by turns. The scan at `first` is the first of them since the start, and the jobs take their turns from
/// the start on.
fn turns(firmware: &Program, scans: &[Scan], first: usize) -> Result<Vec<Turn>> {
    let undisturbed: Vec<Option<Scan>> = undisturbed(scans);
    let count = period(&undisturbed).unwrap_or(1);
    let mut turns = Vec::new();
    for turn in 0..count {
        let place = (count + turn - first % count) % count;
        let scans = undisturbed.iter().skip(place).step_by(count);
        turns.push(Turn {
            jobs: Vec::new(),
            scans: Times::of(scans.copied().flatten())?,
        });
    }
    for job in &JOBS {
        if let Some(at) = found_at(firmware, job)?
            && let Some(turn) = turns.get_mut(at % count)
        {
            turn.jobs.push(job.name);
        }
    }
    Ok(turns)
}

/// The scans into which no interrupt fell, nor into the one before: what that has left to do is done.
fn undisturbed(scans: &[Scan]) -> Vec<Option<Scan>> {
    let before = [1].into_iter().chain(scans.iter().map(|scan| scan.ticks));
    let pairs = scans.iter().zip(before);
    pairs
        .map(|(scan, before)| (scan.ticks + before == 0).then_some(*scan))
        .collect()
}

/// After how many scans their lengths repeat.
fn period(scans: &[Option<Scan>]) -> Option<usize> {
    (1..=MOST_TURNS).find(|&turns| {
        let later = scans.iter().skip(turns);
        let pairs = scans.iter().zip(later);
        let pairs: Vec<bool> = pairs
            .filter_map(|(a, b)| Some(a.as_ref()?.cycles.abs_diff(b.as_ref()?.cycles) <= SLACK))
            .collect();
        let alike = pairs.iter().filter(|alike| **alike).count();
        !pairs.is_empty() && alike * 100 >= pairs.len() * ALIKE
    })
}

/// The scan after which a job finds what was broken, counted as edges are; none where it is not found.
fn found_at(firmware: &Program, job: &Job) -> Result<Option<usize>> {
    // A program that fills run memory, so that a bit turned there is one of it.
    let codes = programs::full();
    for way in 0..job.ways {
        let mut meter = Meter::firmware(firmware, &codes)?;
        while meter.edges() < BEFORE {
            meter.scan()?;
        }
        (job.spoil)(meter.uno(), way)?;
        let scan = meter::scan_begin(meter.uno())?;
        let limit = meter.uno().cycles() + FOUND * CYCLES_PER_MS;
        let mut at = meter.edges();
        while meter.uno().cycles() < limit {
            match meter.uno().run_until(scan, 10 * CYCLES_PER_MS) {
                Ok(()) => at += 1,
                Err(Halt::Timeout { .. }) => break,
                // The program is what was broken.
                Err(_) => break,
            }
        }
        let fault = format!("\r\nfault {}: ", job.cause.number());
        if meter.uno().run_ms(50).is_ok() && meter.uno().serial().contains(&fault) {
            return Ok(Some(at));
        }
    }
    Ok(None)
}

/// A card with a program and, where there is one, a file to save the state in. It is busy for long after each block.
pub fn saving_card(codes: &[i64], state: Option<&[u8]>) -> Result<SdCard> {
    let image = Image::new(Fat::Fat16).file("PROGRAM.TXT", programs::text(codes));
    let image = match state {
        Some(state) => image.file("STATE.TXT", state),
        None => image,
    };
    let card = SdCard::new(Kind::Sdhc, image.build()?)?;
    Ok(card.with_write_time(BUSY * CYCLES_PER_MS))
}

fn saving(firmware: &Program, codes: &[i64], state: &[u8]) -> Result<Saving> {
    let run = |state| {
        let mut meter = Meter::with_card(firmware, saving_card(codes, state)?)?;
        meter.run_ms(20)?;
        let mut scans = Vec::new();
        for pattern in 0..SAVING / 100 {
            // A change of inputs asks for a saving, once a second.
            meter.uno().set_inputs(pattern as u8 % 16);
            scans.extend(meter.run_ms(100)?);
        }
        let blocks = meter
            .uno()
            .card()
            .map_or(0, |card| card.log().blocks_written);
        Ok::<_, anyhow::Error>((blocks, Times::of(scans)?))
    };
    let (blocks, scans) = run(Some(state))?;
    let (_, without) = run(None)?;
    Ok(Saving {
        blocks,
        scans,
        without,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scans(lengths: &[(u64, u32)]) -> Vec<Scan> {
        let scan = |&(cycles, ticks): &(u64, u32)| Scan {
            cycles,
            ticks,
            outputs: 0,
        };
        lengths.iter().map(scan).collect()
    }

    #[test]
    fn the_turns_are_those_after_which_lengths_repeat() {
        let cases: [(&[u64], Option<usize>); 5] = [
            (&[50, 60, 70], Some(3)),
            (&[50, 51, 70, 50], Some(4)),
            (&[50, 61, 70, 51, 60, 71], Some(3)),
            (&[50, 52], Some(1)),
            (&[0, 3, 6, 9, 12, 15, 18, 21, 24, 27, 30, 33, 36], None),
        ];
        for (lengths, expected) in cases {
            let lengths = lengths.iter().cycle().take(200);
            let lengths: Vec<(u64, u32)> = lengths.map(|&length| (length, 0)).collect();
            assert_eq!(period(&undisturbed(&scans(&lengths))), expected);
        }
    }

    #[test]
    fn an_interrupt_disturbs_its_scan_and_the_next() {
        let scans = scans(&[(5, 0), (9, 1), (6, 0), (5, 0)]);
        let left: Vec<bool> = undisturbed(&scans).iter().map(Option::is_some).collect();
        assert_eq!(left, [false, false, false, true]);
    }
}
