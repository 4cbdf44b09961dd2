//! The function blocks of the standard (2.5.2.3) and of the board, on the cells of an instance.

use super::Machine;
use crate::{Base, Order, Standard, Value, narrow};

/// The cells of an instance, by the names of its members.
struct Cells<'m> {
    block: Standard,
    cells: &'m mut [Value],
}

impl Cells<'_> {
    fn at(&self, name: &str) -> Option<(usize, Base)> {
        let mut parts = self.block.parts().iter().enumerate();
        let named = parts.find(|(_, part)| part.0 == name);
        named.map(|(at, part)| (at, part.1))
    }

    /// A number of 32 bits counts with its sign whatever its type is, as the board's counters do (NC-15).
    fn get(&self, name: &str) -> i128 {
        let Some((at, base)) = self.at(name) else {
            return 0;
        };
        let value = self.cells.get(at).map_or(0, Value::int);
        match base {
            Base::Udint => (value as i32).into(),
            _ => value,
        }
    }

    fn is(&self, name: &str) -> bool {
        self.get(name) != 0
    }

    fn set(&mut self, name: &str, value: i128) {
        let Some((at, base)) = self.at(name) else {
            return;
        };
        if let Some(held) = self.cells.get_mut(at) {
            *held = match base {
                Base::Udint => narrow(base, Value::Int(value)),
                _ => Value::Int(value),
            };
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

/// A counter's number after so many counts: it stops at the ends of 32 bits, as the board's does (NC-15).
fn counted(count: i128, by: i128) -> i128 {
    (count + by).clamp(i32::MIN.into(), i32::MAX.into())
}

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
            Standard::Ctu | Standard::CtuDint | Standard::CtuUdint => up(&mut cells),
            Standard::Ctd | Standard::CtdDint | Standard::CtdUdint => down(&mut cells),
            Standard::Ctud | Standard::CtudDint | Standard::CtudUdint | Standard::Counter => {
                both(&mut cells);
            }
            Standard::Ton => on_delay(&mut cells, now),
            Standard::Tof => off_delay(&mut cells, now),
            Standard::Tp => pulse(&mut cells, now),
            Standard::Tonr => retentive(&mut cells, now),
        }
    }

    /// Does to the timer or counter whose first cell this is what an instruction of the board does.
    pub(super) fn order(
        &mut self,
        order: &Order,
        value: Option<Value>,
        block: Standard,
        cell: usize,
    ) {
        let now = i128::from(self.now);
        let Some(cells) = self.memory.get_mut(cell..cell + block.cells() as usize) else {
            return;
        };
        let mut cells = Cells { block, cells };
        match order {
            Order::Preset(of) => {
                let part = if block.is_timer() { "PT" } else { "PV" };
                cells.set(part, stored(value, of.base));
            }
            Order::Reset if block.is_timer() => {
                for part in ["Q", "ET", "#M", "#AT"] {
                    cells.set(part, 0);
                }
            }
            Order::Look if block.is_timer() => look(&mut cells, now),
            Order::Reset => cells.set("CV", 0),
            Order::Load => cells.set("CV", cells.get("PV").max(0)),
            Order::Number(of) => cells.set("CV", stored(value, of.base)),
            Order::Look => {}
        }
        if block.is_counter() {
            outputs(&mut cells);
        }
    }
}

/// A value as a cell of this type holds it.
fn stored(value: Option<Value>, base: Base) -> i128 {
    value.map_or(0, |value| narrow(base, value).int())
}

/// What a counter's number says of it.
fn outputs(cells: &mut Cells<'_>) {
    let count = cells.get("CV");
    let reached = is_reached(cells, count);
    match cells.block.plain() {
        Standard::Ctu => cells.put("Q", reached),
        Standard::Ctd => cells.put("Q", count <= 0),
        _ => {
            cells.put("QU", reached);
            cells.put("QD", count <= 0);
        }
    }
}

