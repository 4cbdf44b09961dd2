//! What a program asks of the board's pins (NC-18).

use crate::held::Held;
use crate::isa::Kind;
use crate::{Bits, Board, Cause, ImageBits};

/// What a program uses of what not every program uses, a bit for each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Needs {
    /// Inputs, bit 0 input 01.
    pub inputs: Bits,
    /// Analogue inputs, bit 0 A 00.
    pub analogue: Bits,
    /// Outputs that are named, bit 0 output 01.
    pub outputs: Bits,
    /// Outputs that are PWM, bit 0 output 01.
    pub pwm: Bits,
    /// The time of the input filter, ms (NC-18).
    pub filter: u8,
    /// System markers, bit 0 S 01, and system readings, bit 4 reading 01.
    pub system: u8,
}

impl Needs {
    /// The inputs that are read, bit 0 input 01: of those that share pins with analogue inputs only the
    /// ones that are named; the others read as 0 (NC-18).
    pub fn digital(&self, board: &Board) -> ImageBits {
        let all: ImageBits = !(!0 << board.inputs);
        let shared = match board.shared_from {
            0 => 0,
            first => all & !0 << (first - 1),
        };
        all & (self.inputs as ImageBits | !shared)
    }

    /// Notes an instruction with its XX. A pin that is used twice is told once.
    pub(crate) fn note(&mut self, held: Held, kind: Kind, xx: u8) -> Result<(), Cause> {
        let before = self.twice(held);
        match kind {
            Kind::Input => self.inputs |= bit(xx),
            Kind::Analogue => self.analogue |= bit(xx.wrapping_add(1)),
            Kind::Output => self.outputs |= bit(xx),
            Kind::Pwm if bit(xx) & held.board().pwm.0 as Bits == 0 => {
                return Err(Cause::NoSuchPoint);
            }
            Kind::Pwm => self.pwm |= bit(xx),
            Kind::Time => self.filter = xx,
            Kind::System => self.system |= bit(xx) as u8,
            Kind::Reading => self.system |= bit(xx.wrapping_add(4)) as u8,
            Kind::None | Kind::Branch | Kind::Marker | Kind::TimerQ | Kind::Counter => {}
            Kind::Register | Kind::Group | Kind::Bit | Kind::Label | Kind::Jump => {}
            Kind::Timer | Kind::Count | Kind::Value | Kind::Move | Kind::Drum => {}
            Kind::Scale | Kind::Filter | Kind::Real | Kind::Table => {}
        }
        if self.twice(held) != before {
            return Err(Cause::PinUsedTwice);
        }
        Ok(())
    }

    /// The pins that are used twice: those of inputs above those of outputs.
    fn twice(&self, held: Held) -> Bits {
        let outputs = self.outputs & self.pwm;
        match held.board().shared_from {
            0 => outputs,
            first => self.inputs & self.analogue << (first - 1) | outputs,
        }
    }
}

/// The bit of the point with this number.
fn bit(number: u8) -> Bits {
    let mut bit = 1;
    for _ in 1..number {
        bit <<= 1;
    }
    bit
}
