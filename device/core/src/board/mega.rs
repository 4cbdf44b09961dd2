//! The Arduino Mega 2560: the points that an exercise of school has and an UNO has not.

use super::uno::{ROWS, run_bytes};
use super::{Board, Engine};
use crate::Image;
use crate::isa::{Opcode, TABLE, packed_rows};

impl Engine {
    /// That of the Mega's firmware: the same as the [UNO's](Engine::UNO), where inputs from 05 and outputs from 05 on are
    /// bits of their own, as markers are.
    pub const MEGA: Engine = Engine {
        rows: packed_rows(&{
            let mut run = [0; TABLE.len()];
            let mut row = 0;
            while row < TABLE.len() {
                run[row] = match ROWS[row] {
                    // Of an output from 05 on: an escape, the handler, and an address of two bytes. The loader adds the
                    // last one.
                    Opcode::SetCoil | Opcode::ResetCoil => 3,
                    // It has the outputs 05 to 08 as a second byte.
                    Opcode::StoreOutputs => 4,
                    row => run_bytes(row),
                };
                row += 1;
            }
            run
        }),
        fast_outputs: 4,
        ..Engine::UNO
    };
}

impl Board {
    /// The Arduino Mega 2560 with the standard wiring: 24 inputs, 16 outputs of which nine can be PWM, and eight analogue
    /// inputs, each on a pin of its own.
    pub const MEGA: Board = Board {
        name: "Mega",
        inputs: 24,
        outputs: 16,
        analogue: 8,
        shared_from: 0,
        // 01, 02, 04 to 07 and 12 to 14: D2, D3, D5 to D8, D46 to D44.
        pwm: Image(0b0011_1000_0111_1011),
        stored_bytes: 3_500,
        linked_bytes: 5_600,
        engine: &Engine::MEGA,
        ..Board::UNO
    };
}

/// The firmware has room for just these.
#[cfg(target_arch = "avr")]
const _: () = {
    use crate::width::{ANALOGUE, INPUTS, LABELS};
    let board = Board::MEGA;
    assert!(board.inputs == INPUTS && board.labels == LABELS && board.analogue == ANALOGUE);
};
