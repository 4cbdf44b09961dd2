//! What the lines of a text show of a scan, each with the step after which that is known.
//!
//! Owns which statement shows what: a condition, a bit, a number. Must not know how it is drawn, nor where a scan is made.

use std::collections::HashMap;
use unoclp_text::diagnostics::{Lines, Span};
use unoclp_tree::{Base, Holds, Tree};

/// What a line shows of a scan that has run this step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trace {
    /// The step, in the order of the program.
    pub step: usize,
    /// The line of the text, from 1.
    pub line: usize,
    /// The character of the line, from 1.
    pub column: usize,
    /// Whether the line tests it: that is then what the line shows, whatever else it does.
    pub tests: bool,
    /// What it is.
    pub shows: Shows,
}

/// What is known after a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shows {
    /// acc, or its opposite.
    Power {
        /// Whether it is the opposite.
        inverted: bool,
    },
    /// A bit that is set or reset, where acc is this; elsewhere the line is not reached.
    Bit {
        /// acc where it is reached.
        when: bool,
        /// What it is set to.
        to: bool,
    },
    /// Whether this counter has reached its preset, or 0.
    Counter {
        /// Its number, from 1.
        number: u8,
        /// Whether 0 is asked for.
        zero: bool,
    },
    /// Whether the value is not 0, where acc is 1; elsewhere the line is not reached.
    Truth,
    /// The value, where acc is 1; elsewhere the line is not reached.
    Number {
        /// Its type.
        base: Base,
        /// The variable that holds it, by its index.
        variable: Option<usize>,
    },
}

/// The same, as it is written down: by the instruction among those of the pen, and by the cell of a number.
#[derive(Debug)]
pub(super) struct Noted {
    pub line: usize,
    pub at: Span,
    pub tests: bool,
    pub shows: Shows,
    pub cell: Option<u32>,
}

/// What has been noted, of a text whose program has so many steps before those of the pen.
pub(super) fn traces(noted: &[Noted], before: usize, tree: &Tree, text: &str) -> Vec<Trace> {
    let starts = Lines::new(text);
    let mut variables = HashMap::new();
    for (index, symbol) in tree.symbols.iter().enumerate() {
        let cells = match symbol.holds {
            Holds::Cell(cell) => [cell; 2],
            Holds::Either { set, clear, .. } => [set, clear],
        };
        for cell in cells {
            variables.entry(cell).or_insert(index);
        }
    }
    let trace = |noted: &Noted| {
        let (line, column) = starts.place(text, noted.at.start);
        let variable = noted.cell.and_then(|cell| variables.get(&cell).copied());
        Trace {
            step: before + noted.line,
            line: line as usize,
            column: column as usize,
            tests: noted.tests,
            shows: match noted.shows {
                Shows::Number {
                    base: Base::Bool, ..
                } => Shows::Truth,
                Shows::Number { base, .. } => Shows::Number { base, variable },
                other => other,
            },
        }
    };
    noted.iter().map(trace).collect()
}
