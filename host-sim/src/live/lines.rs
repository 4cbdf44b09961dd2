//! The lines of a text of a running program, each with what the last scan has made of it.

use super::Flow;
use std::collections::{BTreeMap, BTreeSet};
use unoclp_core::isa::{Class, Opcode};
use unoclp_core::{Delay, Instruction};
use unoclp_ladder::Address;
use unoclp_source::used::real;
use unoclp_source::{Holding, Source, Spot, Variable};

/// The lines of a text, with the steps that tell how each stands.
pub struct Lines {
    lines: Vec<(String, Vec<usize>)>,
    /// What the lines, from 1, show that work on a number.
    numbers: BTreeMap<usize, Number>,
    /// The variables of a typed language; none of another.
    variables: Vec<Variable>,
    /// The registers that hold REAL numbers.
    reals: BTreeSet<u8>,
    /// The first step behind those that store first values.
    first_values: usize,
}

/// What a line shows that works on a number.
#[derive(Clone, Copy)]
enum Number {
    /// What this register or counter holds.
    Point(Address),
    /// The value behind this step.
    Value(usize),
}

impl Lines {
    /// The lines of the text of this program.
    pub fn new(program: &Source) -> Lines {
        let shown = |line: &str| {
            let line = line.replace('\t', "    ");
            line.chars().filter(|c| !c.is_control()).collect()
        };
        let lines = program.text.lines().map(|line| (shown(line), Vec::new()));
        let mut lines: Vec<(String, Vec<usize>)> = lines.collect();
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
            let Some((_, tellers)) = line.and_then(|line| lines.get_mut(line)) else {
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
        tell_behind_timers(&mut lines, &timers);
        Lines {
            lines,
            numbers: numbers(program),
            variables: program.variables.clone(),
            reals: program.size.used.reals.clone(),
            first_values: first_values(program),
        }
    }

    /// The first line of which there is something to tell but a first value, counted from 0.
    pub fn first(&self) -> usize {
        let tells = |from: usize| {
            let mut lines = self.lines.iter();
            lines.position(|(_, steps)| steps.iter().any(|step| *step >= from))
        };
        tells(self.first_values).or(tells(0)).unwrap_or_default()
    }

    /// The steps behind which the value is shown.
    pub fn values(&self) -> Vec<usize> {
        let numbers = self.numbers.values();
        let value = |number: &Number| match number {
            Number::Value(step) => Some(*step),
            Number::Point(_) => None,
        };
        numbers.filter_map(value).collect()
    }

    /// The texts of the lines, without what cannot be printed.
    pub fn texts(&self) -> impl Iterator<Item = &str> {
        self.lines.iter().map(|(text, _)| text.as_str())
    }

    /// What each line has come to.
    pub fn marks(&self, flow: &Flow) -> Vec<Mark> {
        let mark = |(number, (_, steps)): (usize, &(String, Vec<usize>))| {
            let acc = |&step: &usize| flow.acc.get(step).copied().flatten();
            match self.numbers.get(&number) {
                None => Mark::Power(steps.iter().rev().find_map(acc)),
                Some(Number::Point(point)) => {
                    let held = flow.number(*point);
                    Mark::Value(held.and_then(|held| self.shown(*point, held)))
                }
                // Of a typed language only what it stores has a name and a type.
                Some(Number::Value(_)) if !self.variables.is_empty() => Mark::Value(None),
                Some(Number::Value(step)) => {
                    Mark::Value(flow.value(*step).map(|value| value.to_string()))
                }
            }
        };
        (1..).zip(&self.lines).map(mark).collect()
    }

    /// What a point holds, in the type of its variable; none of one that the compiler needs for itself.
    fn shown(&self, point: Address, held: i32) -> Option<String> {
        match point {
            Address::Register(number) if !self.variables.is_empty() => {
                of_register(&self.variables, number)?
                    .shown(|spot| (spot == Spot::Register(number)).then_some(held))
            }
            Address::Register(number) if self.reals.contains(&number) => Some(real(held)),
            _ => Some(held.to_string()),
        }
    }
}

/// The variable that stands in this register.
fn of_register(variables: &[Variable], number: u8) -> Option<&Variable> {
    let spot = Spot::Register(number);
    let is_here = |of: &&Variable| matches!(of.holding, Holding::One((here, _)) if here == spot);
    variables.iter().find(is_here)
}

/// How many steps at the beginning store first values: the rung of S 01 that a compiler makes of declarations.
fn first_values(program: &Source) -> usize {
    let is_first =
        |step: &Instruction<'_>| step.opcode == Opcode::SystemContact && step.number() == Some(1);
    let mut steps = program.program().steps();
    match steps.next().filter(is_first) {
        Some(_) if !program.variables.is_empty() => {
            1 + steps
                .take_while(|step| step.opcode != Opcode::NewRung)
                .count()
        }
        _ => 0,
    }
}

/// What a line has come to in the last scan; none: the scan has not come there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mark {
    /// acc behind it.
    Power(Option<bool>),
    /// What its point holds, as a literal of its type, or the value behind it: it works on a number.
    Value(Option<String>),
}

/// A timer drives its point by itself, so lines that load its Q and store it may have no step of their own:
/// they stand as the timer does.
fn tell_behind_timers(lines: &mut [(String, Vec<usize>)], timers: &[bool]) {
    let mut timer = None;
    for (text, tellers) in lines {
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
        match step.opcode.row().class {
            Class::Load | Class::Operation | Class::Store => {
                let variables = &program.variables;
                let holds = |point: &Address| match *point {
                    // One that the compiler needs for itself tells nobody anything.
                    Address::Register(number) => {
                        variables.is_empty() || of_register(variables, number).is_some()
                    }
                    Address::Counter(_) => true,
                    _ => false,
                };
                let point = Address::of(step).filter(holds).map(Number::Point);
                let number = match (point, numbers.get(&place.line)) {
                    (Some(point), _) => point,
                    (None, Some(&point @ Number::Point(_))) => point,
                    (None, _) => Number::Value(index),
                };
                numbers.insert(place.line, number);
            }
            Class::Rung | Class::Close => {}
            _ => drop(numbers.remove(&place.line)),
        }
    }
    numbers
}

/// A step of the program.
struct Step {
    index: usize,
    opcode: Opcode,
    /// The line of the text, from 1.
    line: usize,
}

/// The step behind which acc is that of a line that is compiled to these steps in a row: the last, unless
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
