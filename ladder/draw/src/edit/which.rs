//! Which instruction it is that does the same with another point, or the opposite with the same.

use super::refusal::Refusal;
use super::step::{Step, target_line};
use crate::words::picture;
use unoclp_core::isa::{Class, Kind, Opcode, POPPED};
use unoclp_point::Address;

/// Which coil of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Coil {
    /// `( )`
    Normal,
    /// `(/)`
    Negated,
    /// `(S)`
    Set,
    /// `(R)`
    Reset,
    /// `(L)`: a counter gets its preset.
    Load,
}

impl Step {
    /// It with this address. Where its instruction has no such point, the one that does the same with it.
    ///
    /// # Errors
    /// [`Refusal::NotThatAddress`] where there is none.
    pub fn with_address(&self, address: Option<Address>) -> Result<Step, Refusal> {
        with_address(self, address)
    }
}

/// The step with this address. Where its instruction has no such point, the one that does the same with it.
pub(crate) fn with_address(step: &Step, address: Option<Address>) -> Result<Step, Refusal> {
    let opcode = step.opcode();
    if opcode.row().kind == Kind::Timer {
        return with_target(step, address);
    }
    let Some(address) = address else {
        return match opcode.row().kind.has_number() {
            true => Ok(step.clone().with_number(None)),
            false => Err(Refusal::NotThatAddress),
        };
    };
    let like = |other: &&Opcode| is_like(opcode, **other) && takes(**other, address);
    let same = Some(&opcode).filter(|same| takes(**same, address));
    let other = same.or_else(|| Opcode::ALL.iter().find(like));
    let &other = other.ok_or(Refusal::NotThatAddress)?;
    let number = address.number();
    if number > POPPED {
        return Err(Refusal::OutOfRange);
    }
    Ok(step.clone().with_opcode(other).with_number(number))
}

fn with_target(step: &Step, address: Option<Address>) -> Result<Step, Refusal> {
    let target = address.map(|address| address.target().ok_or(Refusal::NotThatAddress));
    let preset = step.lines().first().copied().flatten();
    let lines = [preset, target.transpose()?.map(target_line)];
    Ok(step.clone().with_lines(lines))
}

/// Whether two instructions do the same, each with its own kind of point.
fn is_like(one: Opcode, other: Opcode) -> bool {
    let word = |opcode| picture(opcode).split_whitespace().next().unwrap_or("");
    one.class() == other.class()
        && one.is_inverted() == other.is_inverted()
        && match one.class() {
            Class::Contact | Class::Xor | Class::Load => true,
            Class::Coil | Class::Store => word(one) == word(other),
            _ => false,
        }
}

/// Whether an instruction names this point.
fn takes(opcode: Opcode, address: Address) -> bool {
    let kind = opcode.row().kind;
    let named = Address::in_code(kind, address.number()) == Some(address);
    // 00 is a constant, 99 what was pushed; a label is no operand.
    let is_operand = !kind.is_value() || (1..POPPED).contains(&address.number());
    named && is_operand && kind != Kind::Label
}

/// The step as this coil of its point.
pub(crate) fn with_coil(step: &Step, coil: Coil) -> Result<Step, Refusal> {
    let letter = match coil {
        Coil::Normal => "",
        Coil::Negated => "/",
        Coil::Set => "S",
        Coil::Reset => "R",
        Coil::Load => "L",
    };
    let kind = step.opcode().row().kind;
    let is = |other: &&Opcode| {
        other.class() == Class::Coil && other.row().kind == kind && picture(**other) == letter
    };
    let found = Opcode::ALL.iter().find(is);
    match (step.class(), found) {
        (Class::Coil, Some(&opcode)) => Ok(step.clone().with_opcode(opcode)),
        _ => Err(Refusal::NoSuchCoil),
    }
}

/// The step that conducts where this one does not, writes what this one does not, or takes place where it does not.
pub(crate) fn opposite(step: &Step) -> Result<Step, Refusal> {
    const PAIRS: [(Opcode, Opcode); 5] = [
        (Opcode::Greater, Opcode::LessOrEqual),
        (Opcode::GreaterOrEqual, Opcode::Less),
        (Opcode::Equal, Opcode::NotEqual),
        (Opcode::UnsignedGreaterOrEqual, Opcode::UnsignedLess),
        (Opcode::RisingEdge, Opcode::FallingEdge),
    ];
    let opcode = step.opcode();
    let paired = PAIRS.iter().find_map(|&(one, other)| match opcode {
        _ if opcode == one => Some(other),
        _ if opcode == other => Some(one),
        _ => None,
    });
    let negative = |other: &&Opcode| other.row().code == -opcode.row().code;
    let found = paired.or_else(|| Opcode::ALL.iter().find(negative).copied());
    let found = found.ok_or(Refusal::NoOpposite)?;
    Ok(step.clone().with_opcode(found))
}
