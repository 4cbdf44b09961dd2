//! A board as the loader knows it.

use super::Board;
use crate::isa::{KIND, KINDS, Kind, PACKED, Rows, packed_kind};

/// What the loader asks: the facts of a board, and its packed instruction table from where it keeps that.
pub trait Facts: Rows {
    /// What it has.
    fn board(&self) -> Board;
}

/// A board that keeps constants in memory like all else.
impl Facts for Board {
    fn board(&self) -> Board {
        *self
    }
}

impl Rows for Board {
    fn read(&self, at: usize, bytes: &mut [u8]) {
        let rows = self.engine.rows.iter().skip(at);
        for (byte, &packed) in bytes.iter_mut().zip(rows) {
            *byte = packed;
        }
        for (byte, at) in bytes.iter_mut().zip(at..PACKED) {
            if at >= KINDS {
                *byte = self.packed_byte(at);
            }
        }
    }
}

impl Board {
    /// Its packed instruction table, for a firmware to keep apart from RAM.
    pub const fn packed(&self) -> [u8; PACKED] {
        let mut packed = [0; PACKED];
        let mut at = 0;
        while at < packed.len() {
            packed[at] = self.packed_byte(at);
            at += 1;
        }
        packed
    }

    const fn packed_byte(&self, at: usize) -> u8 {
        if at < KINDS {
            self.engine.rows[at]
        } else {
            let kind = Kind::ALL[(at - KINDS) / KIND];
            packed_kind(kind, self.numbers(kind))[(at - KINDS) % KIND]
        }
    }
}
