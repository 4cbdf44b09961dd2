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
        }
    }
}

impl Size {
    /// The same in Portuguese.
    pub fn in_portuguese(&self) -> String {
        let one_or_more = |count: usize, one: &str, more: &str| match count {
            1 => format!("1 {one}"),
            _ => format!("{count} {more}"),
        };
        let used = &self.used;
        let room = usize::from(BOARD.stored_bytes);
        let free = room.saturating_sub(self.stored_bytes);
        let mut parts = vec![
            one_or_more(self.codes.into(), "código", "códigos"),
            format!("{} de {room} bytes ({free} livres)", self.stored_bytes),
            one_or_more(self.timers, "temporizador", "temporizadores"),
        ];
        for (numbers, one, more) in [
            (&used.counters, "contador", "contadores"),
            (&used.registers, "registrador", "registradores"),
            (&used.markers, "memória", "memórias"),
        ] {
            if !numbers.is_empty() {
                parts.push(one_or_more(numbers.len(), one, more));
            }
        }
        let (linked, room) = (self.linked_bytes, BOARD.linked_bytes);
        format!(
            "{}\n  {linked} de {room} bytes de memória de execução; pinos: {used}",
            parts.join(", ")
        )
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
        )
    }
}
