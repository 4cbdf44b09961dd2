//! The board that a program is for, and what it has.
//!
//! Owns how a request names a board, and what a page is told of one. Must not know what a program does with a point.

use crate::answer::answer;
use crate::given::Given;
use crate::words::{self, Both, both};
use unoclp_core::Board;
use unoclp_core::isa::{REGISTERS, RETENTIVE};

answer! {
    /// What a board has.
    pub struct Facts as "BoardFacts" {
        /// How a request names it.
        id: &'static str,
        /// What people call it.
        name: &'static str,
        /// How a request names each that there is.
        all: [&'static str; Board::ALL.len()],
        /// Whether a board can be flashed that has this; if not, its programs run on a PC alone.
        firmware: bool,
        /// Whether it has the instructions of REAL numbers.
        real: bool,
        /// Inputs 01 to this number.
        inputs: u8,
        /// Outputs 01 to this number.
        outputs: u8,
        /// Analogue inputs A 00 to below this number.
        analogue: u8,
        /// The outputs that can be PWM.
        pwm: Vec<u8>,
        /// An input and the analogue input on the same pin: a program has the one or the other.
        shared: Vec<[u8; 2]>,
        /// Markers M 01 to this number.
        markers: u8,
        /// The first and the last marker that keeps its state over a power cut.
        retentive: [u8; 2],
        /// Registers D 01 to this number.
        registers: u8,
        /// Registers D 01 to this number take no memory of a program.
        near_registers: u8,
        /// Counters C 01 to this number.
        counters: u8,
        /// Timers of a program.
        timers: u8,
        /// Labels 01 to this number.
        labels: u8,
        /// Bytes of a program's stored form.
        stored: u16,
        /// Bytes of its linked form and its data.
        linked: u16,
    }
}

impl Facts {
    /// Of this board.
    pub fn of(board: Board) -> Facts {
        let shares = |analogue| Some([board.shares(analogue)?, analogue]);
        Facts {
            id: board.id(),
            name: board.name,
            all: Board::ALL.map(|board| board.id()),
            firmware: board.has_firmware(),
            real: board.real,
            inputs: board.inputs,
            outputs: board.outputs,
            analogue: board.analogue,
            pwm: board.pwm_outputs().collect(),
            shared: (0..board.analogue).filter_map(shares).collect(),
            markers: board.markers,
            retentive: [RETENTIVE, RETENTIVE + 7],
            registers: REGISTERS,
            near_registers: board.engine.near_registers,
            counters: board.counters,
            timers: board.timers,
            labels: board.labels,
            stored: board.stored_bytes,
            linked: board.linked_bytes,
        }
    }
}

/// The numbers of the points that are 1: bit 0 is point 01.
pub fn numbers(bits: impl Into<u128>) -> Vec<u8> {
    let bits = bits.into();
    (1..=128)
        .filter(|number| bits >> (number - 1) & 1 != 0)
        .collect()
}

/// The board that a request is for: the UNO, where it names none.
///
/// # Errors
/// Where there is none of the name.
pub fn board(given: &mut Given) -> Result<Board, Both> {
    let Some(name) = given.text_if("board")? else {
        return Ok(Board::UNO);
    };
    Board::named(&name).ok_or_else(|| {
        let known = Board::ALL.map(|board| board.id()).join(", ");
        both(|lang| words::no_such_board(lang, &name, &known))
    })
}
