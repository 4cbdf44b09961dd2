//! Rungs as lines of text, energised parts with heavy lines: `━━┥ I1 ┝━━┤/I2 ├──( Q1 )`.
//!
//! `╭or … ╯` is a branch: what stands between is an alternative to all that stands before it in
//! the rung. `╭and` and `╭xor` are blocks. `•1` is branch point 01, and `╭or•1` an alternative to
//! what stands after that point. `»3` goes on at label 3. What works on numbers stands in a box,
//! `[ADD D3]`.

use super::ON;
use super::symbol::Symbol;
use ratatui::style::Style;
use ratatui::text::{Line, Span};
use std::borrow::Cow;
use unoclp_core::isa::Opcode;
use unoclp_core::{Delay, Instruction, Plc};

/// A rung of the program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Rung {
    elements: Vec<Element>,
}

/// What is drawn as one piece.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Element {
    symbol: Symbol,
    /// Where the instruction stands in the program, counted from 0.
    step: usize,
}

/// What a program does at the moment, for its rungs to show.
#[derive(Clone, Debug, Default)]
pub struct Flow {
    /// acc behind each instruction that the last scan has run; empty before the first scan.
    pub acc: Vec<Option<bool>>,
    /// Elapsed time of each timer.
    pub elapsed: Vec<u32>,
    /// What each counter has counted to.
    pub counted: Vec<i32>,
}

impl Flow {
    /// Takes up timers and counters as they stand at this time.
    pub fn look(&mut self, plc: &Plc<'_>, now: u32) {
        self.elapsed = plc.timers(now).map(|timer| timer.elapsed).collect();
        self.counted = plc.counters().map(|counter| counter.value).collect();
    }

    /// acc behind an instruction; 0 where it was not run.
    fn power(&self, step: usize) -> bool {
        self.acc.get(step).copied().flatten().unwrap_or(false)
    }
}

impl Rung {
    /// The rungs of a program: what stands before its first new rung is one too.
    pub fn all<'c>(steps: impl Iterator<Item = Instruction<'c>>) -> Vec<Rung> {
        let mut rungs = Vec::new();
        let mut timers = 0;
        for (step, instruction) in steps.enumerate() {
            timers += usize::from(Delay::of(instruction.opcode).is_some());
            let begins = instruction.opcode == Opcode::NewRung;
            if begins || rungs.is_empty() {
                rungs.push(Rung::default());
            }
            if let Some(Rung { elements }) = rungs.last_mut().filter(|_| !begins) {
                let opening = match instruction.opcode {
                    // Drawn together with the opening code that it belongs to.
                    Opcode::RecallBranch => elements.pop().map(|opening| opening.symbol),
                    _ => None,
                };
                let symbol = Symbol::new(&instruction, timers, opening);
                elements.push(Element { symbol, step });
            }
        }
        rungs
    }

    /// The lines that show the rung, none wider than `width` unless a single element is.
    pub fn lines(&self, number: usize, flow: &Flow, width: usize) -> Vec<Line<'static>> {
        let scanned = !flow.acc.is_empty();
        let mut lines = vec![Line::from(vec![
            Span::raw(format!("{number:>3} ")),
            drawn("├", "┣", scanned),
        ])];
        let mut power = scanned;
        for element in &self.elements {
            let wire = drawn("──", "━━", power);
            power = flow.power(element.step);
            let symbol = styled(element.symbol.text(power, flow), power);
            let room = |line: &Line| line.width() + wire.width() + symbol.width() <= width;
            if !lines.last().is_some_and(room) {
                lines.push(Line::raw("      "));
            }
            if let Some(line) = lines.last_mut() {
                line.spans.extend([wire, symbol]);
            }
        }
        lines
    }
}

fn drawn(light: &'static str, heavy: &'static str, power: bool) -> Span<'static> {
    styled(if power { heavy } else { light }, power)
}

fn styled(text: impl Into<Cow<'static, str>>, power: bool) -> Span<'static> {
    let style = if power { ON } else { Style::new() };
    Span::styled(text, style)
}
