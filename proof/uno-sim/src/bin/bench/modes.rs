//! The stack at its deepest in every mode, the start without a card, and what the firmware takes of the memories.

use crate::jobs;
use crate::meter::{program_card, to_first_scan};
use crate::programs;
use anyhow::{Context, Result, ensure};
use std::path::Path;
use unoclp_card::image::{Fat, Image};
use unoclp_host_sim::random::Random;
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{CYCLES_PER_MS, Pin, Program, RAM_START, Slot, Uno};

/// How long a mode is watched, ms: a fault is displayed, and the state saved, several times.
const WATCH: u64 = 3_000;
/// A supply that is too low, mV.
const TOO_LOW: u16 = 4_000;

/// The stack in one mode.
#[derive(Clone, Copy, Debug)]
pub struct Mode {
    /// Which.
    pub name: &'static str,
    /// Bytes in use at most; none where the firmware has no such mode.
    pub peak: Option<u16>,
    /// Bytes that stay free.
    pub free: Option<i32>,
}

/// What is measured of modes and memories.
#[derive(Clone, Debug)]
pub struct Modes {
    /// The stack, in every mode.
    pub stack: Vec<Mode>,
    /// Bytes of stack that stay free at run time with the largest program.
    pub free_in_run: i32,
    /// From reset to the first scan without a card, cycles.
    pub reset_to_run: u64,
    /// Bytes of flash.
    pub flash: usize,
    /// Bytes of static RAM.
    pub static_ram: u32,
}

/// Measures it all. `template` is the file STATE.TXT.
pub fn measure(firmware: &Program, template: &Path) -> Result<Modes> {
    let state =
        std::fs::read(template).with_context(|| format!("cannot read {}", template.display()))?;
    let mut uno = on_card(firmware, program_card(&programs::full())?)?;
    let eeprom = stored(firmware, &programs::full())?;
    uno.reset_min_sp();
    run(&mut uno)?;
    let in_run = mode("RUN", &uno);
    let mut stack = vec![
        load(firmware)?,
        mode("start without a card", &eeprom.0),
        in_run,
    ];

    uno.reset_min_sp();
    uno.take_edges();
    uno.set_stop(true);
    uno.run_ms(WATCH)?;
    let flashes = uno.take_edges().iter().any(|edge| edge.pin == Pin::Led);
    ensure!(flashes, "STOP did not come");
    stack.push(mode("STOP, from the scan that detects it", &uno));

    uno.set_stop(false);
    to_first_scan(&mut uno)?;
    uno.reset_min_sp();
    uno.set_supply(TOO_LOW);
    uno.run_ms(WATCH)?;
    let faults = uno.symbol("FAULTS").context("the firmware counts faults")?;
    ensure!(
        uno.read_ram(faults.address, 1)? == [1],
        "the fault did not come"
    );
    stack.push(mode("fault found in RUN, and its display", &uno));
    let saving = saving(firmware, &state)?;
    stack.push(saving);

    let (_, reset_to_run) = stored(firmware, &programs::full_store())?;
    Ok(Modes {
        free_in_run: [in_run, saving]
            .iter()
            .filter_map(|mode| mode.free)
            .min()
            .context("RUN has not been watched")?,
        reset_to_run,
        flash: firmware.flash_bytes(),
        static_ram: uno.static_ram_end() - RAM_START,
        stack,
    })
}

fn mode(name: &'static str, uno: &Uno) -> Mode {
    Mode {
        name,
        peak: Some(uno.stack_peak()),
        free: Some(uno.stack_free()),
    }
}

/// A board at its first scan.
fn on_card(firmware: &Program, card: SdCard) -> Result<Uno> {
    let mut uno = Uno::with_program(firmware.clone(), Slot::Card(card))?;
    to_first_scan(&mut uno)?;
    Ok(uno)
}

/// Random inputs, a change each ms.
fn run(uno: &mut Uno) -> Result<()> {
    let mut random = Random::new(9);
    for _ in 0..WATCH {
        uno.set_inputs(random.below(16) as u8);
        uno.run_ms(1)?;
    }
    Ok(())
}

/// The start from each kind of card and volume, the program in pieces after long names.
fn load(firmware: &Program) -> Result<Mode> {
    let mut deepest: Option<Mode> = None;
    for fat in [Fat::Fat16, Fat::Fat32] {
        let image = (0..20).fold(Image::new(fat), |image, n| {
            image.file(format!("a long name of a file {n}"), "x")
        });
        let image = image.fragmented_file("PROGRAM.TXT", programs::text(&programs::full()));
        let image = image.build()?;
        for kind in [Kind::SdV1, Kind::SdscV2, Kind::Sdhc] {
            let uno = on_card(firmware, SdCard::new(kind, image.clone())?)?;
            let mode = mode("start with a card", &uno);
            if deepest.is_none_or(|deepest| mode.peak > deepest.peak) {
                deepest = Some(mode);
            }
        }
    }
    deepest.context("no card was tried")
}

/// A board that has started without a card from this program in its store, and the time from reset to its first scan,
/// cycles.
fn stored(firmware: &Program, codes: &[i64]) -> Result<(Uno, u64)> {
    let mut uno = on_card(firmware, program_card(codes)?)?;
    uno.swap_slot(Slot::Empty);
    uno.take_serial();
    uno.reset();
    uno.reset_min_sp();
    let cycles = to_first_scan(&mut uno)?;
    Ok((uno, cycles))
}

/// RUN with a card on which the state is kept.
fn saving(firmware: &Program, state: &[u8]) -> Result<Mode> {
    let mut uno = on_card(firmware, jobs::saving_card(&programs::full(), Some(state))?)?;
    uno.reset_min_sp();
    run(&mut uno)?;
    let blocks = uno.card().map_or(0, |card| card.log().blocks_written);
    let mode = mode("RUN, saving STATE.TXT", &uno);
    Ok(if blocks > 0 {
        mode
    } else {
        Mode {
            peak: None,
            free: None,
            ..mode
        }
    })
}

/// Milliseconds of so many cycles.
pub fn ms(cycles: u64) -> f64 {
    cycles as f64 / CYCLES_PER_MS as f64
}
