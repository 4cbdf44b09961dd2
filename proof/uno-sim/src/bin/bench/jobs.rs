//! The longest scan with each of the jobs at work that run beside the program.

use crate::meter::{Meter, Scan, Times};
use crate::programs;
use anyhow::{Context, Result};
use std::path::Path;
use unoclp_card::image::{Fat, Image};
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{CYCLES_PER_MS, Program};

/// Rungs of the program whose scans are told apart.
pub const RUNGS: usize = 8;
/// After so many scans from an interrupt on, what it has made due is done.
const BEHIND: usize = 2;
/// How long a card is busy after a block, ms (SD Physical Layer Simplified Specification, 4.6.2.2).
const BUSY: u64 = 250;
/// How long a run with saving takes, ms: several savings.
const SAVING: u64 = 6_000;

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
    /// Scans with nothing beside them.
    pub quiet: Times,
    /// Those with the millisecond interrupt.
    pub ticked: Times,
    /// Those right after it, where what it has made due is done.
    pub beside: Times,
    /// The saving.
    pub saving: Saving,
    /// The saving, with the largest program.
    pub full: Saving,
}

/// Measures it all. `template` is the file STATE.TXT.
pub fn measure(firmware: &Program, template: &Path) -> Result<Jobs> {
    let state =
        std::fs::read(template).with_context(|| format!("cannot read {}", template.display()))?;
    let codes = programs::program(&programs::rungs(RUNGS));
    let mut meter = Meter::firmware(firmware, &codes)?;
    meter.run_ms(20)?;
    let Sorted {
        quiet,
        ticked,
        beside,
    } = sort(meter.run_ms(1000)?);
    Ok(Jobs {
        quiet: Times::of(quiet)?,
        ticked: Times::of(ticked)?,
        beside: Times::of(beside)?,
        saving: saving(firmware, &codes, &state)?,
        full: saving(firmware, &programs::full(), &state)?,
    })
}

/// Scans by what goes on beside them.
#[derive(Debug, Default)]
struct Sorted {
    quiet: Vec<Scan>,
    ticked: Vec<Scan>,
    beside: Vec<Scan>,
}

/// Sorts scans by how far the last interrupt is behind them. It is not known of the first of them.
fn sort(scans: Vec<Scan>) -> Sorted {
    let (mut sorted, mut behind) = (Sorted::default(), 0);
    for scan in scans {
        behind = if scan.ticks > 0 { 0 } else { behind + 1 };
        let place = match behind {
            0 => &mut sorted.ticked,
            1..=BEHIND => &mut sorted.beside,
            _ => &mut sorted.quiet,
        };
        place.push(scan);
    }
    sorted
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

    #[test]
    fn scans_are_sorted_by_how_far_the_interrupt_is_behind() {
        let ticks = [0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 1, 1, 0, 0, 0];
        let scans = ticks.iter().zip(1..).map(|(&ticks, cycles)| Scan {
            cycles,
            ticks,
            outputs: 0,
        });
        let Sorted {
            quiet,
            ticked,
            beside,
        } = sort(scans.collect());
        let places = |scans: Vec<Scan>| scans.iter().map(|scan| scan.cycles).collect::<Vec<_>>();
        assert_eq!(places(ticked), [4, 9, 11, 12]);
        assert_eq!(places(beside), [1, 2, 5, 6, 10, 13, 14]);
        assert_eq!(places(quiet), [3, 7, 8, 15]);
    }
}
