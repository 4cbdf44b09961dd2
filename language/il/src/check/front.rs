//! What is known of a text in Instruction List on the way to its tree.

use super::used::Used;
use crate::ast::{Unit, UnitKind};
use crate::names::Names;
use std::collections::{HashMap, HashSet};
use unoclp_st::Checker;
use unoclp_st::pieces::Pieces;
use unoclp_text::diagnostics::{Code, Span, Word};
use unoclp_tree::build::{Closed, Declaring, EdgeInput};

/// Blocks stand in one another no deeper.
pub(super) const MOST_WITHIN: usize = 16;

/// How far a unit has been made out.
pub(super) enum Stage {
    Not(Declaring),
    Begun,
    Done(Closed),
}

/// What is known of a text on the way to its tree.
pub(super) struct Front<'a, 'f> {
    pub units: &'a [Unit],
    pub names: Names<'a>,
    /// What Structured Text makes of types and of the pieces of the text that are written as in it.
    pub c: Checker<'a, 'a, 'f>,
    pub pieces: &'a Pieces,
    /// Whether the text declares something of a type that `names` does not know.
    pub has_types: bool,
    pub used: Used,
    /// Of each unit: its number in the tree, and the instance whose names `names` has for it.
    pub numbers: Vec<u32>,
    pub instances: Vec<usize>,
    pub stages: Vec<Stage>,
    /// Of each unit: its inputs that are edges.
    pub edge_inputs: Vec<Vec<EdgeInput>>,
    /// Timers and counters that a declaration names by an address: their names there.
    pub aliases: HashMap<String, String>,
    /// Functions of the text, by their names.
    pub functions: HashMap<String, usize>,
    /// The outputs that a ST has driven, and where.
    pub coils: HashMap<u8, Span>,
    /// Timers that have been called, by the unit and the cell.
    pub timed: HashSet<(Option<usize>, u32)>,
    /// Of each unit: the first timer that it starts, or a block within it.
    pub timers: Vec<Option<String>>,
    /// Calls of instances: by the unit and the cell, of which unit, and where.
    pub instance_calls: Vec<((Option<usize>, u32), usize, Span)>,
    /// The units that the program comes to call, and itself.
    pub called: Vec<bool>,
    /// The units that stand in one another while they are declared.
    pub within: usize,
    pub writes: bool,
}

impl Front<'_, '_> {
    pub(super) fn tell<const N: usize>(&mut self, code: Code, at: Span, words: [Word; N]) {
        self.c.builder.found.tell(code, at, words);
    }

    pub(super) fn kind_of(&self, unit: usize) -> UnitKind {
        self.units
            .get(unit)
            .map_or(UnitKind::Program, |unit| unit.kind)
    }

    /// An instance that has a timer within has one call, as the timer has.
    pub(super) fn timers_again(&mut self) {
        let calls = std::mem::take(&mut self.instance_calls);
        let mut seen = HashSet::new();
        for (instance, unit, span) in calls {
            let timer = self.timer_within(unit, 0);
            if !seen.insert(instance)
                && let Some(name) = timer
            {
                self.tell(Code::TimerTwice, span, [name.into()]);
            }
        }
    }

    /// The first timer in a unit and the blocks in it.
    fn timer_within(&self, unit: usize, deep: usize) -> Option<String> {
        let own = self.timers.get(unit)?.clone();
        let vars = || self.units.get(unit).into_iter().flat_map(|unit| &unit.vars);
        let within = || {
            let blocks = vars().filter_map(|var| self.block_named(&var.ty.text));
            let mut timers = blocks.map(|block| self.timer_within(block, deep + 1));
            timers.find_map(|timer| timer)
        };
        own.or_else(|| if deep < MOST_WITHIN { within() } else { None })
    }

    /// What is read of a timer that nothing starts, and inputs that nothing reads.
    pub(super) fn never_used(&mut self) {
        if !self.c.builder.found.has_errors() {
            for timer in &self.names.timers {
                if let (None, Some(span)) = (&timer.called, timer.read) {
                    let name = timer.name.as_str().into();
                    self.c.builder.found.tell(Code::NeverCalled, span, [name]);
                }
            }
        }
        for declared in &self.names.inputs {
            if self.names.inputs_read >> (declared.input - 1) & 1 == 0 {
                let name = declared.name.as_str().into();
                let found = &mut *self.c.builder.found;
                found.tell(Code::NeverRead, declared.span, [name]);
            }
        }
    }

    /// The function block of the text that has this name.
    pub(super) fn block_named(&self, name: &str) -> Option<usize> {
        let named = |unit: &Unit| {
            let own = unit.name.as_ref().map(|name| name.text.as_str());
            unit.kind == UnitKind::FunctionBlock && own == Some(name)
        };
        self.units.iter().rposition(named)
    }
}
