//! The labels, jumps and IFs of a body in Instruction List, and where its accumulator is used.
//!
//! Owns which statement a label leads to, and which lines need what the one before leaves. Must not know what a line
//! says: its reader tells that.

use std::collections::HashMap;
use unoclp_text::diagnostics::Span;
use unoclp_tree::build::Target;
use unoclp_tree::{Expr, Stmt, StmtKind};

/// The labels of a body.
#[derive(Debug, Default)]
pub(super) struct Labels {
    /// The line of each that a jump may lead to, by its name as the reader compares names.
    pub lines: HashMap<String, usize>,
    /// Where all of them stand.
    pub all: Vec<Span>,
    /// Where the accumulator waits that is needed after a label.
    pub carried: HashMap<usize, Target>,
    /// The statement that each leads to; those after the body's own are of IF.
    places: HashMap<usize, usize>,
    /// Jumps whose statement is not known yet, and their labels.
    open: Vec<(usize, usize)>,
    of_ifs: usize,
}

impl Labels {
    /// A label leads to the statement that comes.
    pub fn place(&mut self, label: usize, made: &[Vec<Stmt>]) {
        self.places.insert(label, next(made));
    }

    /// The statement that comes jumps to a label.
    pub fn jumps_to(&mut self, label: usize, made: &[Vec<Stmt>]) {
        self.open.push((next(made), label));
    }

    /// The labels of an IF, after its first part and after it, in a body of so many lines.
    pub fn of_if(&mut self, lines: usize) -> (usize, usize) {
        let first = lines + 2 * self.of_ifs;
        self.of_ifs += 1;
        (first, first + 1)
    }

    /// A statement of the body's own is put before that of this number.
    pub fn insert(&mut self, before: usize) {
        for (statement, _) in &mut self.open {
            *statement += usize::from(*statement >= before);
        }
        for place in self.places.values_mut() {
            *place += usize::from(*place > before);
        }
    }

    /// Gives each jump the number of its statement.
    pub fn settle(&mut self, made: &mut [Vec<Stmt>]) {
        for (at, label) in std::mem::take(&mut self.open) {
            let to = self.places.get(&label).copied().unwrap_or(0);
            let statement = made.first_mut().and_then(|made| made.get_mut(at));
            if let Some(StmtKind::Jump(_, number)) = statement.map(|one| &mut one.kind) {
                *number = to as u32;
            }
        }
    }
}

/// The number of the statement of a body that comes.
fn next(made: &[Vec<Stmt>]) -> usize {
    made.first().map_or(0, Vec::len)
}

/// An IF that is open.
#[derive(Debug)]
pub(super) struct If {
    pub span: Span,
    /// None of one that is wrong, which has been told.
    pub condition: Option<Expr>,
    /// What is done where the condition holds, once ELSE has come.
    pub first: Option<Vec<Stmt>>,
    /// With jumps: the labels after its first part, and after it.
    pub labels: Option<(usize, usize)>,
    pub other: bool,
}

impl If {
    /// The statement that it is, with its last part; none of one that is wrong.
    pub fn closed(self, last: Vec<Stmt>) -> Option<Stmt> {
        let (then, otherwise) = match self.first {
            Some(first) => (first, last),
            None => (last, Vec::new()),
        };
        let kind = StmtKind::If(vec![(self.condition?, then)], otherwise);
        Some(Stmt {
            kind,
            at: self.span,
        })
    }
}

/// What a line does with the accumulator, and where it leads.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passes {
    /// It begins with what the accumulator holds.
    pub reads: bool,
    /// What it does not read it fills or forgets.
    pub fills: bool,
    /// The next line comes after it.
    pub goes_on: bool,
    /// The line of the label that it may go to.
    pub jumps: Option<usize>,
}

/// Whether the accumulator is needed before each line, and after the last: walks back from each line that reads it to
/// those that fill it.
pub(super) fn needed(lines: impl ExactSizeIterator<Item = Passes>) -> Vec<bool> {
    let count = lines.len();
    let mut goes_on = Vec::with_capacity(count);
    let mut filled = Vec::with_capacity(count);
    let mut jumps: HashMap<usize, Vec<usize>> = HashMap::new();
    let mut todo = Vec::new();
    for (at, line) in lines.enumerate() {
        if line.reads {
            todo.push(at);
        }
        filled.push(line.fills && !line.reads);
        goes_on.push(line.goes_on);
        if let Some(label) = line.jumps {
            jumps.entry(label).or_default().push(at);
        }
    }
    let mut needs = vec![false; count + 1];
    while let Some(at) = todo.pop() {
        if std::mem::replace(&mut needs[at], true) {
            continue;
        }
        let before = at.checked_sub(1).filter(|&before| goes_on[before]);
        let jumps = jumps.get(&at).into_iter().flatten().copied();
        todo.extend(before.into_iter().chain(jumps).filter(|&one| !filled[one]));
    }
    needs
}
