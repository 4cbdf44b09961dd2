//! What a program asks of the board's pins (NC-18).

use crate::Cause;
use crate::isa::Kind;

/// What a program uses of what not every program uses, a bit for each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Needs {
    /// Inputs, bit 0 input 01. Those from 05 on share pins with analogue inputs.
    pub inputs: u8,
    /// Analogue inputs, bit 0 A 00.
    pub analogue: u8,
    /// Outputs that are named, bit 0 output 01.
    pub outputs: u8,
    /// Outputs that are PWM, bit 0 output 01.
    pub pwm: u8,
    /// The time of the input filter, ms (NC-18).
    pub filter: u8,
    /// System markers, bit 0 S 01, and system readings, bit 4 reading 01.
    pub system: u8,
}

/// The outputs that can be PWM: 01 and 04.
const PWM: u8 = 0b1001;

impl Needs {
    /// The inputs that are read, bit 0 input 01: of those that share pins with analogue inputs only the
    /// ones that are named; the others read as 0 (NC-18).
    pub fn digital(&self) -> u8 {
        self.inputs | 0x0F
    }

    /// Notes an instruction with its XX. A pin that is used twice is told once.
    pub(crate) fn note(&mut self, kind: Kind, xx: u8) -> Result<(), Cause> {
        let before = self.twice();
        match kind {
            Kind::Input => self.inputs |= bit(xx),
            Kind::Analogue => self.analogue |= bit(xx.wrapping_add(1)),
            Kind::Output => self.outputs |= bit(xx),
            Kind::Pwm if bit(xx) & PWM == 0 => return Err(Cause::NoSuchPoint),
            Kind::Pwm => self.pwm |= bit(xx),
            Kind::Time => self.filter = xx,
            Kind::System => self.system |= bit(xx),
            Kind::Reading => self.system |= bit(xx.wrapping_add(4)),
            Kind::None | Kind::Branch | Kind::Marker | Kind::TimerQ | Kind::Counter => {}
            Kind::Register | Kind::Group | Kind::Bit | Kind::Label | Kind::Jump => {}
            Kind::Timer | Kind::Count | Kind::Value | Kind::Move | Kind::Drum => {}
            Kind::Scale | Kind::Filter | Kind::Real | Kind::Table => {}
        }
        if self.twice() != before {
            return Err(Cause::PinUsedTwice);
        }
        Ok(())
    }

    /// The pins that are used twice: inputs in the upper half, outputs in the lower.
    fn twice(&self) -> u8 {
        self.inputs & self.analogue << 4 | self.outputs & self.pwm
    }
}

/// The bit of the point with this number, 1–8.
fn bit(number: u8) -> u8 {
    let mut bit = 1;
    for _ in 1..number {
        bit <<= 1;
    }
    bit
}
