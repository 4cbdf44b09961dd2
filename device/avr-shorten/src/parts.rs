//! Equal parts of functions become subroutines.
//!
//! A part is a row of instructions that control only passes from the first to the last, that do not touch
//! the stack or r0, and call nothing unless the call comes last: it is made a jump then, so a function
//! that is called from a part has no less stack than before. Registers and flags pass through a call and
//! a return unchanged.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::assembly::{Code, Item, Line, Unit};
use super::body::{in_time, is_bound, is_scan, with_stack_arguments};
use super::effects::{Flow, bytes, flow};
use super::saves::routine;

/// The longest part that is looked for, in instructions.
const LONGEST: usize = 40;
/// The bytes of a call, before the linker looks at it.
const CALL: usize = 2;

/// A row of instructions and where it stands: item, and its first line.
struct Part {
    gain: usize,
    codes: Vec<Code>,
    places: Vec<(usize, usize)>,
}

/// Makes subroutines of equal parts until none is left that saves anything.
pub fn take_out(unit: &mut Unit, count: &mut usize) -> bool {
    let mut any = false;
    loop {
        let mut changed: BTreeSet<usize> = BTreeSet::new();
        for part in parts(unit) {
            // A function that was changed in this round has other lines now.
            if part.places.iter().any(|(item, _)| changed.contains(item)) {
                continue;
            }
            changed.extend(part.places.iter().map(|&(item, _)| item));
            *count += 1;
            apply(unit, part, &format!("__part{count}"));
        }
        if changed.is_empty() {
            return any;
        }
        any = true;
    }
}

/// All parts whose taking out saves something, those first that save most.
fn parts(unit: &Unit) -> Vec<Part> {
    let by_stack = with_stack_arguments(unit);
    let mut numbers: BTreeMap<&Code, u32> = BTreeMap::new();
    let mut codes: Vec<&Code> = Vec::new();
    // All code in one row of numbers; 0 is what no part may have in it.
    let mut row: Vec<u32> = Vec::new();
    let mut places: Vec<(usize, usize)> = Vec::new();
    for (item, function) in unit.items.iter().enumerate() {
        let Item::Function(function) = function else {
            continue;
        };
        let in_time = in_time(&function.body);
        let scan = is_scan(function);
        for (line, this) in function.body.iter().enumerate() {
            let may_be = |code| !scan && !in_time[line] && may_be_in_a_part(code, &by_stack);
            let number = match this {
                Line::Code(code) if may_be(code) => *numbers.entry(code).or_insert_with(|| {
                    codes.push(code);
                    codes.len() as u32
                }),
                _ => 0,
            };
            if is_bound(&function.body, line) {
                row.push(0);
                places.push((item, line));
            }
            row.push(number);
            places.push((item, line));
        }
        row.push(0);
        places.push((item, function.body.len()));
    }
    let code = |number: u32| codes[number as usize - 1];

    let mut found: HashMap<&[u32], Vec<usize>> = HashMap::new();
    for start in 0..row.len() {
        for length in 2..=LONGEST {
            let Some(window) = row.get(start..start + length) else {
                break;
            };
            let last = window[length - 1];
            let first_calls = || matches!(flow(code(window[0])), Flow::Call(_));
            if last == 0 || window[0] == 0 || first_calls() {
                break;
            }
            found.entry(window).or_default().push(start);
            if matches!(flow(code(last)), Flow::Call(_)) {
                break;
            }
        }
    }
    let part = |(window, starts): (&[u32], Vec<usize>)| {
        let mut apart: Vec<usize> = Vec::new();
        for start in starts {
            if apart.last().is_none_or(|last| last + window.len() <= start) {
                apart.push(start);
            }
        }
        let length: usize = window.iter().map(|&number| bytes(code(number))).sum();
        let last = window.last().map(|&number| flow(code(number)));
        let end = if matches!(last, Some(Flow::Call(_))) {
            0
        } else {
            2
        };
        let gain = (apart.len() * length).checked_sub(apart.len() * CALL + length + end)?;
        (apart.len() > 1 && gain > 4).then(|| Part {
            gain,
            codes: window.iter().map(|&number| code(number).clone()).collect(),
            places: apart.iter().map(|&start| places[start]).collect(),
        })
    };
    let mut parts: Vec<Part> = found.into_iter().filter_map(part).collect();
    parts.sort_by(|a, b| (b.gain, &a.places, &a.codes).cmp(&(a.gain, &b.places, &b.codes)));
    parts
}

/// Whether an instruction means the same one call deeper.
fn may_be_in_a_part(code: &Code, by_stack: &BTreeSet<String>) -> bool {
    let stack = code.name == "push" || code.name == "pop";
    let special = |operand: &String| matches!(operand.as_str(), "r0" | "61" | "62");
    let free = !code.operands.iter().any(special) && code.name != "lpm";
    match flow(code) {
        Flow::Next => !stack && free,
        Flow::Call(function) => code.name == "call" && !by_stack.contains(function),
        _ => false,
    }
}

fn apply(unit: &mut Unit, part: Part, name: &str) {
    let mut places = part.places;
    places.sort_by(|a, b| b.cmp(a));
    for (item, line) in places {
        if let Some(Item::Function(function)) = unit.items.get_mut(item) {
            let call = Line::code(&format!("call {name}"));
            function.body.splice(line..line + part.codes.len(), [call]);
        }
    }
    let mut body: Vec<Line> = part.codes.into_iter().map(Line::Code).collect();
    match body.last_mut() {
        Some(Line::Code(code)) if matches!(flow(code), Flow::Call(_)) => {
            code.name = "jmp".to_owned()
        }
        _ => body.push(Line::code("ret")),
    }
    unit.items.push(Item::Function(routine(name, body)));
}
