//! Which points of the board a program has: those that addresses name, and those that are allotted.
//!
//! Owns which are still free. Must not know how an address is written: the languages read it.

use crate::adapt::adapt;
use crate::found::Found;
use std::collections::HashMap;
use unoclp_core::Board;
use unoclp_core::isa::REGISTERS;
use unoclp_lang::{Code, Span, Word};
use unoclp_point::Address;

/// The points that are still free.
pub(crate) struct Points {
    pub(crate) board: Board,
    markers: u128,
    registers: u128,
    counters: u128,
    labels: u128,
    timers: u8,
    /// Where points are that no board has.
    moved: HashMap<String, String>,
}

impl Points {
    /// Of a project, for a board.
    pub(crate) fn of(project: &str, board: Board) -> Points {
        let moved = match board.has_firmware() {
            true => None,
            false => adapt(project, board),
        };
        Points {
            board,
            moved: moved.map_or(HashMap::new(), |moved| moved.moved.into_iter().collect()),
            markers: 0,
            registers: 0,
            counters: 0,
            labels: 0,
            timers: 0,
        }
    }

    /// The point that an address names: `%IX0.0`.
    ///
    /// # Errors
    /// What to write, where the board has no such point.
    pub(crate) fn address(&self, address: &str) -> Result<Address, Word> {
        unoclp_lang::point(self.moved(address).unwrap_or(address), self.board)
    }

    /// The point in the place of one that no board has.
    pub(crate) fn moved(&self, address: &str) -> Option<&str> {
        let key: String = address.to_uppercase().split_whitespace().collect();
        self.moved.get(&key).map(String::as_str)
    }

    /// Tells where a point is that no board has.
    pub(crate) fn tell_moved(&self, address: &str, at: Span, found: &mut Found) {
        if let Some(moved) = self.moved(address) {
            found.tell_at(Code::StMoved, at, [address.trim().into(), moved.into()]);
        }
    }

    /// Leaves out the point of this address where others are allotted.
    pub(crate) fn take(&mut self, address: &str) {
        match self.address(address) {
            Ok(Address::Marker(number)) => self.markers |= 1 << number,
            Ok(Address::Register(number)) => self.registers |= 1 << number,
            _ => {}
        }
    }

    /// A marker; one that is kept over a power cut, where that is asked for.
    pub(crate) fn marker(&mut self, retain: bool) -> Option<u8> {
        let mut numbers = self.board.markers_that(retain);
        let number = numbers.find(|number| self.markers >> number & 1 == 0)?;
        self.markers |= 1 << number;
        Some(number)
    }

    /// A register.
    pub(crate) fn register(&mut self) -> Option<u8> {
        let number = (1..=REGISTERS).find(|number| self.registers >> number & 1 == 0)?;
        self.registers |= 1 << number;
        Some(number)
    }

    /// A counter: of one that is called C1, C2 … the one with that number, where it is free.
    pub(crate) fn counter(&mut self, name: &str) -> Option<u8> {
        let own = name.strip_prefix(['C', 'c']).and_then(|n| n.parse().ok());
        let most = self.board.counters;
        let is_free = |number: &u8| (1..=most).contains(number) && self.counters >> number & 1 == 0;
        let number = own.filter(is_free).or_else(|| (1..=most).find(is_free))?;
        self.counters |= 1 << number;
        Some(number)
    }

    /// The label with the number that its name says, L1, L2 …, where it is free.
    pub(crate) fn own_label(&mut self, name: &str) -> Option<u8> {
        let own: u8 = name.strip_prefix(['L', 'l'])?.parse().ok()?;
        let is_free = (1..=self.board.labels).contains(&own) && self.labels >> own & 1 == 0;
        if !is_free {
            return None;
        }
        self.labels |= 1 << own;
        Some(own)
    }

    /// A label.
    pub(crate) fn label(&mut self) -> Option<u8> {
        let number = (1..=self.board.labels).find(|number| self.labels >> number & 1 == 0)?;
        self.labels |= 1 << number;
        Some(number)
    }

    /// A timer, by the order in which they are allotted.
    pub(crate) fn timer(&mut self) -> Option<u8> {
        self.timers = (self.timers < self.board.timers).then_some(self.timers + 1)?;
        Some(self.timers)
    }
}

/// How an address is written.
pub(crate) fn written(point: Address) -> Option<String> {
    let eights = |kind: &str, number: u8| {
        let index = number.checked_sub(1)?;
        Some(format!("%{kind}X{}.{}", index / 8, index % 8))
    };
    match point {
        Address::Input(number) => eights("I", number),
        Address::Output(number) => eights("Q", number),
        Address::Marker(number) => eights("M", number),
        Address::Register(number) => Some(format!("%MD{number}")),
        Address::Analogue(number) => Some(format!("%IW{number}")),
        _ => None,
    }
}
