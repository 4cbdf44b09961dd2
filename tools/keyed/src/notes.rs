//! What is wrong with a file so far.

use crate::mistake::Mistake;
use std::cell::RefCell;
use std::ops::Range;

/// The text of a file, and what is wrong with it so far.
#[derive(Debug)]
pub struct Notes<'t, W> {
    /// The byte at which each line begins.
    lines: Vec<usize>,
    /// The text.
    pub text: &'t str,
    mistakes: RefCell<Vec<Mistake<W>>>,
}

/// More mistakes than these are not told.
const MOST: usize = 100;

impl<'t, W> Notes<'t, W> {
    pub(crate) fn new(text: &'t str) -> Notes<'t, W> {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Notes {
            lines: std::iter::once(0)
                .chain(ends.map(|(at, _)| at + 1))
                .collect(),
            text,
            mistakes: RefCell::default(),
        }
    }

    /// Something is wrong, at these bytes of the text.
    pub fn wrong(&self, place: &Range<usize>, wrong: impl Into<W>) {
        let line = self
            .lines
            .partition_point(|start| *start <= place.start)
            .max(1);
        let mut mistakes = self.mistakes.borrow_mut();
        if mistakes.len() < MOST {
            let wrong = wrong.into();
            mistakes.push(Mistake { line, wrong });
        }
    }

    /// All that is wrong, in the order of the lines.
    pub(crate) fn mistakes(self) -> Vec<Mistake<W>> {
        let mut mistakes = self.mistakes.into_inner();
        mistakes.sort_by_key(|mistake| mistake.line);
        mistakes
    }
}
