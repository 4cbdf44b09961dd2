//! How a function begins and ends: the registers that it pushes, the room that it makes on the stack
//! and reaches by Y, and each of its exits.

use std::ops::Range;

use super::assembly::{Code, Function, Line};
use super::body::code_from;
use super::effects::{Flow, Set, effects, flow, register};

/// The stack pointer's low byte, as an I/O address.
const SPL: &str = "61";

/// What stands at the entry of a function and before each `ret`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// The registers that are pushed, in this order.
    pub pushed: Vec<u32>,
    /// The bytes of room, if Y is set to the stack pointer at all.
    pub room: Option<u16>,
    /// The lines of the entry.
    pub entry: Range<usize>,
    /// The lines of each exit, with its `ret`.
    pub exits: Vec<Range<usize>>,
}

/// Takes the stack pointer over from Y, with interrupts off in between.
pub const SET_STACK: [&str; 5] = [
    "in r0, 63",
    "cli",
    "out 62, r29",
    "out 63, r0",
    "out 61, r28",
];

/// Reads entry and exits of a function. `None` if they are not as the compiler usually makes them.
pub fn frame(function: &Function) -> Option<Frame> {
    let body = &function.body;
    let mut pushed = Vec::new();
    let mut at = 0;
    while let Some((n, code)) = code_from(body, at).filter(|(_, code)| code.name == "push") {
        pushed.push(register(code.operand(0))?);
        at = n + 1;
    }
    let mut room = None;
    if let Some(n) = expect(body, at, &["in r28, 61", "in r29, 62"]) {
        let (n, less) = y_moved(body, n)?;
        at = expect(body, n, &SET_STACK)?;
        room = Some(0_u16.wrapping_sub(less));
    }
    let mut frame = Frame {
        pushed,
        room,
        entry: 0..at,
        exits: Vec::new(),
    };
    for n in at..body.len() {
        if matches!(body.get(n), Some(Line::Code(code)) if code.name == "ret") {
            frame.exits.push(exit(body, n, &frame)?);
        }
    }
    Some(frame)
}

/// The lines of the exit that ends at line `ret`.
fn exit(body: &[Line], ret: usize, frame: &Frame) -> Option<Range<usize>> {
    let moves = match frame.room {
        None => 0,
        Some(0..=63) => 1,
        Some(_) => 2,
    };
    let sets = if frame.room.is_some() {
        SET_STACK.len()
    } else {
        0
    };
    let start = ret.checked_sub(frame.pushed.len() + moves + sets)?;
    let mut at = start;
    if let Some(room) = frame.room {
        let (n, more) = y_moved(body, at)?;
        at = expect(body, n, &SET_STACK)?;
        if more != room {
            return None;
        }
    }
    for register in frame.pushed.iter().rev() {
        at = expect(body, at, &[&format!("pop r{register}")])?;
    }
    (at == ret).then_some(start..ret + 1)
}

/// The line after these instructions, if they stand from line `at` on.
fn expect(body: &[Line], mut at: usize, codes: &[&str]) -> Option<usize> {
    for expected in codes {
        let (n, code) = code_from(body, at)?;
        if !code.is(expected) {
            return None;
        }
        at = n + 1;
    }
    Some(at)
}

/// By how much Y is moved at line `at`, modulo 65,536, and the line after that.
fn y_moved(body: &[Line], at: usize) -> Option<(usize, u16)> {
    moved(body, at, 28)
}

/// The same for the register pair that begins with `low`.
fn moved(body: &[Line], at: usize, low: u32) -> Option<(usize, u16)> {
    let (n, code) = code_from(body, at)?;
    if code.operand(0) != format!("r{low}") {
        return None;
    }
    let number = |code: &Code| Some(code.operand(1).parse::<i32>().ok()?.rem_euclid(65_536) as u16);
    match code.name.as_str() {
        "adiw" => Some((n + 1, number(code)?)),
        "sbiw" => Some((n + 1, 0_u16.wrapping_sub(number(code)?))),
        "subi" => {
            let (m, high) = code_from(body, n + 1)?;
            let carries = high.name == "sbci" && high.operand(0) == format!("r{}", low + 1);
            let [low, _] = number(code)?.to_le_bytes();
            let [high, _] = carries.then(|| number(high))??.to_le_bytes();
            Some((m + 1, 0_u16.wrapping_sub(u16::from_le_bytes([low, high]))))
        }
        _ => None,
    }
}

