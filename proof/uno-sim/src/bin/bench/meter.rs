//! Times scans from outside: a pin toggles once in every scan, and its edges are a scan apart.

use crate::programs::{self, TOGGLING};
use anyhow::{Context, Result, bail, ensure};
use unoclp_card::image::{Fat, Image};
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{CYCLES_PER_MS, Halt, Program, Slot, Space, Uno};

/// Where the chip goes at an overflow of timer 1, the millisecond (ATmega328P datasheet, table 12-6): byte address.
const TICK: u32 = 13 * 4;
/// Cycles that the chip takes to get there from the instruction that was interrupted (section 7.7.1). simavr takes none.
pub const RESPONSE: u64 = 4;
/// The longest scan that is waited for, cycles.
const LONGEST: u64 = 50 * CYCLES_PER_MS;
/// The longest start-up that is waited for, ms.
const START_UP: u64 = 20_000;
/// How long each of the sixteen input patterns is measured, and how long it is left to settle, ms.
const WINDOW: u64 = 64;
const SETTLE: u64 = 4;

/// One scan, from edge to edge.
#[derive(Clone, Copy, Debug)]
pub struct Scan {
    /// Its length.
    pub cycles: u64,
    /// Millisecond interrupts that fell into it.
    pub ticks: u32,
    /// The outputs at its end.
    pub outputs: u8,
}

/// Lengths of scans, cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// The shortest.
    pub least: f64,
    /// Their mean.
    pub mean: f64,
    /// The longest.
    pub most: f64,
}

impl Times {
    /// Of these scans; an error where there are none.
    pub fn of(scans: impl IntoIterator<Item = Scan>) -> Result<Times> {
        Times::of_cycles(scans.into_iter().map(|scan| scan.cycles))
    }

    /// Of these lengths, likewise.
    fn of_cycles(lengths: impl IntoIterator<Item = u64>) -> Result<Times> {
        let (mut least, mut sum, mut most, mut count) = (u64::MAX, 0, 0, 0u64);
        for cycles in lengths {
            least = least.min(cycles);
            most = most.max(cycles);
            sum += cycles;
            count += 1;
        }
        ensure!(count > 0, "there is nothing to measure");
        Ok(Times {
            least: least as f64,
            mean: sum as f64 / count as f64,
            most: most as f64,
        })
    }

    /// What each of `count` adds, where `self` is with them and `without` is without.
    pub fn each(self, without: Times, count: usize) -> Times {
        let each = |with: f64, without: f64| (with - without) / count as f64;
        Times {
            least: each(self.least, without.least),
            mean: each(self.mean, without.mean),
            most: each(self.most, without.most),
        }
    }
}

/// A board whose program toggles output 04.
pub struct Meter {
    uno: Uno,
    level: bool,
    /// When the last edge came.
    edge: u64,
    /// The last edge was followed by a millisecond interrupt at once, which belongs to the scan that begins there.
    ticked: bool,
}

impl Meter {
    /// The firmware with this program on its card, at its first scan.
    pub fn firmware(firmware: &Program, codes: &[i64]) -> Result<Meter> {
        Meter::with_card(firmware, program_card(codes)?)
    }

    /// The firmware with this card, at its first scan.
    pub fn with_card(firmware: &Program, card: SdCard) -> Result<Meter> {
        let mut uno = Uno::with_program(firmware.clone(), Slot::Card(card))?;
        to_first_scan(&mut uno)?;
        Ok(Meter::of(uno))
    }

    /// A program that needs no card and starts at once: a yardstick.
    pub fn yardstick(program: &Program) -> Result<Meter> {
        Ok(Meter::of(Uno::with_program(program.clone(), Slot::Empty)?))
    }

    fn of(uno: Uno) -> Meter {
        Meter {
            level: false,
            edge: uno.cycles(),
            ticked: false,
            uno,
        }
    }

    /// The board.
    pub fn uno(&mut self) -> &mut Uno {
        &mut self.uno
    }

    /// Runs to the next edge.
    pub fn scan(&mut self) -> Result<Scan> {
        let mut ticks = u32::from(std::mem::take(&mut self.ticked));
        loop {
            self.uno.step()?;
            let ticked = self.uno.pc() == TICK;
            let outputs = self.uno.outputs();
            let level = outputs >> (TOGGLING - 1) & 1 == 1;
            let cycles = self.uno.cycles() - self.edge;
            if level != self.level {
                self.level = level;
                self.edge += cycles;
                self.ticked = ticked;
                return Ok(Scan {
                    cycles,
                    ticks,
                    outputs,
                });
            }
            ticks += u32::from(ticked);
            if cycles > LONGEST {
                bail!(
                    "output {TOGGLING:02} does not toggle; the serial port said {:?}",
                    self.uno.serial()
                );
            }
        }
    }

