//! What can be wrong with a scenario file.
//!
//! Owns the cases as values. Must not know their words: `shown` does.

use super::Unreadable;
use unoclp_core::{Board, Millis};

/// Why a scenario could not be read: the file, the line where there is one, and what is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadError {
    /// The path of the scenario's file.
    pub file: String,
    /// The line, counted from 1; none where the whole file is meant.
    pub line: Option<usize>,
    /// What is wrong.
    pub wrong: Wrong,
}

/// What is wrong with a scenario file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wrong {
    /// The file itself.
    Unreadable(Unreadable),
    /// It is no TOML, or a value is of the wrong kind.
    Toml {
        /// What the reader of TOML says, in English.
        told: String,
    },
    /// A key stands in a step, and belongs to the whole file.
    KeyInStep {
        /// What the reader of TOML says, in English.
        told: String,
        /// The key.
        key: String,
    },
    /// The program cannot be read.
    Program {
        /// Its file.
        name: String,
        /// Why.
        why: Unreadable,
    },
    /// The program in Instruction List has errors.
    FaultyProgram {
        /// Its file.
        name: String,
    },
    /// It names no program.
    NoProgram,
    /// It gives a program to write again and no language, or the other way round.
    GivenAlone,
    /// It asks for a language that is none.
    NoLanguage,
    /// The program that it gives has errors.
    FaultyGiven,
    /// It hides a fault in no machine.
    FindWithout,
    /// There are seeds, and no machine.
    SeedsWithout,
    /// There are too many seeds.
    ManySeeds {
        /// So many there may be.
        most: usize,
    },
    /// It gives two programs.
    TwoPrograms,
    /// The text of its program is too long.
    LongText {
        /// The most bytes.
        most: u64,
    },
    /// It expects a fault of the file, and that the program runs.
    FaultAndSteps,
    /// There is no fault of this number.
    NoFault {
        /// The number.
        number: u8,
    },
    /// A fault stands in line 0.
    LineZero,
    /// The scans stand still.
    NoPeriod,
    /// Its last step comes after its end.
    EndsEarly {
        /// The last step, in ms after the first scan.
        last: Millis,
    },
    /// Its runs take too long.
    TooManyScans {
        /// How many scans they come to, up to there.
        scans: u64,
    },
    /// It has neither a title, nor what it is about.
    NoTitle,
    /// It names a board that there is not.
    NoBoard {
        /// The name.
        name: String,
    },
    /// It has cases, and steps beside them.
    CasesAndSteps,
    /// It has more than one case where one is run.
    SeveralCases {
        /// How many.
        count: usize,
    },
    /// A name is given to what is no point.
    NotNamed {
        /// The point.
        name: String,
        /// The board that it is none of.
        board: Box<Board>,
    },
    /// There is nothing to run.
    NothingHappens,
    /// Something comes after the fault that ends the run.
    GoesOn,
    /// No scan runs at this time.
    NoScan {
        /// In ms after the first scan.
        at: Millis,
        /// ms from scan to scan.
        period: u32,
    },
    /// A step stands after a later one.
    Order {
        /// The step, in ms after the first scan.
        at: Millis,
        /// The one before it.
        last: Millis,
    },
    /// This cannot be set.
    NotSet {
        /// What.
        name: String,
        /// The board that it is none of.
        board: Box<Board>,
    },
    /// Nothing can be expected of this.
    NotExpected {
        /// What.
        name: String,
        /// The board that it is none of.
        board: Box<Board>,
    },
    /// A value is none that the place can have.
    Value {
        /// The place.
        name: String,
        /// The least value.
        from: i32,
        /// The greatest.
        to: i32,
        /// Whether `"any"` is right too.
        or_any: bool,
    },
}
