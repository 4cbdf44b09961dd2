//! The points of a text in Instruction List: what can be read and written of the board.

use unoclp_point::Address;

/// A bit that can be read; the Q of a timer by its index among the names, since its number depends on its block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bit {
    At(Address),
    Timer(usize),
}

/// A number that can be read or written; those of a timer by its index likewise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Num {
    Const(i32),
    At(Address),
    Elapsed(usize),
    TimerPreset(usize),
}
