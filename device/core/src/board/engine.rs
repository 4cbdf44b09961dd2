//! How a board runs a program, and what that takes of run memory.

use crate::isa::{
    self, Class, KINDS, Line, MARKER_TARGET, Opcode, REGISTERS, TABLE, TIMER_DATA, TIMER_TARGET,
    packed_rows, packed_run_bytes,
};
use core::fmt;

/// How a board runs a program: from its stored form, or from a linked form that the board's firmware makes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Engine {
    /// The rows of the packed instruction table.
    pub(crate) rows: [u8; KINDS],
    /// Whether it runs a linked form; if not, run memory holds data alone.
    pub links: bool,
    /// Inputs 01 to this number take one byte of a linked form, those beyond two.
    pub fast_inputs: u8,
    /// Outputs 01 to this number take one byte of a linked form, those beyond two, as markers do. Where all do, it is
    /// [`MARKER_TARGET`].
    pub fast_outputs: u8,
    /// Registers D 01 to this number are always there; those beyond take run memory, 4 bytes each up to the highest that
    /// is named (NC-27).
    pub near_registers: u8,
}

impl Engine {
    /// The core itself ([`Plc`](crate::Plc)): it runs the stored form.
    pub const CORE: Engine = Engine {
        rows: packed_rows(&{
            let mut run = [0; TABLE.len()];
            let mut row = 0;
            while row < TABLE.len() {
                run[row] = match TABLE[row].class {
                    Class::Timer => TIMER_DATA as u8,
                    _ => TABLE[row].own,
                };
                row += 1;
            }
            run
        }),
        links: false,
        fast_inputs: u8::MAX,
        fast_outputs: MARKER_TARGET,
        near_registers: REGISTERS,
    };

    /// Bytes of run memory of an instruction, its data among them. More for what [`line_bytes`](Engine::line_bytes) and
    /// [`operand_bytes`](Engine::operand_bytes) tell; of one that links, one for inputs beyond
    /// [`fast_inputs`](Engine::fast_inputs) and outputs beyond [`fast_outputs`](Engine::fast_outputs), two for a store to a register beyond
    /// [`near_registers`](Engine::near_registers); and each counter's data.
    pub const fn run_bytes(&self, opcode: Opcode) -> u8 {
        packed_run_bytes(&self.rows, opcode)
    }

    /// Bytes of run memory of an operand whose XX is stored so: where it is from, then an address or a constant.
    pub const fn operand_bytes(&self, xx: u8) -> u8 {
        let bytes = isa::constant_bytes(xx);
        if !self.links {
            0
        } else if bytes > 0 {
            1 + bytes
        } else if xx == isa::POPPED {
            1
        } else if xx > self.near_registers {
            3
        } else {
            2
        }
    }

    /// Bytes of run memory that a line, stored as this, adds to those of its instruction.
    pub const fn line_bytes(&self, line: Line, stored: u8) -> u8 {
        match line {
            _ if !self.links => 0,
            Line::Step => 1,
            Line::Target if stored >= TIMER_TARGET => 2,
            Line::Target if stored >= self.fast_outputs => 1,
            _ => 0,
        }
    }
}

impl fmt::Debug for Engine {
    /// Without the bytes of 120 instructions.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.links { "linked" } else { "core" })
    }
}
