//! Copies and constants: what a register holds already is not put there again, a copy is taken from the
//! register that will hold the value longest, and what nothing needs any more is not put anywhere.

use super::assembly::{Code, Function, Line, Unit};
use super::effects::{Flow, effects, flow, register};
use super::frame::points_to_frame;
use super::liveness::needed_behind;
use super::values::{Registers, Walk};

/// Drops copies and constants in all functions. The functions must still be as the compiler made them:
/// its convention of calls tells what a call changes.
pub fn drop_superfluous(unit: &mut Unit) -> bool {
    let mut changed = false;
    for function in unit.functions_mut() {
        while drop_known(function) | drop_unneeded(function) {
            changed = true;
        }
    }
    changed
}

/// Goes through the code forward.
fn drop_known(function: &mut Function) -> bool {
    let mut walk = Walk::of(function);
    let mut kept = Vec::new();
    for line in &function.body {
        match line {
            Line::Code(code) if !walk.may_be_skipped() => {
                let copied = walk.copied(code);
                let holds = |&(to, value): &_| walk.registers.get(to) == value;
                if !copied.is_some_and(|copied| copied.iter().all(holds)) {
                    let source = lasting(&walk.registers, code);
                    kept.push(source.unwrap_or_else(|| line.clone()));
                }
            }
            _ => kept.push(line.clone()),
        }
        walk.pass(line);
    }
    let changed = kept != function.body;
    function.body = kept;
    changed
}

/// A copy of the same value from a register, or a pair, that calls leave alone.
fn lasting(registers: &Registers, copy: &Code) -> Option<Line> {
    let wide = match copy.name.as_str() {
        "mov" => false,
        "movw" => true,
        _ => return None,
    };
    // Of r1 everyone knows that it is 0.
    let from = register(copy.operand(1)).filter(|&n| n > 1)?;
    let equal = |n, from| registers.get(n) == registers.get(from);
    // Only of a pair is there a next one.
    let same = |&n: &u32| equal(n, from) && (!wide || n % 2 == 0 && equal(n + 1, from + 1));
    let first = (2..18).find(same).filter(|&n| n != from)?;
    Some(Line::Code(Code {
        name: copy.name.clone(),
        operands: vec![copy.operand(0).to_owned(), format!("r{first}")],
    }))
}

/// Goes through the code backward.
fn drop_unneeded(function: &mut Function) -> bool {
    let framed = points_to_frame(function);
    let needed = needed_behind(function);
    let mut after_skip = false;
    let mut kept = Vec::new();
    for (line, needed) in function.body.iter().zip(needed) {
        let drop = match line {
            Line::Code(code) if !after_skip && is_only_a_value(code, framed) => {
                effects(code).writes & needed == 0
            }
            _ => false,
        };
        if let Some(code) = line.instruction() {
            after_skip = flow(code) == Flow::Skip;
        }
        if !drop {
            kept.push(line.clone());
        }
    }
    let changed = kept.len() < function.body.len();
    function.body = kept;
    changed
}

/// Whether an instruction does nothing but to put a value into registers and flags. `framed` says that Y
/// points to the frame.
fn is_only_a_value(code: &Code, framed: bool) -> bool {
    const NAMES: [&str; 21] = [
        "mov", "movw", "ldi", "clr", "eor", "andi", "ori", "and", "or", "com", "lsr", "lsl", "ror",
        "rol", "swap", "add", "sub", "subi", "cp", "cpi", "cpc",
    ];
    // A slot of the frame is plain memory. By another pointer a read may be one of an I/O register.
    let slot = framed && code.name == "ldd" && code.operand(1).starts_with("Y+");
    // Of the frame and of r0, which the stack pointer's change needs, nothing is dropped.
    let kept = matches!(code.operand(0), "r28" | "r29" | "r0" | "r1");
    !kept && (slot || NAMES.contains(&code.name.as_str()))
}
