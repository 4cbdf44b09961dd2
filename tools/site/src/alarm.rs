//! An alarm: a condition over points of boards, and what is said where it holds.

use std::time::Duration;
use unoclp_lang::Condition;
use unoclp_program::Lang;

/// Whether a board is there, in a condition: a BOOL that each board has unless its program calls a point so.
pub const UP: &str = "up";

/// An alarm.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Alarm {
    /// What it is called, as no other alarm of the site is.
    pub name: String,
    /// When it comes.
    pub when: When,
    /// How long the condition holds before it comes.
    pub lasts: Duration,
    /// What is said of it.
    pub text: Text,
    /// How severe it is.
    pub severity: Severity,
}

/// A condition of Structured Text over points of boards.
#[derive(Clone, Debug)]
pub struct When {
    /// As the file has it.
    pub text: String,
    /// What it says.
    pub condition: Condition,
    /// The points that it reads, each with its number in the condition.
    pub reads: Vec<(usize, Reading)>,
}

impl When {
    /// The boards whose points it reads, each once.
    pub fn boards(&self) -> Vec<String> {
        let boards = self.reads.iter().map(|(_, reading)| &*reading.board);
        let boards: std::collections::BTreeSet<&str> = boards.collect();
        boards.into_iter().map(str::to_owned).collect()
    }
}

/// A point that a condition reads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reading {
    /// The board.
    pub board: String,
    /// The point, or [`UP`].
    pub point: String,
    /// Of which type its value is.
    pub sort: Sort,
}

/// Of which type a value is in a condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sort {
    /// BOOL: whether the board is there.
    Up,
    /// BOOL.
    Bit,
    /// DINT.
    Whole,
    /// REAL.
    Real,
}

/// What is said, in the two languages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text {
    /// In English.
    pub en: String,
    /// In Portuguese.
    pub pt: String,
}

/// How severe an alarm is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Somebody should know.
    Low,
    /// Somebody should look.
    Medium,
    /// Somebody has to act.
    High,
}

impl Severity {
    /// As the file has it, and other programs are told.
    pub fn word(self) -> &'static str {
        match self {
            Severity::Low => "low",
            Severity::Medium => "medium",
            Severity::High => "high",
        }
    }
}

impl Text {
    /// In this language.
    pub fn of(&self, lang: Lang) -> &str {
        match lang {
            Lang::En => &self.en,
            Lang::Pt => &self.pt,
        }
    }
}

// The same text over the same points is the same condition.
impl PartialEq for When {
    fn eq(&self, other: &When) -> bool {
        (&self.text, &self.reads) == (&other.text, &other.reads)
    }
}

impl Eq for When {}
