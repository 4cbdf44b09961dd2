//! The board that a program is checked for: on a PC any; in a firmware the one that it is compiled for, so that what it
//! cannot have is not compiled.

use crate::Board;

/// The board that is held.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Held {
    #[cfg(not(target_arch = "avr"))]
    board: Board,
}

#[cfg(not(target_arch = "avr"))]
impl Held {
    pub(crate) const fn new(board: Board) -> Held {
        Held { board }
    }

    pub(crate) const fn board(self) -> Board {
        self.board
    }

    pub(crate) const fn near_registers(self) -> u8 {
        self.board.engine.near_registers
    }
}

/// The UNO; a Nano has the same, but for what the loader asks of it itself.
#[cfg(all(target_arch = "avr", not(mega)))]
const COMPILED_FOR: Board = Board::UNO;

#[cfg(all(target_arch = "avr", mega))]
const COMPILED_FOR: Board = Board::MEGA;

#[cfg(target_arch = "avr")]
impl Held {
    #[inline(always)]
    pub(crate) const fn new(_: Board) -> Held {
        Held {}
    }

    #[inline(always)]
    pub(crate) const fn board(self) -> Board {
        COMPILED_FOR
    }

    #[inline(always)]
    pub(crate) const fn near_registers(self) -> u8 {
        const { COMPILED_FOR.engine.near_registers }
    }
}
