//! Edges and counters that a text calls more than once: each call is another evaluation of one instance.
//!
//! A code of the board remembers for itself, so an edge that is called once is one code. Which ones are
//! called again is known only after the last call: a text that has such calls is run through a second time.

use super::{Acc, Lower};
use crate::diagnostics::Span;
use crate::names::Names;
use crate::rung::Written;
use crate::tree::{Bit, Expr};
use std::collections::{HashMap, HashSet};
use unoclp_core::Target;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

/// What remembers a state from one call to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Edge {
    /// R_TRIG or F_TRIG, by the marker of its Q.
    Trigger(u8),
    /// EU or ED at this byte of the text, in an instance.
    Operator(usize, u32),
}

/// What is called, as far as the text has been run through.
#[derive(Debug, Default)]
pub(super) struct Calls {
    edges: HashMap<Edge, u32>,
    /// The constant presets of each counter, by its number.
    presets: HashMap<u8, HashSet<i32>>,
}

/// What is called more than once.
#[derive(Debug, Default)]
pub(super) struct Again {
    /// Each with the marker that remembers for it.
    edges: HashMap<Edge, u8>,
    /// Counters that have another preset at another call.
    presets: HashSet<u8>,
}

impl Calls {
    pub(super) fn again(self) -> Again {
        let edges = self.edges.into_iter();
        let presets = self.presets.into_iter();
        Again {
            edges: edges.filter(|(_, n)| *n > 1).map(|(e, _)| (e, 0)).collect(),
            presets: presets
                .filter(|(_, p)| p.len() > 1)
                .map(|(c, _)| c)
                .collect(),
        }
    }
}

impl Again {
    pub(super) fn is_empty(&self) -> bool {
        self.edges.is_empty() && self.presets.is_empty()
    }

    /// Gives each edge its marker, which nothing else in the program may touch.
    pub(super) fn reserve(&mut self, names: &mut Names<'_>) {
        let mut edges: Vec<_> = self.edges.iter_mut().collect();
        edges.sort_by_key(|(edge, _)| match edge {
            Edge::Trigger(marker) => (0, u32::from(*marker)),
            Edge::Operator(instance, at) => (*instance + 1, *at),
        });
        for (_, memory) in edges {
            *memory = names.temps.named_marker(false);
        }
    }

    /// Whether each call of a counter gives it its preset.
    pub(super) fn presets(&self, counter: u8) -> bool {
        self.presets.contains(&counter)
    }
}

impl Lower<'_, '_> {
    /// The rise or fall of an expression, in the accumulator.
    pub(super) fn rise_or_fall(&mut self, edge: Edge, opcode: Opcode, expr: Expr, span: Span) {
        *self.counted.edges.entry(edge).or_default() += 1;
        let Some(&memory) = self.again.edges.get(&edge) else {
            self.bring(expr, span);
            self.rungs.changes(Written::Plain(opcode), span);
            self.acc = Acc::Bit(Expr::Live);
            return;
        };
        self.freeze(span);
        let now = self.fixed_bit(expr, span);
        let before = Expr::Lit {
            bit: Bit::At(Address::Marker(memory)),
            negated: false,
            span,
        };
        let changed = match opcode {
            Opcode::RisingEdge => now.clone().and(before.not()),
            _ => now.clone().not().and(before),
        };
        let changed = self.fixed_bit(changed, span);
        self.rungs.logic(now, span);
        self.rungs.coil(Target::Marker(memory), false, span);
        self.acc = Acc::Bit(changed);
    }

    pub(super) fn note_preset(&mut self, counter: u8, preset: i32) {
        self.counted
            .presets
            .entry(counter)
            .or_default()
            .insert(preset);
    }

    /// Where a call stands, and the calls that led there, the innermost first.
    pub(super) fn call_path(&self, span: Span) -> Vec<Span> {
        let calls = self.scopes.iter().rev().filter_map(|scope| scope.call);
        std::iter::once(span).chain(calls).collect()
    }
}
