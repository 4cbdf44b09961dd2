//! Notes what a statement shows, while its instructions are written.
//!
//! Owns which instruction it is known after. Must not know what a line makes of it: `traces` does.

use super::coder::Coder;
use super::traces::{Noted, Shows};
use unoclp_text::diagnostics::Span;
use unoclp_tree::Base;

impl Coder<'_, '_> {
    /// The statement at hand stores, or puts out, what is known after the last instruction.
    pub(super) fn shows(&mut self, shows: Shows) {
        self.note(self.pen.at, false, shows, None);
    }

    /// The line of this place tests what is known after the last instruction.
    pub(super) fn tests(&mut self, at: Span, shows: Shows) {
        self.note(at, true, shows, None);
    }

    /// The same, of a number.
    pub(super) fn tests_number(&mut self, at: Span, base: Base, cell: Option<u32>) {
        let variable = None;
        self.note(at, true, Shows::Number { base, variable }, cell);
    }

    /// The statement at hand stores a number of this type in this cell, by the last instruction.
    pub(super) fn shows_number(&mut self, base: Base, cell: u32) {
        if let Some(last) = self.pen.lines.len().checked_sub(1) {
            self.shows_number_at(last, base, cell);
        }
    }

    /// The same, by the instruction with this index.
    pub(super) fn shows_number_at(&mut self, line: usize, base: Base, cell: u32) {
        if self.shown {
            self.noted.push(Noted {
                line,
                at: self.pen.at,
                tests: false,
                shows: Shows::Number {
                    base,
                    variable: None,
                },
                cell: Some(cell),
            });
        }
    }

    fn note(&mut self, at: Span, tests: bool, shows: Shows, cell: Option<u32>) {
        if let Some(line) = self.pen.lines.len().checked_sub(1)
            && self.shown
        {
            self.noted.push(Noted {
                line,
                at,
                tests,
                shows,
                cell,
            });
        }
    }
}
