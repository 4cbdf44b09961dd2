//! Rungs as lines of text, energised parts with heavy lines: `━━┥ I1 ┝━━┤/I2 ├──( Q1 )`.
//!
//! `╭or … ╯` is a branch: what stands between is an alternative to all that stands before it in
//! the rung. `•1` is branch point 01, and `╭or•1` an alternative to what stands after that point.

use super::ON;
use ratatui::style::Style;
use ratatui::text::{Line, Span};
use std::borrow::Cow;
use unoclp_core::{Instruction, TimerState};

/// A rung of the program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Rung {
    elements: Vec<Element>,
}

/// What is drawn as one piece.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Element {
    instruction: Instruction,
    /// Where the instruction stands in the program, counted from 0.
    step: usize,
    /// Timers in the program before this instruction: the index of a timer block's own timer.
    timer: usize,
}

impl Rung {
    /// The rungs of a program: what stands before its first new rung is one too.
    pub fn all(steps: impl Iterator<Item = Instruction>) -> Vec<Rung> {
        let mut rungs = Vec::new();
        let mut timer = 0;
        for (step, instruction) in steps.enumerate() {
            let begins = instruction == Instruction::NewRung;
            if begins || rungs.is_empty() {
                rungs.push(Rung::default());
            }
            if let Some(Rung { elements }) = rungs.last_mut().filter(|_| !begins) {
                if matches!(instruction, Instruction::RecallBranch(_)) {
                    // Drawn together with the open branch that it belongs to.
                    elements.pop();
                }
                elements.push(Element {
                    instruction,
                    step,
                    timer,
                });
            }
            timer += usize::from(instruction.timer().is_some());
        }
        rungs
    }

    /// The lines that show the rung, none wider than `width` unless a single element is.
    ///
    /// `flow` is acc after each instruction of the program, and empty before the first scan.
    pub fn lines(
        &self,
        number: usize,
        flow: &[bool],
        timers: &[TimerState],
        width: usize,
    ) -> Vec<Line<'static>> {
        let scanned = !flow.is_empty();
        let mut lines = vec![Line::from(vec![
            Span::raw(format!("{number:>3} ")),
            drawn("├", "┣", scanned),
        ])];
        let mut power = scanned;
        for element in &self.elements {
            let wire = drawn("──", "━━", power);
            power = flow.get(element.step).copied().unwrap_or(false);
            let symbol = element.symbol(power, timers);
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

impl Element {
    fn symbol(&self, power: bool, timers: &[TimerState]) -> Span<'static> {
        use Instruction::*;
        let (left, right) = if power {
            ('┥', '┝')
        } else {
            ('┤', '├')
        };
        let text = match self.instruction {
            NewRung => String::new(),
            InputContact(p) => format!("{left} I{} {right}", p.number()),
            InputContactNot(p) => format!("{left}/I{} {right}", p.number()),
            OutputContact(p) => format!("{left} Q{} {right}", p.number()),
            OutputContactNot(p) => format!("{left}/Q{} {right}", p.number()),
            Coil(p) => format!("( Q{} )", p.number()),
            SetCoil(p) => format!("(S Q{})", p.number()),
            ResetCoil(p) => format!("(R Q{})", p.number()),
            OpenBranch => "╭or".to_owned(),
            CloseBranch => "╯".to_owned(),
            RecallBranch(p) => format!("╭or•{}", p.number()),
            StoreBranch(p) => format!("•{}", p.number()),
            OnDelay(block) | OffDelay(block) => {
                let preset = block.preset.to_string();
                let elapsed = timers.get(self.timer).map_or(0, |timer| timer.elapsed);
                format!(
                    "[T{} {} {elapsed:>width$}/{preset} Q{}]",
                    self.timer + 1,
                    self.instruction.row().letters,
                    block.output.number(),
                    width = preset.len()
                )
            }
        };
        styled(text, power)
    }
}

fn drawn(light: &'static str, heavy: &'static str, power: bool) -> Span<'static> {
    styled(if power { heavy } else { light }, power)
}

fn styled(text: impl Into<Cow<'static, str>>, power: bool) -> Span<'static> {
    let style = if power { ON } else { Style::new() };
    Span::styled(text, style)
}
