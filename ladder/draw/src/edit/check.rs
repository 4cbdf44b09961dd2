//! What is wrong in a document, each at its element.
//!
//! What the codes of a document mean, and what fits on a board, the loader of the core says; only what has no code is
//! found here.

use super::document::{Document, Id, Node};
use super::emit::{Code, Emitted, What};
use super::step::Step;
use unoclp_checked::Checked;
use unoclp_core::isa::{Class, START};
use unoclp_core::{Board, Cause, Fault};

/// What is wrong in a document, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// The element, or else the path, the block, the parallel or the rung; none where the program as a whole is wrong.
    pub at: Option<Id>,
    /// What is wrong.
    pub what: Wrong,
}

/// What may be wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrong {
    /// An element lacks its address, or an operand.
    Missing,
    /// More parallels stand in each other than there are branch points.
    NoPointLeft,
    /// Nothing stands on a path, which so is a bridge: all that stands beside it has no effect. A program may be so.
    Bridge,
    /// Nothing that it could drive follows, so it has no effect. A program may have that.
    LeadsNowhere,
    /// What the loader says of its code.
    Fault(Cause),
}

impl Wrong {
    /// Its number, which keeps its meaning: that of the fault, or one that no fault has.
    pub fn number(self) -> u8 {
        match self {
            Wrong::Missing => 1,
            Wrong::NoPointLeft => 2,
            Wrong::Bridge => 3,
            Wrong::LeadsNowhere => 4,
            Wrong::Fault(cause) => cause.number(),
        }
    }

    /// Whether no board takes a program of which that is true.
    pub fn is_error(self) -> bool {
        !matches!(self, Wrong::Bridge | Wrong::LeadsNowhere)
    }
}

impl Document {
    /// What is wrong in it; without an error a board takes it.
    pub fn check(&self, board: Board) -> Vec<Mistake> {
        Emitted::of(self).check(board)
    }

    /// Its codes, operands and program start among them, as a program file has them line by line.
    ///
    /// # Errors
    /// As of [`Emitted::codes`].
    pub fn codes(&self) -> Result<Vec<i32>, Vec<Mistake>> {
        Emitted::of(self).codes()
    }
}

impl Emitted<'_> {
    /// What is wrong in the document; without an error a board takes it.
    pub fn check(&self, board: Board) -> Vec<Mistake> {
        let mut mistakes = self.mistakes();
        let (text, owners) = text(self);
        let mut told = |fault: Fault| {
            let line = fault.line.and_then(|line| usize::try_from(line).ok());
            let at = line.and_then(|line| owners.get(line.wrapping_sub(2)));
            let (at, what) = (at.copied(), Wrong::Fault(fault.cause));
            mistakes.push(Mistake { at, what });
        };
        // What is wrong with it is told as it comes.
        let _ = Checked::new(board, |loader| {
            for byte in text.bytes() {
                loader.push(byte).unwrap_or_else(&mut told);
            }
            while let Err(fault) = loader.end() {
                told(fault);
            }
        });
        once(mistakes)
    }

    /// What is wrong in the document whose codes the board is known to take: what has no effect.
    pub fn mistakes(&self) -> Vec<Mistake> {
        let mut mistakes = Vec::new();
        let mut says = |at, what| mistakes.push(Mistake { at: Some(at), what });
        let missing = self.codes.iter().filter(|code| code.lacks_something());
        missing.for_each(|code| says(code.of, Wrong::Missing));
        let without = self.without_point.iter();
        without.for_each(|&parallel| says(parallel, Wrong::NoPointLeft));
        let bridges = self.holes.iter();
        bridges.for_each(|&(_, path)| says(path, Wrong::Bridge));
        for rung in self.document.rungs() {
            idle(&rung.series, &mut |id| says(id, Wrong::LeadsNowhere));
        }
        once(mistakes)
    }

    /// The codes, operands and program start among them, as a program file has them line by line.
    ///
    /// # Errors
    /// What is missing, and parallels for which there is no branch point. Whether a board takes the codes is the
    /// loader's to say.
    pub fn codes(&self) -> Result<Vec<i32>, Vec<Mistake>> {
        let mut codes = vec![START];
        let mut mistakes = Vec::new();
        for code in &self.codes {
            match code.what.codes() {
                Some(lines) => codes.extend(lines),
                None => mistakes.push(Mistake {
                    at: Some(code.of),
                    what: Wrong::Missing,
                }),
            }
        }
        mistakes.extend(self.without_point.iter().map(|&parallel| Mistake {
            at: Some(parallel),
            what: Wrong::NoPointLeft,
        }));
        match mistakes.is_empty() {
            true => Ok(codes),
            false => Err(mistakes),
        }
    }
}

/// The same element is told the same once.
fn once(mistakes: Vec<Mistake>) -> Vec<Mistake> {
    let mut all: Vec<Mistake> = Vec::with_capacity(mistakes.len());
    for mistake in mistakes {
        if !all.contains(&mistake) {
            all.push(mistake);
        }
    }
    all
}

impl Code<'_> {
    fn lacks_something(&self) -> bool {
        matches!(self.what, What::Step(step) if !step.is_complete())
    }
}

/// Calls back for what ends a series that leads to nothing, and drives nothing itself.
fn idle(series: &[Node], says: &mut impl FnMut(Id)) {
    match series.last() {
        // What lacks something is told that first.
        Some(Node::Element(last))
            if makes_a_result(last.step.class()) && last.step.is_complete() =>
        {
            says(last.id);
        }
        Some(Node::Parallel(parallel)) => {
            let paths = parallel.paths.iter();
            paths.for_each(|path| idle(&path.series, says));
        }
        _ => {}
    }
}

/// Whether an element only makes the result that the next one uses.
fn makes_a_result(class: Class) -> bool {
    matches!(
        class,
        Class::Contact
            | Class::Condition
            | Class::ValueContact
            | Class::Comparison
            | Class::Xor
            | Class::Logic
    )
}

/// A program file for the loader, and what each line after the first came from. What lacks something is left out, but
/// for a timer: others name it by its number.
fn text(emitted: &Emitted<'_>) -> (String, Vec<Id>) {
    use std::fmt::Write;
    let mut text = format!("{START}\n");
    let mut owners = Vec::new();
    for code in &emitted.codes {
        let stand_in = match code.what {
            What::Step(step) if step.class() == Class::Timer && !step.is_complete() => {
                Some(Step::new(step.opcode()).with_lines([Some(0), Some(MARKER)]))
            }
            _ => None,
        };
        let what = stand_in.as_ref().map_or(code.what, What::Step);
        for line in what.codes().into_iter().flatten() {
            let _ = writeln!(text, "{line}");
            owners.push(code.of);
        }
    }
    (text, owners)
}

/// A target that every board has.
const MARKER: i32 = unoclp_core::isa::MARKER_OPERAND + 1;
