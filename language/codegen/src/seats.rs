//! The places of the board, and those that are taken.
//!
//! Owns markers and registers, lasting and for a statement. Must not know cells' types.

use super::flat::TEMPORARY;
use std::collections::HashMap;
use unoclp_core::Board;
use unoclp_core::isa::REGISTERS;
use unoclp_point::Address;

/// A place of the board; a timer by its index, since its number depends on where its block will stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Seat {
    At(Address),
    /// Its Q.
    Timer(usize),
    /// Its elapsed time.
    Elapsed(usize),
    /// The time stamp of the scan, ms.
    Now,
}

/// All of it.
#[derive(Debug, Default)]
pub(super) struct Seats {
    pub of: HashMap<u32, Seat>,
    pub timers: HashMap<u32, usize>,
    pub counters: HashMap<u32, u8>,
    /// PWM outputs that the program reads: it reads a register, which the output follows.
    pub outputs: HashMap<u32, u8>,
    /// What is kept: registers and counters.
    pub kept_registers: Vec<u8>,
    pub kept_counters: Vec<u8>,
    /// The board that has them.
    board: Option<Board>,
    /// Bit 0 is M 01, and D 01; those that are taken.
    pub markers: u128,
    pub registers: u128,
    /// Those that temporaries have now.
    pub busy: Vec<(u32, Seat)>,
    pub next: u32,
    pub none_left: bool,
}

impl Seats {
    /// None taken.
    pub(super) fn new(board: Board) -> Seats {
        Seats {
            board: Some(board),
            ..Seats::default()
        }
    }

    /// How many steps say what is kept: they stand before all others.
    pub(super) fn kept(&self) -> usize {
        self.kept_registers.len() + self.kept_counters.len()
    }

    pub(super) fn take(&mut self, seat: Seat) {
        match seat {
            Seat::At(Address::Marker(n @ 1..=99)) => self.markers |= 1 << (n - 1),
            Seat::At(Address::Register(n @ 1..=98)) => self.registers |= 1 << (n - 1),
            _ => {}
        }
    }

    pub(super) fn release(&mut self, seat: Seat) {
        match seat {
            Seat::At(Address::Marker(n @ 1..=99)) => self.markers &= !(1 << (n - 1)),
            Seat::At(Address::Register(n @ 1..=98)) => self.registers &= !(1 << (n - 1)),
            _ => {}
        }
    }

    pub(super) fn marker(&mut self, keeps: bool) -> Option<Seat> {
        let mut all = self.board?.markers_that(keeps);
        let free = all.find(|n| self.markers >> (n - 1) & 1 == 0)?;
        let seat = Seat::At(Address::Marker(free));
        self.take(seat);
        Some(seat)
    }

    /// The last marker that is free and keeps nothing.
    pub(super) fn last_marker(&mut self) -> Option<Seat> {
        let mut all = self.board?.markers_that(false).rev();
        let free = all.find(|n| self.markers >> (n - 1) & 1 == 0)?;
        let seat = Seat::At(Address::Marker(free));
        self.take(seat);
        Some(seat)
    }

    /// A place for a bit: a marker, or a register where none is left.
    fn bit(&mut self) -> Option<Seat> {
        self.marker(false).or_else(|| self.register())
    }

    pub(super) fn register(&mut self) -> Option<Seat> {
        let seat = Seat::At(Address::Register(
            (1..=REGISTERS).find(|n| self.registers >> (n - 1) & 1 == 0)?,
        ));
        self.take(seat);
        Some(seat)
    }

    pub(super) fn row(&mut self, length: u32) -> Option<u8> {
        let length = u8::try_from(length).ok()?;
        let is_free = |n: u8| self.registers >> (n - 1) & 1 == 0;
        let first = (1..=REGISTERS).find(|first| {
            first
                .checked_add(length)
                .is_some_and(|end| end <= REGISTERS + 1 && (*first..end).all(is_free))
        })?;
        (first..first + length).for_each(|n| self.take(Seat::At(Address::Register(n))));
        Some(first)
    }

    /// A cell of its own until the statement ends.
    pub(super) fn temporary(&mut self, bit: bool, wide: bool) -> u32 {
        let seat = match bit {
            true => self.bit(),
            false => self.register(),
        };
        let cell = TEMPORARY + (self.next << 1) + u32::from(wide);
        self.next += 1;
        let seat = seat.unwrap_or_else(|| {
            self.none_left = true;
            Seat::At(Address::Register(1))
        });
        self.of.insert(cell, seat);
        self.busy.push((cell, seat));
        cell
    }

    /// Whether this cell is a temporary, for such values as `wide` says or more.
    pub(super) fn is_temporary(&self, cell: u32, wide: bool) -> bool {
        cell >= TEMPORARY && (cell & 1 == 1 || !wide)
    }

    /// How many temporaries there are.
    pub(super) fn mark(&self) -> usize {
        self.busy.len()
    }

    /// Those beyond this number are needed no more.
    pub(super) fn release_to(&mut self, mark: usize) {
        while self.busy.len() > mark {
            if let Some((cell, seat)) = self.busy.pop() {
                self.of.remove(&cell);
                if !self.none_left {
                    self.release(seat);
                }
            }
        }
    }

    /// A marker or register for the whole program that no cell has.
    pub(super) fn lasting(&mut self, bit: bool) -> Option<Seat> {
        match bit {
            true => self.marker(false),
            false => self.register(),
        }
    }
}
