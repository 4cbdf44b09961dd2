//! The one allocation of markers, registers, timers and counters.
//!
//! Owns which cell gets which place. Must not know instructions.

use super::allotter::{Allotter, COUNTER, MARKER, REGISTER, RETENTIVE_MARKER, named};
use super::flat::Flat;
use super::seats::{Seat, Seats};
use super::uses::{Called, Uses};
use crate::diagnostics::{Code, Found, Word};
use crate::typed::{Base, Standard, Tree};
use std::collections::BTreeMap;
use unoclp_core::Board;
use unoclp_core::isa::REGISTERS;
use unoclp_point::Address;

/// Gives each cell that is used a place.
pub(super) fn allot(
    tree: &Tree,
    flat: &Flat,
    uses: &Uses,
    board: Board,
    found: &mut Found,
) -> Seats {
    let names = named(tree);
    let mut seats = Seats::new(board);
    let mut allotter = Allotter {
        seats: &mut seats,
        names: &names,
        tree,
        flat,
        uses,
        found,
        board,
        told: false,
    };
    allotter.points(tree, uses);
    allotter.blocks(flat, uses);
    allotter.rows(flat, uses);
    let own = tree.cells.len() as u32;
    let mut cells: Vec<(&u32, &super::uses::Use)> = uses.cells.iter().collect();
    cells.sort_by_key(|(cell, of)| {
        (
            **cell >= own,
            if **cell >= own { of.first } else { 0 },
            **cell,
        )
    });
    let mut lives: Vec<(u32, Seat)> = Vec::new();
    for (&cell, of) in cells {
        if allotter.seats.of.contains_key(&cell) {
            continue;
        }
        let Some(held) = flat.cells.get(cell as usize) else {
            continue;
        };
        if cell >= own {
            let (over, still): (Vec<_>, Vec<_>) =
                lives.into_iter().partition(|(last, _)| *last < of.first);
            over.into_iter()
                .for_each(|(_, seat)| allotter.seats.release(seat));
            lives = still;
        }
        let seat = allotter.seat(cell, held.base, held.retain);
        if let Some(seat) = seat.filter(|_| cell >= own) {
            lives.push((of.last, seat));
        }
    }
    // What stands between two statements goes where no cell ever is.
    let all: Vec<Seat> = seats.of.values().copied().collect();
    all.into_iter().for_each(|seat| seats.take(seat));
    seats
}

/// Whether a counter's preset is one number above 0 from the beginning, so that it has not reached it before it counts.
fn steady(flat: &Flat, uses: &Uses, preset: u32) -> bool {
    let initial = flat
        .cells
        .get(preset as usize)
        .map_or(0, |c| c.initial.int());
    if let Some(given) = uses.given.get(&preset) {
        return given.is_some_and(|given| given > 0);
    }
    uses.get(preset)
        .map_or(initial, |of| match (of.stores, &of.only) {
            (0, _) => initial,
            (_, Some(only)) => only.int(),
            (_, None) => 0,
        })
        > 0
}

