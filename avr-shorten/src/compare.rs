//! Comparisons with 0 behind an operation that has set the flags by its result.

use super::assembly::{Function, Line, Unit};
use super::body::{code_from, may_be_skipped};
use super::effects::CARRY;
use super::liveness::needed_behind;

/// What sets Z, N, V and S by its result as `cpi result, 0` does, V being 0.
const SETS: [&str; 5] = ["and", "andi", "or", "ori", "eor"];

/// Drops such comparisons where the carry, which only they clear, is not needed.
pub fn drop_superfluous(unit: &mut Unit) -> bool {
    let mut changed = false;
    for function in unit.functions_mut() {
        while let Some(n) = superfluous(function) {
            function.body.remove(n);
            changed = true;
        }
    }
    changed
}

/// The line of the first one.
fn superfluous(function: &Function) -> Option<usize> {
    let body = &function.body;
    let candidates = (0..body.len()).filter_map(|n| {
        let Some(Line::Code(sets)) = body.get(n) else {
            return None;
        };
        let (at, compares) = code_from(body, n + 1)?;
        let zero = compares.is(&format!("cpi {}, 0", sets.operand(0)))
            || compares.is(&format!("tst {}", sets.operand(0)));
        let own = matches!(body.get(at), Some(Line::Code(_)));
        (zero && own && SETS.contains(&sets.name.as_str()) && !may_be_skipped(body, n))
            .then_some(at)
    });
    let candidates: Vec<usize> = candidates.collect();
    if candidates.is_empty() {
        return None;
    }
    let needed = needed_behind(function);
    candidates.into_iter().find(|&n| needed[n] & CARRY == 0)
}
