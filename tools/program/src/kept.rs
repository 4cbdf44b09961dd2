//! What a program keeps over a power cut (NC-21), in words.
//!
//! How old a number may be is decided in the core.

use crate::words;
use unoclp_core::Program;
use unoclp_lang::Lang;

/// What a program keeps over a power cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kept {
    /// How many numbers, at least one.
    pub numbers: u8,
    /// How old they may be then, minutes.
    pub minutes: u16,
}

impl Kept {
    /// What this program keeps; none where it keeps nothing.
    pub fn of(program: &Program<'_>) -> Option<Kept> {
        let minutes = program.kept_within()?;
        let numbers = program.kept_count();
        Some(Kept { numbers, minutes })
    }

    /// `after a power cut: 2 numbers, at most 9 minutes old`
    pub fn told(self, lang: Lang) -> String {
        let minutes = match self.minutes {
            1 => words::minute(lang),
            minutes => words::minutes(lang, minutes),
        };
        match self.numbers {
            1 => words::kept_number(lang, minutes),
            numbers => words::kept_numbers(lang, numbers, minutes),
        }
    }
}
