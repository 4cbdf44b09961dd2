//! How much of the board a program takes.
//!
//! Owns the figures and their words. Must not know where the program comes from.

use crate::BOARD;
use crate::used::Used;
use std::fmt;
use unoclp_core::Program;

/// How much of the board a valid program takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Size {
    /// Codes in the file.
    pub codes: u16,
    /// Bytes of program memory.
    pub stored_bytes: usize,
    /// Bytes of run memory.
    pub linked_bytes: usize,
    /// Timers.
    pub timers: usize,
    /// What it uses of the board and its memory.
    pub used: Used,
    /// Numbers that outlast a power cut, and how old they may be then, minutes.
    pub kept: Option<(u8, u16)>,
}

impl Size {
    /// What this program takes.
    pub fn of(program: &Program<'_>) -> Size {
        Size {
            codes: program.codes(),
            stored_bytes: program.stored_bytes(),
            linked_bytes: program.linked_bytes(),
            timers: program.timers(),
            used: Used::of(program),
            kept: program
                .kept_within(&BOARD)
                .map(|minutes| (program.kept_count(), minutes)),
        }
    }
}

impl fmt::Display for Size {
    /// `12 codes, 15 of 900 bytes (885 free), 0 timers, 2 counters`, and on a line below what it takes
    /// while it runs and the pins that it uses
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Size {
            codes,
            stored_bytes,
            linked_bytes,
            timers,
            ref used,
            kept,
        } = *self;
        let room = usize::from(BOARD.stored_bytes);
        let free = room.saturating_sub(stored_bytes);
        let code = if codes == 1 { "code" } else { "codes" };
        let timer = if timers == 1 { "timer" } else { "timers" };
        write!(
            f,
            "{codes} {code}, {stored_bytes} of {room} bytes ({free} free), {timers} {timer}"
        )?;
        let more = [
            (&used.counters, "counter"),
            (&used.registers, "register"),
            (&used.markers, "marker"),
        ];
        for (numbers, name) in more {
            match numbers.len() {
                0 => {}
                1 => write!(f, ", 1 {name}")?,
                count => write!(f, ", {count} {name}s")?,
            }
        }
        let room = BOARD.linked_bytes;
        write!(
            f,
            "\n  {linked_bytes} of {room} bytes of run memory; pins: {used}"
        )?;
        match kept {
            Some((numbers, minutes)) => write!(f, "\n  {}", kept_en(numbers, minutes)),
            None => Ok(()),
        }
    }
}

/// `2 numbers are kept, after a power cut as of at most 9 minutes ago`
pub fn kept_en(numbers: u8, minutes: u16) -> String {
    let are = if numbers == 1 {
        "number is"
    } else {
        "numbers are"
    };
    let unit = if minutes == 1 { "minute" } else { "minutes" };
    format!("{numbers} {are} kept, after a power cut as of at most {minutes} {unit} ago")
}

/// The same in Portuguese.
pub fn kept_pt(numbers: u8, minutes: u16) -> String {
    let are = match numbers {
        1 => "número é retido",
        _ => "números são retidos",
    };
    let unit = if minutes == 1 { "minuto" } else { "minutos" };
    format!("{numbers} {are}; após falta de energia, como há no máximo {minutes} {unit}")
}
