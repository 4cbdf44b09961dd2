//! Shared entries and exits, as avr-gcc's `-mcall-prologues` has them: one routine pushes registers and
//! makes room on the stack for all functions that keep r16 and more, one takes them back.
//!
//! The routines are chains with an entry for each first register: from there to r17, and r28 and r29
//! where there is room to make. An entry takes its return address from the stack, for it would lie
//! between the registers and the room. What it uses is free at the entry of a function: r26 (the bytes of
//! room), r30 and r31 (the return address), r0. So it is at an exit: r26, r27, r30 (the bytes of the
//! registers), r0; a result is in r18 to r25.

use std::collections::BTreeSet;

use super::assembly::{Function, Item, Line, Unit};
use super::effects::{Flow, flow};
use super::frame::{Frame, SET_STACK, frame, is_understood};

/// The first register that is kept for the caller in each routine, of those that are in use.
#[derive(Default)]
struct Entries {
    save: BTreeSet<u32>,
    frame: BTreeSet<u32>,
    unframe: BTreeSet<u32>,
}

/// Makes all functions share their entries and exits where that is shorter.
pub fn share(unit: &mut Unit) -> bool {
    let mut entries = Entries::default();
    for function in unit.functions_mut() {
        if !is_understood(function) {
            continue;
        }
        if let Some(frame) = frame(function) {
            replace(function, &frame, &mut entries);
        }
    }
    let before = unit.items.len();
    unit.items.extend(entries.routines().map(Item::Function));
    unit.items.len() > before
}

fn replace(function: &mut Function, frame: &Frame, entries: &mut Entries) {
    let returns = !frame.exits.is_empty() || leaves(function);
    let own = |register: &&u32| **register < 18;
    let lowest = frame.pushed.iter().filter(own).min().copied();
    // A function that does not return gives nothing back.
    let first = lowest.filter(|_| returns).unwrap_or(18);
    let entry: Vec<String>;
    let exit: Vec<String>;
    match frame.room {
        Some(room @ 1..=255) if returns != frame.exits.is_empty() => {
            entry = vec![format!("ldi r26, {room}"), format!("call __frame_r{first}")];
            exit = leave(room, first);
            entries.frame.insert(first);
            if returns {
                entries.unframe.insert(first);
            }
        }
        None if !returns => {
            entry = Vec::new();
            exit = Vec::new();
        }
        None if first <= 15 && !frame.exits.is_empty() => {
            entry = vec![format!("call __save_r{first}")];
            exit = (first..18)
                .rev()
                .map(|register| format!("pop r{register}"))
                .chain(["ret".to_owned()])
                .collect();
            entries.save.insert(first);
        }
        _ => return,
    }
    let lines = |codes: &[String]| {
        codes
            .iter()
            .map(|code| Line::code(code))
            .collect::<Vec<_>>()
    };
    for range in frame.exits.iter().rev() {
        function.body.splice(range.clone(), lines(&exit));
    }
    function.body.splice(frame.entry.clone(), lines(&entry));
}

/// Whether control leaves a function otherwise than by a call.
fn leaves(function: &Function) -> bool {
    let codes = function.body.iter().filter_map(Line::instruction);
    codes
        .clone()
        .any(|code| flow(code) == Flow::Leave || code.name == "jmp")
}

/// The exit of a function with room on the stack.
fn leave(room: u16, first: u32) -> Vec<String> {
    let mut exit = match room {
        ..=63 => vec![format!("adiw r28, {room}")],
        _ => {
            let [low, high] = 0_u16.wrapping_sub(room).to_le_bytes();
            vec![format!("subi r28, {low}"), format!("sbci r29, {high}")]
        }
    };
    exit.push(format!("ldi r30, {}", kept(first)));
    exit.push(format!("jmp __unframe_r{first}"));
    exit
}

/// The bytes on the stack from r29 to this register, and where it stands after Y.
fn kept(first: u32) -> u32 {
    20 - first
}

impl Entries {
    /// The routines themselves.
    fn routines(&self) -> impl Iterator<Item = Function> {
        let save = chain("save", &self.save, |register| format!("push r{register}"));
        let save = save.map(|mut lines| {
            lines.push(fixed("ijmp"));
            routine("__save", lines)
        });
        let frame = chain("frame", &self.frame, |register| format!("push r{register}"));
        let frame = frame.map(|mut lines| {
            #[rustfmt::skip]
            let room = [
                "push r28", "push r29",
                "in r28, 61", "in r29, 62", "sub r28, r26", "sbc r29, r1",
            ];
            lines.extend(room.iter().chain(&SET_STACK).map(|code| fixed(code)));
            lines.push(fixed("ijmp"));
            routine("__frame", lines)
        });
        let unframe = self.unframe.first().map(|&lowest| {
            let mut lines = Vec::new();
            for register in lowest..=18 {
                if self.unframe.contains(&register) {
                    lines.push(Line::Label(format!("__unframe_r{register}")));
                }
                if register < 18 {
                    lines.push(fixed(&format!("ldd r{register}, Y+{}", kept(register))));
                }
            }
            #[rustfmt::skip]
            let rest = ["ldd r26, Y+2", "ldd r27, Y+1", "add r28, r30", "adc r29, r1"];
            lines.extend(rest.iter().chain(&SET_STACK).map(|code| fixed(code)));
            lines.extend([fixed("movw r28, r26"), fixed("ret")]);
            routine("__unframe", lines)
        });
        save.into_iter().chain(frame).chain(unframe)
    }
}

/// Entries that take the return address into Z, and what they do for each register from theirs to r17.
/// `None` if there are no entries.
fn chain(name: &str, entries: &BTreeSet<u32>, code: impl Fn(u32) -> String) -> Option<Vec<Line>> {
    let &lowest = entries.first()?;
    let mut lines = Vec::new();
    // The lowest entry is the last: it goes on into the chain.
    for &register in entries.iter().rev() {
        lines.push(Line::Label(format!("__{name}_r{register}")));
        lines.extend([fixed("pop r31"), fixed("pop r30")]);
        if register != lowest {
            lines.push(fixed(&format!("rjmp .L{name}_r{register}")));
        }
    }
    for register in lowest..=18 {
        if entries.contains(&register) && register != lowest {
            lines.push(Line::Label(format!(".L{name}_r{register}")));
        }
        if register < 18 {
            lines.push(fixed(&code(register)));
        }
    }
    Some(lines)
}

fn fixed(text: &str) -> Line {
    Line::Fixed(super::assembly::Code::parse(text))
}

/// A function made of lines, in a section of its own.
pub fn routine(name: &str, body: Vec<Line>) -> Function {
    Function {
        head: vec![
            format!("\t.section\t.text.{name},\"ax\",@progbits"),
            format!("\t.type\t{name},@function"),
            format!("{name}:"),
        ],
        body,
        foot: vec![
            format!(".Lfunc_end{name}:"),
            format!("\t.size\t{name}, .Lfunc_end{name}-{name}"),
        ],
        name: name.to_owned(),
    }
}
