//! The function blocks of the norm (2.5.2.3), on the cells of an instance.

use super::Machine;
use crate::typed::{Standard, Value};

/// The cells of an instance, by the names of its members.
struct Cells<'m> {
    block: Standard,
    cells: &'m mut [Value],
}

impl Cells<'_> {
    fn at(&self, name: &str) -> Option<usize> {
        self.block.parts().iter().position(|part| part.0 == name)
    }

    fn get(&self, name: &str) -> i128 {
        let value = self.at(name).and_then(|at| self.cells.get(at));
        value.map_or(0, Value::int)
    }

    fn is(&self, name: &str) -> bool {
        self.get(name) != 0
    }

    fn set(&mut self, name: &str, value: i128) {
        if let Some(held) = self.at(name).and_then(|at| self.cells.get_mut(at)) {
            *held = Value::Int(value);
        }
    }

    fn put(&mut self, name: &str, truth: bool) {
        self.set(name, truth.into());
    }

    /// Whether an input has risen since the call before; its state is kept.
    fn rises(&mut self, input: &str, kept: &str) -> bool {
        let (now, before) = (self.is(input), self.is(kept));
        self.put(kept, now);
        now && !before
    }
}

/// INT's greatest and least value, where counters stop.
const MOST: i128 = 32_767;
const LEAST: i128 = -32_768;

impl Machine<'_> {
    /// Runs the block whose first cell this is.
    pub(super) fn standard(&mut self, block: Standard, cell: usize) {
        let now = i128::from(self.now);
        let Some(cells) = self.memory.get_mut(cell..cell + block.cells() as usize) else {
            return;
        };
        let mut cells = Cells { block, cells };
        match block {
            Standard::Sr => {
                let q = cells.is("S1") || cells.is("Q1") && !cells.is("R");
                cells.put("Q1", q);
            }
            Standard::Rs => {
                let q = !cells.is("R1") && (cells.is("S") || cells.is("Q1"));
                cells.put("Q1", q);
            }
            Standard::RTrig => {
                let q = cells.rises("CLK", "#M");
                cells.put("Q", q);
            }
            Standard::FTrig => {
                let (clk, before) = (cells.is("CLK"), cells.is("#M"));
                cells.put("#M", clk);
                cells.put("Q", !clk && before);
            }
            Standard::Ctu => up(&mut cells),
            Standard::Ctd => down(&mut cells),
            Standard::Ctud => both(&mut cells),
            Standard::Ton => on_delay(&mut cells, now),
            Standard::Tof => off_delay(&mut cells, now),
            Standard::Tp => pulse(&mut cells, now),
        }
    }
}

fn up(cells: &mut Cells<'_>) {
    let rises = cells.rises("CU", "#CU");
    let count = cells.get("CV");
    let count = match (cells.is("R"), rises && count < MOST) {
        (true, _) => 0,
        (false, true) => count + 1,
        (false, false) => count,
    };
    cells.set("CV", count);
    cells.put("Q", count >= cells.get("PV"));
}

fn down(cells: &mut Cells<'_>) {
    let rises = cells.rises("CD", "#CD");
    let count = cells.get("CV");
    let count = match (cells.is("LD"), rises && count > LEAST) {
        (true, _) => cells.get("PV"),
        (false, true) => count - 1,
        (false, false) => count,
    };
    cells.set("CV", count);
    cells.put("Q", count <= 0);
}

fn both(cells: &mut Cells<'_>) {
    let (up, down) = (cells.rises("CU", "#CU"), cells.rises("CD", "#CD"));
    let mut count = cells.get("CV");
    if cells.is("R") {
        count = 0;
    } else if cells.is("LD") {
        count = cells.get("PV");
    } else if up != down {
        count = (count + if up { 1 } else { -1 }).clamp(LEAST, MOST);
    }
    cells.set("CV", count);
    cells.put("QU", count >= cells.get("PV"));
    cells.put("QD", count <= 0);
}

fn on_delay(cells: &mut Cells<'_>, now: i128) {
    if cells.rises("IN", "#M") {
        cells.set("#AT", now);
    }
    let preset = cells.get("PT").max(0);
    let runs = cells.is("IN");
    let elapsed = if runs {
        (now - cells.get("#AT")).clamp(0, preset)
    } else {
        0
    };
    cells.set("ET", elapsed);
    cells.put("Q", runs && elapsed >= preset);
}

fn off_delay(cells: &mut Cells<'_>, now: i128) {
    let (on, before) = (cells.is("IN"), cells.is("#M"));
    cells.put("#M", on);
    let preset = cells.get("PT").max(0);
    if on {
        cells.set("ET", 0);
        cells.put("Q", true);
        return;
    }
    if before {
        cells.set("#AT", now);
    }
    if cells.is("Q") {
        let elapsed = (now - cells.get("#AT")).clamp(0, preset);
        cells.set("ET", elapsed);
        cells.put("Q", elapsed < preset);
    }
}

fn pulse(cells: &mut Cells<'_>, now: i128) {
    let rises = cells.rises("IN", "#M");
    let preset = cells.get("PT").max(0);
    if rises && !cells.is("Q") {
        cells.set("#AT", now);
        cells.put("Q", true);
    }
    if cells.is("Q") {
        let elapsed = (now - cells.get("#AT")).clamp(0, preset);
        cells.set("ET", elapsed);
        cells.put("Q", elapsed < preset);
    }
    if !cells.is("Q") && !cells.is("IN") {
        cells.set("ET", 0);
    }
}
