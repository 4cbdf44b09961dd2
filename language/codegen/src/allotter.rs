//! What the board has too little of, told at the declaration.
//!
//! Owns the words for it; which place a cell gets, `allot` knows.

use super::flat::Flat;
use super::seats::Seats;
use super::uses::Uses;
use std::collections::HashMap;
use unoclp_core::Board;
use unoclp_text::diagnostics::{Code, Found, Span, Word};
use unoclp_tree::{Base, Holds, Tree};

pub(super) const REGISTER: (&str, &str) = ("register", "registrador");

pub(super) const COUNTER: (&str, &str) = ("counter", "contador");

/// What a person calls the cell, and where.
pub(super) fn named(tree: &Tree) -> HashMap<u32, (String, Span)> {
    let named = tree.symbols.iter().filter_map(|symbol| match symbol.holds {
        Holds::Cell(cell) => Some((cell, (symbol.name.clone(), symbol.at))),
        Holds::Either { .. } => None,
    });
    named.collect()
}

pub(super) struct Allotter<'a> {
    pub seats: &'a mut Seats,
    pub names: &'a HashMap<u32, (String, Span)>,
    pub tree: &'a Tree,
    pub flat: &'a Flat,
    pub uses: &'a Uses,
    pub found: &'a mut Found,
    pub board: Board,
    pub told: bool,
}

impl Allotter<'_> {
    /// What a person calls a cell, and where it is declared: of what a call has, the unit that is called.
    pub(super) fn place(&self, cell: u32) -> (String, Span) {
        if let Some(named) = self.names.get(&cell) {
            return named.clone();
        }
        let behind = self.flat.calls.partition_point(|call| call.0 <= cell);
        let called = behind.checked_sub(1).and_then(|at| self.flat.calls.get(at));
        let unit = called
            .map(|call| call.1)
            .or(self.tree.programs.first().copied());
        let unit = unit.and_then(|unit| self.tree.units.get(unit as usize));
        unit.map(|unit| (unit.name.clone(), unit.at))
            .unwrap_or_default()
    }

    pub(super) fn none_left(&mut self, words: (&str, &str), most: u32, cell: u32) {
        self.seats.none_left = true;
        if std::mem::replace(&mut self.told, true) {
            return;
        }
        let (name, at) = self.place(cell);
        // Of an array or a structure: how much of it there is, and how much has found a place.
        let own = |other: &u32| self.names.get(other).is_some_and(|named| named.1 == at);
        let is_bool = |cell: u32| {
            let held = self.flat.cells.get(cell as usize);
            held.is_some_and(|held| held.base == Base::Bool)
        };
        let parts = self.uses.cells.keys();
        let parts = parts.filter(|other| own(other) && is_bool(**other) == is_bool(cell));
        let parts: Vec<u32> = parts.copied().collect();
        let whole = name.split(['[', '.']).next().unwrap_or_default();
        if whole == name || parts.len() < 2 || words == COUNTER {
            let name = if words == COUNTER { whole } else { &name };
            let name = format!("`{name}`");
            let words = [words.into(), most.to_string().into(), name.into()];
            self.found.tell(Code::BoardNoneLeft, at, words);
            return;
        }
        let free = parts.iter().filter(|cell| self.seats.of.contains_key(cell));
        let free = free.count().to_string();
        let count = parts.len();
        let (places, lugares) = match is_bool(cell) {
            true => ("markers or registers", "memórias ou registradores"),
            false => ("registers", "registradores"),
        };
        let takes = Word::Both(format!("{count} {places}"), format!("{count} {lugares}"));
        self.found
            .tell(Code::BoardRow, at, [whole.into(), takes, free.into()]);
    }
}
