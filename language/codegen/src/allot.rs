//! The one allocation of markers, registers, timers and counters.
//!
//! Owns which cell gets which place. Must not know instructions.

use super::allotter::{Allotter, COUNTER, REGISTER, named};
use super::flat::Flat;
use super::seats::{Seat, Seats};
use super::uses::{Called, Uses};
use std::collections::BTreeMap;
use std::ops::Range;
use unoclp_core::Board;
use unoclp_core::isa::REGISTERS;
use unoclp_point::Address;
use unoclp_text::diagnostics::{Code, Found, Word};
use unoclp_tree::{Base, Standard, Tree, counter};

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
    for point in &uses.codes {
        allotter.seats.take(Seat::At(*point));
    }
    if let Some(now) = flat.now {
        allotter.seats.of.insert(now, Seat::Now);
    }
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
    // A timer whose Q goes nowhere drives a marker all the same.
    let idle = uses
        .blocks
        .iter()
        .any(|(_, called)| called.block.is_timer());
    let idle = idle.then(|| allotter.seats.last_marker()).flatten();
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
    idle.into_iter().for_each(|seat| seats.release(seat));
    // What stands between two statements goes where no cell ever is.
    let all: Vec<Seat> = seats.of.values().copied().collect();
    all.into_iter().for_each(|seat| seats.take(seat));
    seats
}

/// Whether a counter's preset is one number above 0 from the beginning, so that it has not reached it before it counts.
fn steady(flat: &Flat, uses: &Uses, cell: u32, preset: u32) -> bool {
    let initial = flat
        .cells
        .get(preset as usize)
        .map_or(0, |c| c.initial.int());
    if uses.preset.contains(&cell) {
        return initial > 0;
    }
    if let Some(given) = uses.given.get(&preset) {
        return given.is_some_and(|given| given > 0);
    }
    let stored = uses.get(preset);
    let first = stored.map_or(initial, |of| match (of.stores, &of.only) {
        (0, _) => initial,
        (_, Some(only)) => only.int(),
        (_, None) => 0,
    });
    first > 0
}

impl Allotter<'_> {
    fn points(&mut self, tree: &Tree, uses: &Uses) {
        for (cell, point) in &tree.points {
            let seat = Seat::At(*point);
            self.seats.take(seat);
            self.seats.of.insert(*cell, seat);
            if let Address::Count(number) = *point {
                self.says_of_itself(*cell, number);
            }
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

    /// What a counter of the board says of itself, by the cell of its number: a program may ask one that it never calls.
    fn says_of_itself(&mut self, cell: u32, counter: u8) {
        for (part, point) in [
            (counter::UP, Address::Reached(counter)),
            (counter::DOWN, Address::AtZero(counter)),
        ] {
            let behind = counter::NUMBER - part;
            if let Some(cell) = cell.checked_sub(behind) {
                self.seats.of.insert(cell, Seat::At(point));
            }
        }
    }

    /// Has the board keep what stands at a point.
    fn keep(&mut self, cell: u32, seat: Seat) {
        match seat {
            Seat::At(Address::Register(register)) => self.seats.kept_registers.push(register),
            // A counter is kept as a whole.
            Seat::At(Address::Count(_)) => {}
            Seat::At(Address::Marker(marker))
                if self.board.markers_that(true).any(|kept| kept == marker) => {}
            Seat::At(Address::Group(group))
                if self
                    .board
                    .markers_that(true)
                    .any(|kept| (kept - 1) / 8 + 1 == group) => {}
            _ => {
                let (_, at) = self.place(cell);
                let word = Word::Both(
                    "value at this address".into(),
                    "valor neste endereço".into(),
                );
                self.found.tell(Code::BoardRetain, at, [word]);
            }
        }
    }

    /// A place for a cell of its own: of a BOOL a marker, or a register where no marker is left.
    fn seat(&mut self, cell: u32, base: Base, retain: bool) -> Option<Seat> {
        let marker = (base == Base::Bool).then(|| self.seats.marker(retain));
        match marker.flatten().or_else(|| self.seats.register()) {
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
                self.none_left(REGISTER, u32::from(REGISTERS), cell);
                None
            }
        }
    }

    /// Whether the text itself says where it stands.
    fn is_in_a_row(&self, row: &Range<u32>) -> bool {
        let register = |cell: u32| match self.seats.of.get(&cell) {
            Some(Seat::At(Address::Register(register))) => Some(u32::from(*register)),
            _ => None,
        };
        let first = register(row.start);
        first.is_some_and(|first| {
            row.clone()
                .all(|cell| register(cell) == Some(first + cell - row.start))
        })
    }

    /// Registers in a row, for what computed subscripts reach.
    fn rows(&mut self, flat: &Flat, uses: &Uses) {
        for row in &uses.rows {
            if self.is_in_a_row(row) {
                continue;
            }
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

    /// The counters whose numbers the text says.
    fn pinned(&self) -> Vec<u8> {
        let points = self.tree.points.iter().map(|(_, point)| point);
        let numbers = points
            .chain(&self.uses.codes)
            .filter_map(|point| match point {
                Address::Count(number) => Some(*number),
                _ => None,
            });
        numbers.collect()
    }

    fn blocks(&mut self, flat: &Flat, uses: &Uses) {
        let called: BTreeMap<u32, Called> = uses.blocks.iter().map(|(c, b)| (*c, *b)).collect();
        let pinned: Vec<u8> = self.pinned();
        let mut free = (1..=u8::MAX).filter(|number| !pinned.contains(number));
        for (cell, called) in called {
            let of = |part: u32| flat.cells.get((cell + part) as usize);
            let kept = of(0).is_some_and(|held| held.retain);
            let block = called.block;
            if kept && (block.is_timer() || block.is_edge()) {
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
                let looked = uses.looked.contains(&cell);
                if looked || live(3) && block != Standard::Tof {
                    self.seats.of.insert(cell + 3, Seat::Elapsed(index));
                }
                continue;
            }
            let (Some(count), Some(preset)) = (block.number(), block.preset()) else {
                continue;
            };
            if !block.is_counter() {
                continue;
            }
            let [up, down] = block.reached();
            let own = match self.seats.of.get(&(cell + count)) {
                Some(Seat::At(Address::Count(number))) => Some(*number),
                _ => free.next(),
            };
            let Some(number) = own.filter(|number| *number <= self.board.counters) else {
                self.none_left(COUNTER, self.board.counters.into(), cell);
                continue;
            };
            let own = block == Standard::Counter;
            self.seats.counters.insert(cell, number);
            self.seats
                .of
                .insert(cell + count, Seat::At(Address::Count(number)));
            if kept {
                self.seats.kept_counters.push(number);
            }
            let reached = |part| live(part) || steady(flat, uses, cell, cell + preset);
            if let Some(part) = up
                && (own || !kept && reached(part))
            {
                self.seats
                    .of
                    .insert(cell + part, Seat::At(Address::Reached(number)));
            }
            if let Some(part) = down
                && (own || live(part))
            {
                self.seats
                    .of
                    .insert(cell + part, Seat::At(Address::AtZero(number)));
            }
        }
    }
}
