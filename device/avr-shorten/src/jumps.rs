//! Jumps: to jumps, to the next instruction, around jumps, and code that nothing leads to.
//!
//! Here every branch is taken to reach as far as it likes; [`reach`](super::reach) sees to it at the end.

use std::collections::BTreeMap;

use super::assembly::{Code, Function, Line, Unit};
use super::body::{code_at, code_from, is_end, labels, may_be_skipped, references};
use super::effects::{Flow, flow, opposite};

/// Shortens the jumps of all functions. Says whether anything changed.
pub fn shorten(unit: &mut Unit) -> bool {
    let mut changed = false;
    loop {
        let references = references(unit);
        let mut again = false;
        for function in unit.functions_mut() {
            again |= drop_labels(function, &references);
            again |= drop_unreachable(function);
            again |= invert(function);
            again |= thread(function);
            again |= drop_jumps_to_next(function);
            again |= jump_for_call(function);
            again |= pull_up(function, &references);
        }
        if !again {
            return changed;
        }
        changed = true;
    }
}

/// A label of the compiler's that nothing names is no label.
fn drop_labels(function: &mut Function, references: &BTreeMap<String, usize>) -> bool {
    let before = function.body.len();
    function.body.retain(|line| match line {
        Line::Label(name) => !name.starts_with(".L") || references.contains_key(name),
        _ => true,
    });
    function.body.len() < before
}

/// What stands after the end of a path, without a label, is dropped.
fn drop_unreachable(function: &mut Function) -> bool {
    let mut reachable = true;
    let mut dropped = false;
    let mut kept = Vec::new();
    for (n, line) in function.body.iter().enumerate() {
        reachable |= matches!(line, Line::Label(_) | Line::Fixed(_));
        if reachable || matches!(line, Line::Other(_)) {
            kept.push(line.clone());
        } else {
            dropped = true;
        }
        reachable &= !is_end(&function.body, n);
    }
    function.body = kept;
    dropped
}

/// `breq 1f; rjmp 2f; 1:` becomes `brne 2f; 1:`.
fn invert(function: &mut Function) -> bool {
    let found = function.body.iter().enumerate().find_map(|(n, line)| {
        let Line::Code(branch) = line else {
            return None;
        };
        let Flow::Branch(over) = flow(branch) else {
            return None;
        };
        let (at, jump) = code_from(&function.body, n + 1)?;
        let behind = function.body.iter().skip(at + 1);
        let lands = behind
            .take_while(|line| line.instruction().is_none())
            .any(|line| *line == Line::Label(over.to_owned()));
        let here = labels(&function.body).contains_key(jump.operand(0));
        let inverse = Code {
            name: opposite(&branch.name)?.to_owned(),
            operands: jump.operands.clone(),
        };
        (jump.name == "rjmp" && here && lands).then_some((n, at, inverse))
    });
    let Some((branch, jump, inverse)) = found else {
        return false;
    };
    if let Some(line) = function.body.get_mut(branch) {
        *line = Line::Code(inverse);
    }
    function.body.remove(jump);
    true
}

/// What leads to a jump leads to its target at once; what jumps to a `ret` is one.
fn thread(function: &mut Function) -> bool {
    let here = labels(&function.body);
    let shorter = |line: &Line| {
        let Line::Code(code) = line else {
            return None;
        };
        let (label, jumps) = match flow(code) {
            Flow::Jump(label) => (label, true),
            Flow::Branch(label) => (label, false),
            _ => return None,
        };
        let next = code_at(&function.body, label)?;
        if jumps && next.name == "ret" {
            return Some(Line::Code(next.clone()));
        }
        let target = next.operand(0);
        let goes_on = next.name == "rjmp" && target != label && here.contains_key(target);
        // Two jumps that lead to one another are left alone.
        let circles = goes_on && code_at(&function.body, target).is_some_and(|c| c.name == "rjmp");
        (goes_on && !circles).then(|| {
            Line::Code(Code {
                name: code.name.clone(),
                operands: next.operands.clone(),
            })
        })
    };
    let found: Vec<_> = function
        .body
        .iter()
        .enumerate()
        .filter_map(|(n, line)| Some((n, shorter(line)?)))
        .collect();
    let any = !found.is_empty();
    for (n, line) in found {
        if let Some(old) = function.body.get_mut(n) {
            *old = line;
        }
    }
    any
}

/// A jump or branch to what comes next anyway is dropped.
fn drop_jumps_to_next(function: &mut Function) -> bool {
    let superfluous = |n: usize| {
        let Some(Line::Code(code)) = function.body.get(n) else {
            return false;
        };
        let (Flow::Jump(label) | Flow::Branch(label)) = flow(code) else {
            return false;
        };
        let behind = function.body.iter().skip(n + 1);
        behind
            .take_while(|line| line.instruction().is_none())
            .any(|line| *line == Line::Label(label.to_owned()))
            && !may_be_skipped(&function.body, n)
    };
    let found = (0..function.body.len()).find(|&n| superfluous(n));
    if let Some(n) = found {
        function.body.remove(n);
    }
    found.is_some()
}

/// `call f; ret` becomes `jmp f`, which also takes less of the stack.
fn jump_for_call(function: &mut Function) -> bool {
    let calls = |n: usize| {
        let Some(Line::Code(call)) = function.body.get(n) else {
            return None;
        };
        let (at, next) = code_from(&function.body, n + 1)?;
        (call.name == "call" && next.name == "ret" && !may_be_skipped(&function.body, n))
            .then(|| (n, at, call.operands.clone()))
    };
    let Some((call, ret, operands)) = (0..function.body.len()).find_map(calls) else {
        return false;
    };
    let name = "jmp".to_owned();
    if let Some(line) = function.body.get_mut(call) {
        *line = Line::Code(Code { name, operands });
    }
    function.body.remove(ret);
    true
}

/// Code that only one jump leads to, and nothing falls into, moves to where that jump stood.
fn pull_up(function: &mut Function, references: &BTreeMap<String, usize>) -> bool {
    let body = &function.body;
    let here = labels(body);
    let block = |n: usize| {
        let Some(Line::Code(jump)) = body.get(n) else {
            return None;
        };
        let label = jump.operand(0);
        let start = *here.get(label)?;
        let alone = references.get(label) == Some(&1);
        let closed = (0..start)
            .rev()
            .find(|&n| !matches!(body.get(n), Some(Line::Other(_))))
            .is_some_and(|n| is_end(body, n));
        let end = (start..body.len()).find(|&n| is_end(body, n))?;
        (jump.name == "rjmp" && alone && closed && is_end(body, n) && !(start..=end).contains(&n))
            .then_some((n, start, end))
    };
    let Some((jump, start, end)) = (0..body.len()).find_map(block) else {
        return false;
    };
    let moved: Vec<Line> = function.body.get(start..=end).unwrap_or(&[]).to_vec();
    let keep = |n: &usize| !(start..=end).contains(n) && *n != jump;
    function.body = (0..function.body.len())
        .flat_map(|n| match n {
            _ if n == jump => moved.clone(),
            _ if keep(&n) => function.body.get(n).cloned().into_iter().collect(),
            _ => Vec::new(),
        })
        .collect();
    true
}
