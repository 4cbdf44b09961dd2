//! Values that are put aside and used once, at once: they go where they are used.
//!
//! Owns that one rewriting. Must not know the board.

use super::flat::{
    Does, Flat, Step, each, expr, own_expressions, own_expressions_mut, parts_mut, within,
};
use super::uses::Uses;
use std::collections::HashMap;
use unoclp_tree::{Base, Convert, Expr, ExprKind, Place, Standard, Store, counter};

/// A larger expression, in operands and operations, stays where it is: so no chain of them becomes one of any depth.
const MOST: usize = 200;

/// Rewrites a program; `own` is how many cells are not those of calls.
pub(super) fn merge(flat: &mut Flat, own: u32) {
    let uses = Uses::of(flat);
    let body = std::mem::take(&mut flat.body);
    flat.body = merged(body, &uses, own);
}

fn merged(steps: Vec<Step>, uses: &Uses, own: u32) -> Vec<Step> {
    let mut out: Vec<Step> = Vec::with_capacity(steps.len());
    for mut step in steps {
        while let Some(cell) = out.last().and_then(|last| once(last, uses, own)) {
            if !reads(&step.does, cell) {
                break;
            }
            let Some(Step {
                does: Does::Assign(_, value, store),
                ..
            }) = out.pop()
            else {
                break;
            };
            let Store::Narrow(base) = store else {
                break;
            };
            let value = as_stored(value, base);
            for expr in own_expressions_mut(&mut step.does) {
                put(expr, cell, &value);
            }
        }
        step.does = step.does.with_inner(&mut |steps| merged(steps, uses, own));
        out.push(step);
    }
    out
}

/// The cell that this step stores to, if that is stored once and read once.
fn once(step: &Step, uses: &Uses, own: u32) -> Option<u32> {
    let Does::Assign(to, value, Store::Narrow(_)) = &step.does else {
        return None;
    };
    let of = uses.get(to.offset)?;
    let mut size = 0;
    each(value, &mut |_| size += 1);
    let single = to.indices.is_empty() && to.offset >= own && of.reads == 1 && of.stores == 1;
    (single && size <= MOST && uses.row_of(to.offset).is_none()).then_some(to.offset)
}

fn is_read_of(place: &Place, cell: u32) -> bool {
    place.offset == cell && place.indices.is_empty()
}

fn reads(does: &Does, cell: u32) -> bool {
    let mut found = false;
    for expr in own_expressions(does) {
        each(expr, &mut |e| {
            if let ExprKind::Read(place) = &e.kind {
                found |= is_read_of(place, cell);
            }
        });
    }
    found
}

fn put(into: &mut Expr, cell: u32, value: &Expr) {
    if let ExprKind::Read(place) = &into.kind
        && is_read_of(place, cell)
    {
        *into = value.clone();
        return;
    }
    for part in parts_mut(into) {
        put(part, cell, value);
    }
}

/// As the cell would hold it.
fn as_stored(value: Expr, base: Base) -> Expr {
    let whole = matches!(base.bits(), 1 | 32) || base.is_real();
    if whole && value.base == base {
        return value;
    }
    if let ExprKind::Constant(held) = &value.kind
        && value.base == base
    {
        let kind = ExprKind::Constant(unoclp_tree::narrow(base, held.clone()));
        return Expr { kind, ..value };
    }
    let at = value.at;
    let how = match base {
        _ if base.is_real() || base == value.base && base.bits() == 32 => Convert::Keep,
        _ => Convert::Wrap,
    };
    expr(ExprKind::Convert(how, Box::new(value)), base, at)
}

/// Gives each block of the standard the inputs that are stored right before its calls and read by nothing else.
pub(super) fn gather(flat: &mut Flat) {
    let uses = Uses::of(flat);
    let mut near = HashMap::new();
    count(&flat.body, &uses, &mut near);
    let is_whole = |cell: u32, block: Standard, part: u32| {
        let near = near.get(&cell).copied().unwrap_or(0);
        let calls = uses
            .blocks
            .get(&(cell - part))
            .map_or(0, |called| called.count);
        let stores = uses.get(cell).map_or(0, |of| of.stores);
        stores == near && (near == calls || stays(block, part))
    };
    let body = std::mem::take(&mut flat.body);
    flat.body = gathered(body, &uses, &is_whole);
}

/// Whether a call that does not give this part goes on with it as the board keeps it: what is counted has not risen since
/// the call that gave it, and the preset of a board's counter stays.
fn stays(block: Standard, part: u32) -> bool {
    match block.plain() {
        Standard::Ctu | Standard::Ctd => part == 0,
        Standard::Ctud => part < 2,
        Standard::Counter => part < 2 || part == counter::PRESET,
        _ => false,
    }
}

/// How often each input is stored right before a call.
fn count(steps: &[Step], uses: &Uses, near: &mut HashMap<u32, u32>) {
    for (at, step) in steps.iter().enumerate() {
        if let Does::Standard(block, cell, _) = &step.does {
            let members = *cell..*cell + block.cells();
            let mut seen = Vec::new();
            for step in steps[..at].iter().rev() {
                match input(step, &members, uses) {
                    Some(input) if !seen.contains(&input) => seen.push(input),
                    _ => break,
                }
            }
            for cell in seen {
                *near.entry(cell).or_default() += 1;
            }
        }
        for inner in within(&step.does) {
            count(inner, uses, near);
        }
    }
}

fn gathered(
    steps: Vec<Step>,
    uses: &Uses,
    is_whole: &impl Fn(u32, Standard, u32) -> bool,
) -> Vec<Step> {
    let mut out: Vec<Step> = Vec::with_capacity(steps.len());
    for mut step in steps {
        if let Does::Standard(block, cell, inputs) = &mut step.does {
            let members = *cell..*cell + block.cells();
            let (mut seen, mut others) = (Vec::new(), Vec::new());
            while let Some(input) = out.last().and_then(|last| input(last, &members, uses))
                && !seen.contains(&input)
            {
                seen.push(input);
                let part = input - *cell;
                match out.pop() {
                    Some(Step {
                        does: Does::Assign(_, value, Store::Narrow(base)),
                        ..
                    }) if is_whole(input, *block, part) => {
                        inputs.push((part, as_stored(value, base)));
                    }
                    other => others.extend(other),
                }
            }
            // None of them is read before the call.
            out.extend(others.into_iter().rev());
        }
        step.does = step
            .does
            .with_inner(&mut |steps| gathered(steps, uses, is_whole));
        out.push(step);
    }
    out
}

/// The input of a block that this step stores, where nothing reads that but its calls.
fn input(step: &Step, members: &std::ops::Range<u32>, uses: &Uses) -> Option<u32> {
    let Does::Assign(to, _, Store::Narrow(_)) = &step.does else {
        return None;
    };
    let of = uses.get(to.offset)?;
    let alone = to.indices.is_empty() && of.reads == 0;
    let alone = alone && members.contains(&to.offset) && uses.row_of(to.offset).is_none();
    alone.then_some(to.offset)
}
