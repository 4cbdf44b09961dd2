//! The interpreter: runs a typed tree on the PC, with all types and a virtual clock.
//!
//! It owns the memory of a running program and what each node does there. It must not know how a program was
//! written, nor files and real clocks: whoever runs it says when each scan begins. It is also what the board is
//! held against.
//!
//! - `expressions`, `statements`: the nodes
//! - `places`: from a place to a cell; `groups`: cells that are eight bits as one number
//! - `blocks`: the function blocks of the standard
//! - `extra`: the functions of the PC alone

mod blocks;
mod expressions;
mod extra;
mod groups;
mod places;
mod statements;

use crate::{Base, Holds, Symbol, Tree, Value};
use groups::Groups;
use unoclp_core::Clocks;
use unoclp_point::Address;
use unoclp_text::diagnostics::Span;

/// More steps than this no scan takes; a loop that does not end is stopped so.
pub const MOST_STEPS: u64 = 20_000_000;

/// More nodes within nodes than this are not run: calls in calls may come to that.
const MOST_DEEP: u32 = 2_000;

/// Why a scan did not end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// It took more steps than it may; it stood there.
    Endless(Span),
    /// Calls in calls go too deep there.
    TooDeep(Span),
    /// It came to a code of the board, which a PC does not know.
    Codes(Span),
}

/// What PRINT has shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Printed {
    /// As it was written.
    pub name: String,
    /// Its value.
    pub value: Value,
    /// Of what type.
    pub base: Base,
}

/// The cells of a call.
#[derive(Clone, Debug, Default)]
struct Frame {
    own: usize,
    local: usize,
    /// The cells that are lent; none where a subscript was outside.
    lent: Vec<Option<usize>>,
}

/// A running program.
#[derive(Debug)]
pub struct Machine<'t> {
    tree: &'t Tree,
    memory: Vec<Value>,
    now: i64,
    clocks: Clocks,
    scans: u64,
    steps: u64,
    most: u64,
    deep: u32,
    /// Where S 04 was set first.
    failed: Option<Span>,
    error_cell: Option<usize>,
    groups: Groups,
    printed: Vec<Printed>,
}

impl<'t> Machine<'t> {
    /// A program before its first scan.
    pub fn new(tree: &'t Tree) -> Machine<'t> {
        let error = tree
            .points
            .iter()
            .find(|(_, point)| *point == Address::System(4));
        Machine {
            tree,
            memory: tree.cells.iter().map(|cell| cell.initial.clone()).collect(),
            now: 0,
            clocks: Clocks::new(),
            scans: 0,
            steps: 0,
            most: MOST_STEPS,
            deep: 0,
            failed: None,
            error_cell: error.map(|(cell, _)| *cell as usize),
            groups: groups::of(tree),
            printed: Vec::new(),
        }
    }

    /// The same with another limit of steps in a scan.
    pub fn with_steps(self, most: u64) -> Machine<'t> {
        Machine { most, ..self }
    }

    /// One scan, which begins at this time in ms.
    ///
    /// # Errors
    /// It does not come to an end.
    pub fn scan(&mut self, now: i64) -> Result<(), Stop> {
        self.now = now;
        self.steps = 0;
        self.deep = 0;
        self.system_markers();
        for &unit in &self.tree.programs {
            self.run_unit(unit)?;
        }
        self.scans += 1;
        Ok(())
    }

    /// How many steps the last scan took.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    fn system_markers(&mut self) {
        // The board's clock has 32 bits.
        self.clocks.scan(self.scans == 0, self.now as u32);
        for (cell, point) in &self.tree.points {
            let bit = match point {
                Address::System(1) => self.scans == 0,
                Address::System(2) => self.clocks.slow(),
                Address::System(3) => self.clocks.fast(),
                Address::System(_) => false,
                _ => continue,
            };
            if let Some(value) = self.memory.get_mut(*cell as usize) {
                *value = Value::truth(bit);
            }
        }
    }

    /// What a cell holds.
    pub fn cell(&self, cell: u32) -> Value {
        let held = self.groups.held(&self.memory, cell as usize);
        held.unwrap_or(Value::Int(0))
    }

    /// Sets a cell, as an input is set from outside.
    pub fn set_cell(&mut self, cell: u32, value: Value) {
        self.write(Some(cell as usize), value);
    }

    /// The value of a symbol, and its type.
    pub fn value(&self, symbol: &Symbol) -> (Value, Base) {
        let cell = match symbol.holds {
            Holds::Cell(cell) => return (self.cell(cell), symbol.base),
            Holds::Either { flag, set, clear } => match self.cell(flag).is_true() {
                true => set,
                false => clear,
            },
        };
        let base = self
            .tree
            .cells
            .get(cell as usize)
            .map_or(symbol.base, |cell| cell.base);
        (self.cell(cell), base)
    }

    /// Where S 04 was set first since the program began; none if it never was.
    pub fn failed(&self) -> Option<Span> {
        self.failed
    }

    /// What PRINT has shown since this was asked last.
    pub fn printed(&mut self) -> Vec<Printed> {
        std::mem::take(&mut self.printed)
    }

    /// Sets S 04.
    fn fail(&mut self, at: Span) {
        self.failed.get_or_insert(at);
        if let Some(value) = self.error_cell.and_then(|cell| self.memory.get_mut(cell)) {
            *value = Value::Int(1);
        }
    }

    /// Counts a step.
    fn step(&mut self, at: Span) -> Result<(), Stop> {
        self.steps += 1;
        match self.steps > self.most {
            true => Err(Stop::Endless(at)),
            false => Ok(()),
        }
    }
}