/// Whether a counter has reached its preset, which is at least 0 (NC-15).
fn is_reached(cells: &Cells<'_>, count: i128) -> bool {
    count >= cells.get("PV").max(0)
}

fn up(cells: &mut Cells<'_>) {
    let rises = cells.rises("CU", "#CU");
    let count = match cells.is("R") {
        true => 0,
        false => counted(cells.get("CV"), rises.into()),
    };
    cells.set("CV", count);
    outputs(cells);
}

fn down(cells: &mut Cells<'_>) {
    let rises = cells.rises("CD", "#CD");
    let count = match cells.is("LD") {
        true => cells.get("PV"),
        false => counted(cells.get("CV"), -i128::from(rises)),
    };
    cells.set("CV", count);
    outputs(cells);
}

fn both(cells: &mut Cells<'_>) {
    let (up, down) = (cells.rises("CU", "#CU"), cells.rises("CD", "#CD"));
    let count = if cells.is("R") {
        0
    } else if cells.is("LD") {
        // The board's own keeps its preset where no number is less than 0.
        let least = match cells.block {
            Standard::Counter => 0,
            _ => i128::MIN,
        };
        cells.get("PV").max(least)
    } else {
        counted(counted(cells.get("CV"), up.into()), -i128::from(down))
    };
    cells.set("CV", count);
    outputs(cells);
}

/// Once it is over it stays so until IN falls, whatever PT becomes (NC-9).
fn on_delay(cells: &mut Cells<'_>, now: i128) {
    let (rises, preset) = (cells.rises("IN", "#M"), cells.get("PT").max(0));
    if rises {
        cells.set("#AT", now);
    }
    let elapsed = now - cells.get("#AT");
    let (on, before) = (cells.is("IN"), cells.is("Q") && !rises);
    let q = on && (before || elapsed >= preset);
    let elapsed = match (on, q) {
        (false, _) => 0,
        (true, true) => preset,
        (true, false) => elapsed,
    };
    cells.set("ET", elapsed);
    cells.put("Q", q);
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
    let elapsed = now - cells.get("#AT");
    let runs = cells.is("Q") && elapsed < preset;
    let elapsed = match (runs, cells.is("IN")) {
        (true, _) => elapsed,
        (false, true) => preset,
        (false, false) => 0,
    };
    cells.set("ET", elapsed);
    cells.put("Q", runs);
}

/// Gathers the time for which IN is 1. `#AT` is when that began, less what was gathered before; where IN is 0, what has
/// been gathered.
fn retentive(cells: &mut Cells<'_>, now: i128) {
    let preset = cells.get("PT").max(0);
    let (on, before) = (cells.is("IN"), cells.is("#M"));
    if cells.is("Q") {
        cells.set("ET", preset);
        return;
    }
    if on != before {
        cells.set("#AT", now - cells.get("#AT"));
        cells.put("#M", on);
    }
    let gathered = match on {
        true => now - cells.get("#AT"),
        false => cells.get("#AT"),
    };
    cells.put("Q", on && gathered >= preset);
    cells.set("ET", gathered.min(preset));
}

/// ET as the board shows it at this moment (NC-14).
fn look(cells: &mut Cells<'_>, now: i128) {
    let preset = cells.get("PT").max(0);
    let (q, on) = (cells.is("Q"), cells.is("#M"));
    let runs = match cells.block {
        Standard::Tof => q && !on,
        Standard::Tp => q,
        _ => on && !q,
    };
    let elapsed = match cells.block {
        _ if runs => (now - cells.get("#AT")).clamp(0, preset),
        // A pulse that is over, while IN is 1.
        Standard::Tp if on => preset,
        Standard::Tof | Standard::Tp => 0,
        _ if q => preset,
        Standard::Tonr => cells.get("#AT").min(preset),
        _ => 0,
    };
    cells.set("ET", elapsed);
}
