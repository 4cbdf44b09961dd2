//! Points of a program, and the names that a person has given them.

use std::collections::BTreeMap;
use std::fmt;
use unoclp_core::Instruction;
use unoclp_core::isa::{Kind, Operand, Value};

/// A point that an element reads or writes; its number is that of the code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Address {
    /// An input, from 1.
    Input(u8),
    /// An output, from 1.
    Output(u8),
    /// A marker, from 1.
    Marker(u8),
    /// A system marker, from 1.
    System(u8),
    /// A timer, from 1 in file order.
    Timer(u8),
    /// A counter, from 1.
    Counter(u8),
    /// A register, from 1.
    Register(u8),
    /// An analogue input, from 0.
    Analogue(u8),
    /// A label, from 1.
    Label(u8),
}

/// What the points of a program are called; those without a name are shown by number alone.
pub type Names = BTreeMap<Address, String>;

/// The number of a point that a person has not given yet: no program has it. It is shown as `?`.
pub(crate) const UNKNOWN: u8 = u8::MAX;

impl Address {
    /// Its number; of timers that in file order.
    pub fn number(self) -> u8 {
        match self {
            Address::Input(number) | Address::Output(number) | Address::Marker(number) => number,
            Address::System(number) | Address::Timer(number) | Address::Counter(number) => number,
            Address::Register(number) | Address::Analogue(number) | Address::Label(number) => {
                number
            }
        }
    }

    /// The point that is written so: `I1`, `q4`, `M57`; none where none is.
    pub fn parse(text: &str) -> Option<Address> {
        let mut chars = text.chars();
        let point = match chars.next()?.to_ascii_uppercase() {
            'I' => Address::Input,
            'Q' => Address::Output,
            'M' => Address::Marker,
            'S' => Address::System,
            'T' => Address::Timer,
            'C' => Address::Counter,
            'D' => Address::Register,
            'A' => Address::Analogue,
            'L' => Address::Label,
            _ => return None,
        };
        let digits = chars.as_str();
        let number: u8 = digits.parse().ok()?;
        let is_number = digits.starts_with(|first: char| first.is_ascii_digit());
        (is_number && number != UNKNOWN).then(|| point(number))
    }

    /// The point that an instruction names; none where it names none, or several at once.
    pub fn of(instruction: Instruction<'_>) -> Option<Address> {
        let point = match instruction.opcode.row().kind {
            Kind::Input => Address::Input,
            Kind::Output | Kind::Pwm => Address::Output,
            Kind::Marker => Address::Marker,
            Kind::System => Address::System,
            Kind::TimerQ => Address::Timer,
            Kind::Counter | Kind::Count => Address::Counter,
            Kind::Register | Kind::Move | Kind::Drum | Kind::Table => Address::Register,
            Kind::Value | Kind::Real => {
                return match instruction.operand {
                    Operand::Value(Value::Register(register)) => Some(Address::Register(register)),
                    _ => None,
                };
            }
            Kind::Analogue => Address::Analogue,
            Kind::Label | Kind::Jump => Address::Label,
            Kind::None | Kind::Branch | Kind::Reading | Kind::Group | Kind::Bit => return None,
            Kind::Time | Kind::Timer | Kind::Scale | Kind::Filter => return None,
        };
        instruction.number().map(point)
    }
}

impl fmt::Display for Address {
    /// `I1`, `Q4`, `M57`, `S2`, `T12`, `C3`, `D32`, `A0`, `L1`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let letter = match self {
            Address::Input(_) => 'I',
            Address::Output(_) => 'Q',
            Address::Marker(_) => 'M',
            Address::System(_) => 'S',
            Address::Timer(_) => 'T',
            Address::Counter(_) => 'C',
            Address::Register(_) => 'D',
            Address::Analogue(_) => 'A',
            Address::Label(_) => 'L',
        };
        match self.number() {
            UNKNOWN => write!(f, "{letter}?"),
            number => write!(f, "{letter}{number}"),
        }
    }
}
