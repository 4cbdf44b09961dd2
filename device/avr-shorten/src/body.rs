//! Questions about the lines of a function that several rules ask.

use std::collections::{BTreeMap, BTreeSet};

use super::assembly::{Code, Function, Item, Line, Unit};
use super::effects::{Flow, bytes, flow, is_timed};

/// The label in the scan. The function around it runs in every scan.
const SCAN: &str = "scan_begin";

/// Whether a function is the scan itself, so that no rule may make it slower.
pub fn is_scan(function: &Function) -> bool {
    function.body.contains(&Line::Label(SCAN.to_owned()))
}

/// Every word of the unit that may be a label, with how often it stands in an instruction or a directive.
pub fn references(unit: &Unit) -> BTreeMap<String, usize> {
    let mut found = BTreeMap::new();
    let mut count = |text: &str| {
        let plain = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '$');
        for word in text.split(|c| !plain(c)).filter(|word| !word.is_empty()) {
            *found.entry(word.to_owned()).or_default() += 1;
        }
    };
    for item in &unit.items {
        match item {
            Item::Verbatim(lines) => lines.iter().for_each(|line| count(line)),
            Item::Function(function) => {
                let codes = function.body.iter().filter_map(Line::instruction);
                codes
                    .flat_map(|code| &code.operands)
                    .for_each(|operand| count(operand));
            }
        }
    }
    found
}

/// The instruction on line `n` or after it, if no label stands before it.
pub fn code_from(body: &[Line], n: usize) -> Option<(usize, &Code)> {
    let (at, line) = body
        .iter()
        .enumerate()
        .skip(n)
        .find(|(_, line)| !matches!(line, Line::Other(_)))?;
    Some((at, line.instruction()?))
}

/// The first instruction after a label.
pub fn code_at<'a>(body: &'a [Line], label: &str) -> Option<&'a Code> {
    let at = body
        .iter()
        .position(|line| matches!(line, Line::Label(name) if name == label))?;
    body.iter().skip(at).find_map(Line::instruction)
}

/// Whether the instruction on line `n` may be skipped by the one before it.
pub fn may_be_skipped(body: &[Line], n: usize) -> bool {
    body.iter()
        .take(n)
        .rev()
        .find_map(Line::instruction)
        .is_some_and(|code| flow(code) == Flow::Skip)
}

/// Whether the instruction on line `n` belongs to the one before it: that one may skip it, or turns
/// interrupts on, which takes effect only after line `n`, where the stack pointer is whole again.
pub fn is_bound(body: &[Line], n: usize) -> bool {
    let before = body.iter().take(n).rev().find_map(Line::instruction);
    let turns_on =
        |code: &Code| code.name == "sei" || code.name == "out" && code.operand(0) == "63";
    may_be_skipped(body, n) || before.is_some_and(turns_on)
}

/// Whether control never goes from line `n` to the next.
pub fn is_end(body: &[Line], n: usize) -> bool {
    let leaves = |code| matches!(flow(code), Flow::Jump(_) | Flow::Leave);
    body.get(n).and_then(Line::instruction).is_some_and(leaves) && !may_be_skipped(body, n)
}

/// For each line, whether it must run right before a write that is allowed for some cycles only, or is one.
pub fn in_time(body: &[Line]) -> Vec<bool> {
    const LINES: usize = 8;
    let timed = |line: &Line| line.instruction().is_some_and(is_timed);
    let soon = |n| body.iter().skip(n).take(LINES).any(timed);
    (0..body.len()).map(soon).collect()
}

/// The byte that each line begins at, at most, and the length of all.
pub fn offsets(body: &[Line]) -> Vec<usize> {
    let mut offset = 0;
    let mut offsets = vec![0];
    for line in body {
        offset += line.instruction().map_or(0, bytes);
        offsets.push(offset);
    }
    offsets
}

/// Where each label stands.
pub fn labels(body: &[Line]) -> BTreeMap<&str, usize> {
    let lines = body.iter().enumerate();
    lines
        .filter_map(|(n, line)| match line {
            Line::Label(name) => Some((name.as_str(), n)),
            _ => None,
        })
        .collect()
}

/// The functions that find arguments on the stack, after their return address: how far it is to them
/// depends on what they and their callers push.
pub fn with_stack_arguments(unit: &Unit) -> BTreeSet<String> {
    unit.functions()
        .filter(|function| !super::frame::is_understood(function))
        .map(|function| function.name.clone())
        .collect()
}
