//! Decisions that are made already: the compiler puts a truth value into a register, 0 or 1 by a branch,
//! and branches by that at once. The first branch can go where the second one will.
//!
//! ```asm
//!     ldi r24, 1             ldi r24, 1
//!     brlo 1f                brlo 2f
//!     mov r24, r1            mov r24, r1
//! 1:  andi r24, 1            rjmp far
//!     cpi r24, 0
//!     breq far           2:
//! ```
//!
//! What is superfluous then, other rules drop.

use super::assembly::{Function, Line, Unit};
use super::body::{code_from, is_end, labels};
use super::effects::{CARRY, FLAGS, Flow, flow, register};
use super::liveness::needed_behind;
use super::values::Walk;

/// A label after which a register is compared with 0, and a branch follows.
struct Decision<'a> {
    /// The line of the label.
    label: usize,
    name: &'a str,
    register: u32,
    /// The line of the branch, whether it is taken at 0, and where to.
    branch: usize,
    at_zero: bool,
    target: &'a str,
}

/// Lets what knows the outcome of a decision go there.
pub fn drop_known(unit: &mut Unit, count: &mut usize) -> bool {
    let mut changed = false;
    for function in unit.functions_mut() {
        while let Some(body) = decided(function, count) {
            function.body = body;
            changed = true;
        }
    }
    changed
}

/// The function with one decision less on one of its paths.
fn decided(function: &Function, count: &mut usize) -> Option<Vec<Line>> {
    let body = &function.body;
    let decisions = decisions(function);
    let mut walk = Walk::of(function);
    for (n, line) in body.iter().enumerate() {
        let leads = match line {
            Line::Code(code) if !walk.may_be_skipped() => match flow(code) {
                Flow::Jump(label) | Flow::Branch(label) => {
                    decisions.iter().find(|d| d.name == label)
                }
                _ => None,
            },
            Line::Label(_) if !n.checked_sub(1).is_some_and(|n| is_end(body, n)) => {
                decisions.iter().find(|d| d.label == n)
            }
            _ => None,
        };
        if let Some(decision) = leads {
            let value = walk.registers.get(decision.register);
            let zero = value == walk.constant("0");
            if zero || value == walk.constant("1") {
                return Some(lead(body, n, decision, zero, count));
            }
        }
        walk.pass(line);
    }
    None
}

/// All decisions whose flags nothing needs afterwards.
fn decisions(function: &Function) -> Vec<Decision<'_>> {
    let body = &function.body;
    let here = labels(body);
    let found = body.iter().enumerate().filter_map(|(label, line)| {
        let Line::Label(name) = line else {
            return None;
        };
        let behind = body.iter().enumerate().skip(label);
        let first = behind
            .take_while(|(_, line)| line.instruction().is_none())
            .count()
            + label;
        let (mut at, mut code) = code_from(body, first)?;
        let number = register(code.operand(0))?;
        let lowest = code.is(&format!("andi r{number}, 1"));
        if lowest {
            (at, code) = code_from(body, at + 1)?;
        }
        if code.is(&format!("cpi r{number}, 0")) {
            (at, code) = code_from(body, at + 1)?;
        // After `andi` it may have been dropped as superfluous.
        } else if !lowest {
            return None;
        }
        let Flow::Branch(target) = flow(code) else {
            return None;
        };
        let at_zero = match code.name.as_str() {
            "breq" => true,
            "brne" => false,
            _ => return None,
        };
        let own = (first..=at).all(|n| !matches!(body.get(n), Some(Line::Fixed(_))));
        (own && here.contains_key(target) && target != name).then_some(Decision {
            label,
            name,
            register: number,
            branch: at,
            at_zero,
            target,
        })
    });
    let found: Vec<_> = found.collect();
    if found.is_empty() {
        return found;
    }
    let behind = needed_behind(function);
    let flags = |n: usize| behind[n] & (CARRY | FLAGS) != 0;
    found.into_iter().filter(|d| !flags(d.branch)).collect()
}

/// Has line `n` lead to where a decision by 0, or by 1, goes.
fn lead(
    body: &[Line],
    n: usize,
    decision: &Decision<'_>,
    zero: bool,
    count: &mut usize,
) -> Vec<Line> {
    let mut changed = body.to_vec();
    let behind = decision.branch + 1;
    let target = match body.get(behind) {
        _ if zero == decision.at_zero => decision.target.to_owned(),
        Some(Line::Label(name)) if name.starts_with(".L") => name.clone(),
        _ => {
            *count += 1;
            format!(".Ldecided{count}")
        }
    };
    let mut new = vec![(behind, Line::Label(target.clone()))];
    if labels(body).contains_key(target.as_str()) {
        new.clear();
    }
    match changed.get_mut(n) {
        Some(Line::Code(code)) => code.operands = vec![target],
        _ => new.push((n, Line::code(&format!("rjmp {target}")))),
    }
    // From the back, so that the lines before keep their numbers.
    new.sort_by_key(|(at, _)| std::cmp::Reverse(*at));
    for (at, line) in new {
        changed.insert(at, line);
    }
    changed
}
