//! Lines of a text without statements: each shows acc after the last of its steps, or the number that this works on.
//!
//! Owns which of the steps of a line speaks for it. Must not know what a statement is.

use super::{Flow, Mark};
use std::collections::BTreeMap;
use unoclp_core::Delay;
use unoclp_core::isa::{Class, Opcode};
use unoclp_program::Source;
use unoclp_program::used::{is_real, real};

/// The steps that tell how each line stands.
pub(super) struct Stepped {
    lines: Vec<Vec<usize>>,
    /// The lines, from 1, whose last step works on a number.
    numbers: BTreeMap<usize, Number>,
}

/// A number that a line shows: the value after a step.
#[derive(Clone, Copy)]
struct Number {
    step: usize,
    /// Whether it is stored, which is done where acc is 1.
    stores: bool,
    is_real: bool,
}

/// A step of the program.
struct Step {
    index: usize,
    opcode: Opcode,
    /// The line of the text, from 1.
    line: usize,
}

impl Stepped {
    pub(super) fn new(program: &Source) -> Stepped {
        let mut lines: Vec<Vec<usize>> = program.text.lines().map(|_| Vec::new()).collect();
        let steps = program.program().steps().zip(&program.map.steps);
        let steps: Vec<Step> = steps
            .enumerate()
            .map(|(index, (step, place))| Step {
                index,
                opcode: step.opcode,
                line: place.line,
            })
            .collect();
        let runs = || steps.chunk_by(|one, other| one.line == other.line);
        for (run, joins_too) in runs()
            .map(|run| (run, false))
            .chain(runs().map(|run| (run, true)))
        {
            let line = run.first().and_then(|step| step.line.checked_sub(1));
            let Some(tellers) = line.and_then(|line| lines.get_mut(line)) else {
                continue;
            };
            match joins_too {
                false => tellers.extend(tells(run)),
                // A line of nothing but these.
                true if tellers.is_empty() => tellers.extend(run.last().map(|step| step.index)),
                true => {}
            }
        }
        let timers: Vec<bool> = steps
            .iter()
            .map(|step| Delay::of(step.opcode).is_some())
            .collect();
        tell_behind_timers(&mut lines, &program.text, &timers);
        Stepped {
            lines,
            numbers: numbers(program),
        }
    }

    /// The first line of which there is something to tell, counted from 0.
    pub(super) fn first(&self) -> usize {
        let first = self.lines.iter().position(|steps| !steps.is_empty());
        first.unwrap_or_default()
    }

    /// What this line, from 1, has come to.
    pub(super) fn mark(&self, line: usize, flow: &Flow) -> Mark {
        if let Some(number) = self.numbers.get(&line) {
            let value = match number.stores {
                true => flow.value_where(number.step, true),
                false => flow.value(number.step),
            };
            return Mark::Value(value.map(|value| match number.is_real {
                true => real(value),
                false => value.to_string(),
            }));
        }
        let steps = self.lines.get(line.wrapping_sub(1));
        let mut steps = steps.into_iter().flatten().rev();
        Mark::Power(steps.find_map(|&step| flow.acc(step)))
    }
}

/// A timer drives its point by itself, so lines that load its Q and store it may have no step of their own:
/// they stand as the timer does.
fn tell_behind_timers(lines: &mut [Vec<usize>], text: &str, timers: &[bool]) {
    let mut timer = None;
    for (tellers, text) in lines.iter_mut().zip(text.lines()) {
        let first_word = text.split_whitespace().next().unwrap_or_default();
        if let Some(&step) = tellers.last() {
            timer = timers.get(step).is_some_and(|is| *is).then_some(step);
        } else if ["LD", "ST", "=", "OUT"].contains(&first_word.to_uppercase().as_str()) {
            tellers.extend(timer);
        } else if !first_word.is_empty() && !first_word.starts_with("(*") {
            timer = None;
        }
    }
}

/// The lines, from 1, whose last step works on a number.
fn numbers(program: &Source) -> BTreeMap<usize, Number> {
    let places = &program.map.steps;
    let steps = program.program().steps().zip(places);
    let mut numbers = BTreeMap::new();
    for (index, (step, place)) in steps.enumerate() {
        let class = step.opcode.row().class;
        match class {
            Class::Load | Class::Operation | Class::Store => {
                let number = Number {
                    step: index,
                    stores: class == Class::Store,
                    is_real: is_real(&step, &program.size.used),
                };
                numbers.insert(place.line, number);
            }
            Class::Rung | Class::Close => {}
            _ => drop(numbers.remove(&place.line)),
        }
    }
    numbers
}

/// The step after which acc is that of a line that is compiled to these steps in a row: the last, unless
/// branches go beyond the line; then the last that is more than their beginning or end, if there is one.
fn tells(run: &[Step]) -> Option<usize> {
    let opens = run.iter().filter(|step| step.opcode.opens()).count();
    let closes = |step: &&Step| step.opcode == Opcode::CloseBranch;
    let own =
        |step: &&Step| !(step.opcode.opens() || closes(step) || step.opcode == Opcode::NewRung);
    let last_own = run.iter().rev().find(own)?;
    let whole = opens == run.iter().filter(closes).count();
    let last = if whole { run.last()? } else { last_own };
    Some(last.index)
}
