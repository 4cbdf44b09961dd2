//! What variables are on the board, and what is written at contacts and inputs.

use crate::points::Point;
use unoclp_lang::given;
use unoclp_lang::typed::Base;
use unoclp_point::Address;

/// What a variable is on the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Symbol {
    /// A point that is 0 or 1.
    Bit(Address),
    /// A register or an analogue input.
    Number(Address),
    /// The PWM of an output.
    Pwm(u8),
    /// What never changes.
    Constant(i32),
    /// A timer, by the order in which they were met.
    Timer(u8),
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
    /// Q of a counter at 0 or below.
    AtZero(u8),
    /// The elapsed time of a timer.
    Elapsed(u8),
    /// The number of a counter.
    Count(u8),
    Truth(bool),
}

/// The point that has the name of a variable.
pub(crate) fn point(symbol: Symbol) -> Option<Address> {
    match symbol {
        Symbol::Bit(point) | Symbol::Number(point) => Some(point),
        Symbol::Timer(timer) => Some(Address::Timer(timer)),
        Symbol::Counter(counter, _) => Some(Address::Counter(counter)),
        Symbol::Latch(marker) => Some(Address::Marker(marker)),
        Symbol::Pwm(_) | Symbol::Constant(_) | Symbol::Edge => None,
    }
}

/// What a point is.
pub(crate) fn symbol_of(point: Point) -> Symbol {
    match point {
        Point::At(point @ (Address::Register(_) | Address::Analogue(_))) => Symbol::Number(point),
        Point::At(point) => Symbol::Bit(point),
        Point::Pwm(output) => Symbol::Pwm(output),
    }
}

/// The number, time or truth that a text says, as a register holds it.
pub(crate) fn number(text: &str) -> Option<i32> {
    let bases = [Base::Dint, Base::Time, Base::Dword, Base::Bool];
    let value = bases.into_iter().find_map(|base| given(text, base, &[]))?;
    let number = value.int();
    i32::try_from(number)
        .or_else(|_| u32::try_from(number).map(u32::cast_signed))
        .ok()
}