    /// The scans of so many ms.
    pub fn run_ms(&mut self, ms: u64) -> Result<Vec<Scan>> {
        self.run_cycles(ms * CYCLES_PER_MS)
    }

    /// The scans of so many cycles; it ends at an edge.
    pub fn run_cycles(&mut self, cycles: u64) -> Result<Vec<Scan>> {
        let end = self.uno.cycles() + cycles;
        let mut scans = Vec::new();
        while self.uno.cycles() < end {
            scans.push(self.scan()?);
        }
        self.uno.take_edges();
        Ok(scans)
    }

    /// Scans with each of the sixteen patterns of inputs in turn, a good second in all.
    pub fn all_inputs(&mut self) -> Result<Vec<Scan>> {
        let mut scans = Vec::new();
        for inputs in 0..16 {
            self.uno.set_inputs(inputs);
            self.run_ms(SETTLE)?;
            scans.extend(self.run_ms(WINDOW)?);
        }
        Ok(scans)
    }

    /// The outputs 01 to 03 for each pattern of inputs.
    pub fn logic(&mut self) -> Result<Vec<u8>> {
        let pattern = |inputs| {
            self.uno.set_inputs(inputs);
            // The first scan may have read the inputs before.
            let scans = [self.scan()?, self.scan()?, self.scan()?];
            Ok(scans[2].outputs & 0b0111)
        };
        (0..16).map(pattern).collect()
    }

    /// Changes the inputs between two scans; gives the scan that sees it.
    pub fn change(&mut self, inputs: u8) -> Result<Scan> {
        let begin = scan_begin(&self.uno)?;
        let mut ticks = 0;
        while self.uno.pc() != begin {
            self.uno.step()?;
            ticks += u32::from(self.uno.pc() == TICK);
            ensure!(
                self.uno.cycles() - self.edge < LONGEST,
                "no scan begins; the serial port said {:?}",
                self.uno.serial()
            );
        }
        self.uno.set_inputs(inputs);
        let mut scan = self.scan()?;
        scan.ticks += ticks;
        Ok(scan)
    }

    /// Cycles of `count` millisecond interrupts, from the vector to the instruction that was interrupted, with the chip's
    /// response.
    pub fn interrupts(&mut self, count: usize) -> Result<Times> {
        let mut interrupts = Vec::new();
        for _ in 0..count {
            self.uno.run_until(TICK, 2 * CYCLES_PER_MS)?;
            let begun = self.uno.cycles();
            // The vector has been entered by pushing two bytes.
            let back = self.uno.sp() + 2;
            while self.uno.sp() < back {
                self.uno.step()?;
            }
            interrupts.push(self.uno.cycles() - begun + RESPONSE);
        }
        Times::of_cycles(interrupts)
    }
}

/// A card with this program.
pub fn program_card(codes: &[i64]) -> Result<SdCard> {
    let image = Image::new(Fat::Fat16).file("PROGRAM.TXT", programs::text(codes));
    Ok(SdCard::new(Kind::Sdhc, image.build()?)?)
}

/// Where a scan begins.
fn scan_begin(uno: &Uno) -> Result<u32> {
    let symbol = uno
        .symbol("scan_begin")
        .filter(|symbol| symbol.space == Space::Flash);
    let symbol = symbol.context("the firmware has no symbol `scan_begin`")?;
    Ok(symbol.address)
}

/// Runs to the first scan; gives the time that it took, cycles.
pub fn to_first_scan(uno: &mut Uno) -> Result<u64> {
    let scan = scan_begin(uno)?;
    let begun = uno.cycles();
    loop {
        match uno.run_until(scan, 10 * CYCLES_PER_MS) {
            Ok(()) => return Ok(uno.cycles() - begun),
            Err(Halt::Timeout { .. }) if uno.cycles() - begun < START_UP * CYCLES_PER_MS => {}
            Err(halt) => return Err(halt.into()),
        }
        if uno.serial().contains("\r\nfault ") {
            uno.run_ms(20)?;
            bail!("the firmware refused a program: {:?}", uno.serial());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_each_adds_is_the_slope() {
        let scans = |lengths: &[u64]| Times::of_cycles(lengths.iter().copied());
        let (few, many) = (
            scans(&[100, 110, 120]).unwrap(),
            scans(&[400, 420, 500]).unwrap(),
        );
        assert_eq!((few.least, few.mean, few.most), (100.0, 110.0, 120.0));
        let each = many.each(few, 10);
        assert_eq!((each.least, each.mean, each.most), (30.0, 33.0, 38.0));
        assert!(scans(&[]).is_err());
    }
}