/// Whether a function is known to take nothing from its caller's stack, nor to look at the stack pointer
/// between entry and exits: each of its uses of Y is one of its own frame.
pub fn is_understood(function: &Function) -> bool {
    let Some(frame) = frame(function) else {
        return false;
    };
    let body = &function.body;
    let in_exit = |n| frame.exits.iter().any(|exit| exit.contains(&n));
    // Y is moved to reach what is far from it, and back at once.
    let mut moved_by = 0_u16;
    let mut at = frame.entry.end;
    while let Some(line) = body.get(at) {
        let code = match line {
            Line::Code(code) if !in_exit(at) => code,
            Line::Label(_) if moved_by != 0 => return false,
            _ => {
                at += 1;
                continue;
            }
        };
        if moved_by != 0 && !matches!(flow(code), Flow::Next) {
            return false;
        }
        if let (Some(_), Some((next, by))) = (frame.room, y_moved(body, at)) {
            moved_by = moved_by.wrapping_add(by);
            at = next;
            continue;
        }
        let within = |offset: u16| offset.wrapping_add(moved_by) <= frame.room.unwrap_or(0);
        let understood = match code.name.as_str() {
            "ldd" | "std" | "ld" | "st" => code.operands.iter().all(|operand| {
                let Some(offset) = operand.strip_prefix('Y') else {
                    return true;
                };
                match offset.strip_prefix('+').unwrap_or("0").parse() {
                    Ok(offset) => frame.room.is_some() && within(offset),
                    Err(_) => false,
                }
            }),
            "movw" if code.operand(1) == "r28" => copy_is_understood(body, at, code, &within),
            "push" | "pop" | "in" | "out"
                if code.operands.iter().any(|o| o == SPL || o == "62") =>
            {
                false
            }
            "push" | "pop" => false,
            _ => !code.operands.iter().any(|o| o == "r28" || o == "r29"),
        };
        if !understood {
            return false;
        }
        at += 1;
    }
    moved_by == 0
}

/// Whether Y points to the frame wherever a function uses it: the entry sets it to the stack pointer, and
/// up to the exits nothing writes to it but what moves it to reach a far slot, and back at once.
pub fn points_to_frame(function: &Function) -> bool {
    const Y: Set = 3 << 28;
    let Some(frame) = frame(function).filter(|frame| frame.room.is_some()) else {
        return false;
    };
    let body = &function.body;
    let mut moved_by = 0_u16;
    let mut at = frame.entry.end;
    while let Some(line) = body.get(at) {
        if let Some(exit) = frame.exits.iter().find(|exit| exit.contains(&at)) {
            at = exit.end;
            continue;
        }
        if let (Line::Code(_), Some((next, by))) = (line, y_moved(body, at)) {
            moved_by = moved_by.wrapping_add(by);
            at = next;
            continue;
        }
        let code = line.instruction();
        let straight = code.map_or(!matches!(line, Line::Label(_)), |c| flow(c) == Flow::Next);
        if code.is_some_and(|code| effects(code).writes & Y != 0) || moved_by != 0 && !straight {
            return false;
        }
        at += 1;
    }
    true
}

/// Whether an address that begins as a copy of Y stays within the frame: what is added comes soon.
fn copy_is_understood(
    body: &[Line],
    at: usize,
    copy: &Code,
    within: &impl Fn(u16) -> bool,
) -> bool {
    const SOON: usize = 4;
    let Some(low) = register(copy.operand(0)) else {
        return false;
    };
    (at + 1..=at + SOON)
        .find_map(|n| moved(body, n, low))
        .is_some_and(|(_, by)| within(by))
}
