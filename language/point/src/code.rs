//! The points that instructions name, there and back.

use crate::Address;
use unoclp_core::isa::{self, Opcode, Operand, Value};
use unoclp_core::{Instruction, Number, Target};

impl Address {
    /// The point that an instruction names; none where it names none, or several at once.
    pub fn of(instruction: Instruction<'_>) -> Option<Address> {
        match (instruction.opcode.row().kind, instruction.operand) {
            (_, Operand::Value(Value::Register(register))) => Some(Address::Register(register)),
            (isa::Kind::Value | isa::Kind::Real, _) => None,
            (kind, _) => Address::in_code(kind, instruction.number()?),
        }
    }

    /// The point that XX is in an instruction of this kind. A register 00 is one, where a constant may stand too.
    pub fn in_code(kind: isa::Kind, number: u8) -> Option<Address> {
        use isa::Kind;
        let point = match kind {
            Kind::Input => Address::Input,
            Kind::Output | Kind::Pwm => Address::Output,
            Kind::Marker => Address::Marker,
            Kind::System => Address::System,
            Kind::TimerQ => Address::Timer,
            Kind::Counter | Kind::Count => Address::Counter,
            Kind::Register | Kind::Move | Kind::Drum | Kind::Table => Address::Register,
            Kind::Value | Kind::Real => Address::Register,
            Kind::Analogue => Address::Analogue,
            Kind::Label | Kind::Jump => Address::Label,
            Kind::None | Kind::Branch | Kind::Reading | Kind::Group | Kind::Bit => return None,
            Kind::Time | Kind::Timer | Kind::Scale | Kind::Filter => return None,
        };
        Some(point(number))
    }

    /// Its contact, normally open or, negated, normally closed; none of what has none.
    pub fn contact(self, negated: bool) -> Option<Opcode> {
        let opcodes = match self {
            Address::Input(_) => [Opcode::InputContact, Opcode::InputContactNot],
            Address::Output(_) => [Opcode::OutputContact, Opcode::OutputContactNot],
            Address::Marker(_) => [Opcode::MarkerContact, Opcode::MarkerContactNot],
            Address::System(_) => [Opcode::SystemContact, Opcode::SystemContactNot],
            Address::TimerQ(_) => [Opcode::TimerContact, Opcode::TimerContactNot],
            Address::Reached(_) => [Opcode::CounterContact, Opcode::CounterContactNot],
            Address::AtZero(_) => [Opcode::ZeroContact, Opcode::ZeroContactNot],
            _ => return None,
        };
        Some(opcodes[usize::from(negated)])
    }

    /// XOR with it or, negated, with its opposite; none of what has none.
    pub fn xor(self, negated: bool) -> Option<Opcode> {
        let opcodes = match self {
            Address::Input(_) => [Opcode::XorInput, Opcode::XorInputNot],
            Address::Output(_) => [Opcode::XorOutput, Opcode::XorOutputNot],
            Address::Marker(_) => [Opcode::XorMarker, Opcode::XorMarkerNot],
            _ => return None,
        };
        Some(opcodes[usize::from(negated)])
    }

    /// It as what a timer drives, or as the timer that a block calls again; none where it is neither.
    pub const fn target(self) -> Option<Target> {
        match self {
            Address::Output(number) => Some(Target::Output(number)),
            Address::Marker(number) => Some(Target::Marker(number)),
            Address::Timer(number) => Some(Target::Timer(number)),
            _ => None,
        }
    }

    /// It as a number that outlasts a power cut; none where it is none.
    pub const fn kept(self) -> Option<Number> {
        match self {
            Address::Register(number) => Some(Number::Register(number)),
            Address::Counter(number) | Address::Count(number) => Some(Number::Counter(number)),
            _ => None,
        }
    }
}

impl From<Target> for Address {
    fn from(target: Target) -> Address {
        match target {
            Target::Output(number) => Address::Output(number),
            Target::Marker(number) => Address::Marker(number),
            Target::Timer(number) => Address::Timer(number),
        }
    }
}

impl From<Number> for Address {
    fn from(number: Number) -> Address {
        match number {
            Number::Register(number) => Address::Register(number),
            Number::Counter(number) => Address::Count(number),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_board_knows_of_points_is_taken_back() {
        for target in [Target::Output(4), Target::Marker(64), Target::Timer(22)] {
            assert_eq!(Address::from(target).target(), Some(target));
        }
        for number in [Number::Register(98), Number::Counter(16)] {
            assert_eq!(Address::from(number).kept(), Some(number));
        }
        assert_eq!(Address::Input(1).target(), None);
        assert_eq!(Address::Output(1).kept(), None);
    }

    #[test]
    fn a_contact_and_its_xor_name_their_point() {
        for point in [
            Address::Input(1),
            Address::Output(1),
            Address::Marker(1),
            Address::System(1),
        ] {
            for negated in [false, true] {
                for opcode in point.contact(negated).into_iter().chain(point.xor(negated)) {
                    assert_eq!(Address::in_code(opcode.row().kind, 1), Some(point));
                    assert_eq!(opcode.is_inverted(), negated, "{opcode:?}");
                }
            }
        }
        assert_eq!(Address::Register(1).contact(false), None);
    }
}
