//! How much of the board a program takes.
//!
//! Owns the figures. Must not know where the program comes from.

use crate::kept::Kept;
use crate::used::Used;
use crate::words;
use std::collections::BTreeSet;
use unoclp_core::{Board, Program};
use unoclp_lang::Lang;

/// How much of the board a valid program takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Size {
    /// The board that it is for.
    pub board: Board,
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
    /// What it keeps over a power cut, if anything.
    pub kept: Option<Kept>,
}

impl Size {
    /// What this program takes.
    pub fn of(program: &Program<'_>) -> Size {
        Size {
            board: program.board(),
            codes: program.codes(),
            stored_bytes: program.stored_bytes(),
            linked_bytes: program.linked_bytes(),
            timers: program.timers(),
            used: Used::of(program.needs(), program.steps()),
            kept: Kept::of(program),
        }
    }
}

impl Size {
    /// In this language `12 codes, 15 of 900 bytes (885 free), 0 timers, 2 counters`, and on a line below what it takes
    /// while it runs and the pins that it uses.
    pub fn text(&self, lang: Lang) -> String {
        let used = &self.used;
        let some =
            |numbers: &BTreeSet<u8>, one: String, more: fn(Lang, usize) -> String| match numbers
                .len()
            {
                0 => None,
                1 => Some(one),
                count => Some(more(lang, count)),
            };
        let codes = match self.codes {
            1 => words::code(lang),
            codes => words::codes(lang, codes),
        };
        let timers = match self.timers {
            1 => words::timer(lang),
            timers => words::timers(lang, timers),
        };
        let parts = [
            Some(timers),
            some(&used.counters, words::counter(lang), words::counters),
            some(&used.registers, words::register(lang), words::registers),
            some(&used.markers, words::marker(lang), words::markers),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        let room = usize::from(self.board.stored_bytes);
        let free = room.saturating_sub(self.stored_bytes);
        let size = words::size(lang, codes, self.stored_bytes, room, free, parts.join(", "));
        let pins = match used.to_string() {
            pins if pins.is_empty() => words::no_pins(lang),
            pins => words::pins(lang, pins),
        };
        let run = words::run_memory(lang, self.linked_bytes, self.board.linked_bytes, pins);
        let kept = self.kept.map(|kept| format!("\n  {}", kept.told(lang)));
        format!("{size}\n  {run}{}", kept.unwrap_or_default())
    }
}
