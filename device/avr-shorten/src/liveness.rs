//! Which registers and flags are still needed after each line of a function.

use super::assembly::{Code, Function, Line};
use super::body::{code_from, is_end, labels};
use super::effects::{ALL, Flow, RETURNED, Set, effects, flow};

/// For each line, what may be read after it before it is written.
pub fn needed_behind(function: &Function) -> Vec<Set> {
    let body = &function.body;
    let labels = labels(body);
    let mut before = vec![0; body.len() + 1];
    let mut behind = vec![0; body.len()];
    loop {
        let mut changed = false;
        for n in (0..body.len()).rev() {
            let next = before[n + 1];
            let Some(code) = body[n].instruction() else {
                changed |= before[n] != next;
                before[n] = next;
                behind[n] = next;
                continue;
            };
            let target = |label: &str| labels.get(label).map_or(ALL, |&at| before[at]);
            behind[n] = match flow(code) {
                Flow::Jump(label) => target(label) | skipped(body, n, next),
                Flow::Branch(label) => target(label) | next,
                Flow::Leave => RETURNED | skipped(body, n, next),
                Flow::Skip => {
                    let over = code_from(body, n + 1).map(|(over, _)| before[over + 1]);
                    next | over.unwrap_or(ALL)
                }
                Flow::Next | Flow::Call(_) | Flow::CallPointer => next,
            };
            let needed = needs(&body[n], code, behind[n]);
            changed |= needed != before[n];
            before[n] = needed;
        }
        if !changed {
            return behind;
        }
    }
}

/// What is needed after an instruction that may be skipped, on top of what it needs itself.
fn skipped(body: &[Line], n: usize, next: Set) -> Set {
    if is_end(body, n) { 0 } else { next }
}

/// What is needed before an instruction, by what is needed after it.
fn needs(line: &Line, code: &Code, behind: Set) -> Set {
    let effects = effects(code);
    let certain = match line {
        // What an `asm!` block calls takes what it likes, and says so only to the compiler.
        Line::Fixed(code) if matches!(flow(code), Flow::Call(_) | Flow::CallPointer) => return ALL,
        _ => effects.writes,
    };
    effects.reads | behind & !certain
}
