//! Instruction List as a front end of the typed tree: from its syntax tree to units, variables and statements.
//!
//! The lines of a body are run once on expressions in place of values, so that `LD a`, `ADD b`, `ST c` come to
//! `c := a + b`. What a name means and what is wrong with it, `names` says, whoever's way of writing points it is.
//!
//! - `used`: what the text does with its timers and counters, wherever they are declared
//! - `declare`: units and variables; `first`: what they begin with
//! - `operands`: what an operand means and what it is worth
//! - `walk`: what is held on the way through a body; `accumulator`: what is put aside of it; `needs`: where it is used
//! - `bits`, `numbers`, `stores`, `defer`, `stack`, `branches`: what works on the accumulator
//! - `flow`: labels, jumps, IF; `circles`: calls without end; `calls`, `units`, `timers`, `counters`, `edges`: what is called
//! - `makers`, `blocks`: what the makers write in their own ways
//!
//! Must not know codes, nor what a statement costs.

mod accumulator;
mod bits;
mod blocks;
mod branches;
mod calls;
mod circles;
mod counters;
mod declare;
mod defer;
mod edges;
mod first;
mod flow;
mod latches;
mod makers;
mod needs;
mod numbers;
mod operands;
mod stack;
mod stores;
mod timers;
mod units;
mod used;
mod walk;

use crate::Dialect;
use crate::ast::{Unit, UnitKind};
use crate::diagnostics::{Code, Found, Span, Word};
use crate::names::Names;
use crate::typed::Tree;
use crate::typed::build::{Builder, Letters};
use crate::whole;
use std::collections::{HashMap, HashSet};
use unoclp_core::Board;
use used::Used;

/// What is known of a text on the way to its tree.
struct Front<'a, 'f> {
    units: &'a [Unit],
    names: Names<'a>,
    builder: Builder<'a, 'f>,
    used: Used,
    /// Of each unit: its number in the tree, and the instance whose names `names` has for it.
    numbers: Vec<u32>,
    instances: Vec<usize>,
    declared: Vec<bool>,
    /// Functions of the text, by their names.
    functions: HashMap<String, usize>,
    /// The outputs that a ST has driven, and where.
    coils: HashMap<u8, Span>,
    /// Timers that have been called, by the unit and the cell.
    timed: HashSet<(Option<usize>, u32)>,
    /// The units that stand in one another while they are declared.
    within: usize,
    writes: bool,
}

/// The tree of a text; none where something is wrong, which is told.
pub(crate) fn tree(
    text: &str,
    dialect: Dialect,
    board: Board,
    units: &[Unit],
    found: &mut Found,
) -> Option<Tree> {
    let mut builder = Builder::new(text, Letters::Alike, board, found);
    builder.is_list = true;
    builder.is_wide = true;
    builder.divides_by_zero = true;
    builder.may_do_nothing();
    let mut front = Front {
        units,
        names: Names::new(text, dialect, board, units),
        builder,
        used: Used::of(units, dialect),
        numbers: Vec::new(),
        instances: Vec::new(),
        declared: vec![false; units.len()],
        functions: HashMap::new(),
        coils: HashMap::new(),
        timed: HashSet::new(),
        within: 0,
        writes: false,
    };
    front.declare_all();
    for unit in 0..units.len() {
        front.body(unit);
    }
    front.never_used();
    let is_endless = front.refuse_circles();
    whole::check(text, units, front.writes, front.builder.found);
    if is_endless || front.builder.found.has_errors() {
        return None;
    }
    front.builder.finish()
}

impl Front<'_, '_> {
    fn tell<const N: usize>(&mut self, code: Code, at: Span, words: [Word; N]) {
        self.builder.found.tell(code, at, words);
    }

    fn kind_of(&self, unit: usize) -> UnitKind {
        self.units
            .get(unit)
            .map_or(UnitKind::Program, |unit| unit.kind)
    }

    /// What is read of a timer that nothing starts, and inputs that nothing reads.
    fn never_used(&mut self) {
        if !self.builder.found.has_errors() {
            for timer in &self.names.timers {
                if let (None, Some(span)) = (&timer.called, timer.read) {
                    let name = timer.name.as_str().into();
                    self.builder.found.tell(Code::NeverCalled, span, [name]);
                }
            }
        }
        for declared in &self.names.inputs {
            if self.names.inputs_read >> (declared.input - 1) & 1 == 0 {
                let name = declared.name.as_str().into();
                let found = &mut *self.builder.found;
                found.tell(Code::NeverRead, declared.span, [name]);
            }
        }
    }
}
