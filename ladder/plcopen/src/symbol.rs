//! What variables are on the board, and what is written at contacts and inputs.

use unoclp_lang::given;
use unoclp_lang::typed::{Base, Enumeration};
use unoclp_point::Address;

/// What a variable is on the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Symbol {
    /// A point, or a part of a timer or counter; a timer by the order in which they were met.
    At(Address),
    /// What never changes.
    Constant(i32),
    /// A counter; what its Q says.
    Counter(u8, Counts),
    /// The marker of an SR or RS.
    Latch(u8),
    /// An R_TRIG or F_TRIG.
    Edge,
}

/// How a counter counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Counts {
    Up,
    Down,
    Both,
}

/// What is written at a contact or at the input of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meaning {
    Symbol(Symbol),
    Truth(bool),
}

/// The point that has the name of a variable.
pub(crate) fn point(symbol: Symbol) -> Option<Address> {
    match symbol {
        Symbol::At(Address::Pwm(_)) | Symbol::Constant(_) | Symbol::Edge => None,
        Symbol::At(point) => Some(point),
        Symbol::Counter(counter, _) => Some(Address::Counter(counter)),
        Symbol::Latch(marker) => Some(Address::Marker(marker)),
    }
}

/// The number, time or truth that a text says, as a register holds it.
pub(crate) fn number(text: &str) -> Option<i32> {
    let bases = [Base::Dint, Base::Time, Base::Dword, Base::Bool];
    let value = bases
        .into_iter()
        .find_map(|base| given(text, base, &Enumeration::default()))?;
    let number = value.int();
    i32::try_from(number)
        .or_else(|_| u32::try_from(number).map(u32::cast_signed))
        .ok()
}