impl Allotter<'_> {
    fn points(&mut self, tree: &Tree, uses: &Uses) {
        for (cell, point) in &tree.points {
            let seat = Seat::At(*point);
            self.seats.take(seat);
            self.seats.of.insert(*cell, seat);
            if tree
                .cells
                .get(*cell as usize)
                .is_some_and(|held| held.retain)
            {
                self.keep(*cell, seat);
            }
        }
        // Behind the others, whose registers are the program's choice.
        for (cell, point) in &tree.points {
            if let Address::Pwm(output) = *point
                && uses.get(*cell).is_some_and(|of| of.reads > 0)
                && self.seat(*cell, Base::Int, false).is_some()
            {
                self.seats.outputs.insert(*cell, output);
            }
        }
    }

    /// Has the board keep what stands at a point.
    fn keep(&mut self, cell: u32, seat: Seat) {
        match seat {
            Seat::At(Address::Register(register)) => self.seats.kept_registers.push(register),
            Seat::At(Address::Marker(marker))
                if self.board.markers_that(true).any(|kept| kept == marker) => {}
            _ => {
                let (_, at) = self.place(cell);
                let word = Word::Both("value at this place".into(), "valor neste lugar".into());
                self.found.tell(Code::BoardRetain, at, [word]);
            }
        }
    }

    /// A place for a cell of its own.
    fn seat(&mut self, cell: u32, base: Base, retain: bool) -> Option<Seat> {
        let (seat, words, most) = match base {
            Base::Bool if retain => (self.seats.marker(true), RETENTIVE_MARKER, 8),
            Base::Bool => (
                self.seats.marker(false),
                MARKER,
                self.board.markers_that(false).count() as u32,
            ),
            _ => (self.seats.register(), REGISTER, u32::from(REGISTERS)),
        };
        match seat {
            Some(seat) => {
                self.seats.of.insert(cell, seat);
                if let Seat::At(Address::Register(register)) = seat
                    && retain
                {
                    self.seats.kept_registers.push(register);
                }
                Some(seat)
            }
            None => {
                self.none_left(words, most, cell);
                None
            }
        }
    }

    /// Registers in a row, for what computed subscripts reach.
    fn rows(&mut self, flat: &Flat, uses: &Uses) {
        for row in &uses.rows {
            let length = row.end - row.start;
            let first = self.seats.row(length);
            let Some(first) = first else {
                let (name, at) = self.place(row.start);
                let free = REGISTERS as u32 - self.seats.registers.count_ones();
                let whole = name.split(['[', '.']).next().unwrap_or_default();
                let takes = Word::Both(
                    format!("{length} registers in a row"),
                    format!("{length} registradores seguidos"),
                );
                let words = [whole.into(), takes, free.to_string().into()];
                self.found.tell(Code::BoardRow, at, words);
                continue;
            };
            for (cell, register) in row.clone().zip(first..) {
                self.seats
                    .of
                    .insert(cell, Seat::At(Address::Register(register)));
                if flat
                    .cells
                    .get(cell as usize)
                    .is_some_and(|held| held.retain)
                {
                    self.seats.kept_registers.push(register);
                }
            }
        }
    }

    fn blocks(&mut self, flat: &Flat, uses: &Uses) {
        let called: BTreeMap<u32, Called> = uses.blocks.iter().map(|(c, b)| (*c, *b)).collect();
        let mut counters = 0;
        for (cell, called) in called {
            let of = |part: u32| flat.cells.get((cell + part) as usize);
            let kept = of(0).is_some_and(|held| held.retain);
            let block = called.block;
            if called.count > 1 && block.has_one_call() {
                let (name, at) = self.place(cell);
                let name = name.split('.').next().unwrap_or_default().to_owned();
                self.found
                    .tell(Code::BoardTwice, at, [name.into(), block.name().into()]);
            }
            if kept && (block.is_timer() || matches!(block, Standard::RTrig | Standard::FTrig)) {
                let (_, at) = self.place(cell);
                self.found
                    .tell(Code::BoardRetain, at, [block.name().into()]);
            }
            // Read after the call alone, in each scan: the board's own figures are those of the call.
            let live = |part: u32| {
                let first = uses.get(cell + part).and_then(|of| of.first_read);
                called.always && first.is_none_or(|first| first > called.at)
            };
            if block.is_timer() {
                let index = self.seats.timers.len();
                self.seats.timers.insert(cell, index);
                self.seats.of.insert(cell + 2, Seat::Timer(index));
                if live(3) && block != Standard::Tof {
                    self.seats.of.insert(cell + 3, Seat::Elapsed(index));
                }
                continue;
            }
            let (up, down, count, preset) = match block {
                Standard::Ctu | Standard::CtuDint => (Some(3), None, 4, 2),
                Standard::Ctd | Standard::CtdDint => (None, Some(3), 4, 2),
                Standard::Ctud | Standard::CtudDint => (Some(5), Some(6), 7, 4),
                _ => continue,
            };
            counters += 1;
            if counters > self.board.counters {
                self.none_left(COUNTER, self.board.counters.into(), cell);
                continue;
            }
            let number = counters;
            self.seats.counters.insert(cell, number);
            self.seats
                .of
                .insert(cell + count, Seat::At(Address::Count(number)));
            if kept {
                self.seats.kept_counters.push(number);
            }
            if let Some(part) = up
                && !kept
                && (live(part) || steady(flat, uses, cell + preset))
            {
                self.seats
                    .of
                    .insert(cell + part, Seat::At(Address::Reached(number)));
            }
            if let Some(part) = down
                && live(part)
            {
                self.seats
                    .of
                    .insert(cell + part, Seat::At(Address::AtZero(number)));
            }
        }
    }
}
