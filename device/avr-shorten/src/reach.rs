//! The last word on branches: one reaches 64 words back and 63 ahead. Where that is not enough, it goes
//! by way of a jump: one that stands in between anyway, or one of its own.

use super::assembly::{Code, Function, Line, Unit};
use super::body::{is_scan, labels, offsets};
use super::effects::{Flow, flow, opposite};

/// Makes all branches reach. Says whether one did not.
pub fn mend(unit: &mut Unit) -> bool {
    let mut count = 0;
    for function in unit.functions_mut() {
        while let Some((n, target)) = too_far(function) {
            count += 1;
            match relay(function, n, &target) {
                Some(at) if !is_scan(function) => by_way_of(function, n, at, count),
                _ => by_its_own(function, n, count),
            }
        }
    }
    count > 0
}

/// Whether a branch at one byte reaches another.
fn reaches(from: usize, to: usize) -> bool {
    if to > from {
        to - from <= 2 + 2 * 63
    } else {
        from - to <= 2 * 63
    }
}

/// The first branch that does not reach its target.
fn too_far(function: &Function) -> Option<(usize, String)> {
    let offsets = offsets(&function.body);
    let labels = labels(&function.body);
    function.body.iter().enumerate().find_map(|(n, line)| {
        let Line::Code(code) = line else {
            return None;
        };
        let Flow::Branch(target) = flow(code) else {
            return None;
        };
        let near = labels
            .get(target)
            .is_some_and(|&at| reaches(offsets[n], offsets[at]));
        (!near).then(|| (n, target.to_owned()))
    })
}

/// The line of a jump to the target that line `n` reaches.
fn relay(function: &Function, n: usize, target: &str) -> Option<usize> {
    let offsets = offsets(&function.body);
    function.body.iter().enumerate().find_map(|(at, line)| {
        let jump = Code::parse(&format!("rjmp {target}"));
        // Some room is left: another branch in between may still grow.
        let near = reaches(offsets[n], offsets[at] + 16) && reaches(offsets[n] + 16, offsets[at]);
        (*line == Line::Code(jump) && near).then_some(at)
    })
}

fn by_way_of(function: &mut Function, n: usize, at: usize, count: usize) {
    let label = format!(".Lvia{count}");
    if let Some(Line::Code(code)) = function.body.get_mut(n) {
        code.operands = vec![label.clone()];
    }
    function.body.insert(at, Line::Label(label));
}

/// `breq far` becomes `brne 1f; rjmp far; 1:`.
fn by_its_own(function: &mut Function, n: usize, count: usize) {
    let label = format!(".Lnear{count}");
    let Some(Line::Code(branch)) = function.body.get_mut(n) else {
        return;
    };
    let far = std::mem::replace(&mut branch.operands, vec![label.clone()]);
    branch.name = opposite(&branch.name).unwrap_or_default().to_owned();
    let jump = Code {
        name: "rjmp".to_owned(),
        operands: far,
    };
    let rest = [Line::Code(jump), Line::Label(label)];
    function.body.splice(n + 1..n + 1, rest);
}
