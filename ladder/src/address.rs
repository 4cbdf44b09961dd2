//! Points of a program, and the names that a person has given them.

use std::collections::BTreeMap;
use std::fmt;

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

impl fmt::Display for Address {
    /// `I1`, `Q4`, `M57`, `S2`, `T12`, `C3`, `D32`, `A0`, `L1`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (letter, number) = match self {
            Address::Input(number) => ('I', number),
            Address::Output(number) => ('Q', number),
            Address::Marker(number) => ('M', number),
            Address::System(number) => ('S', number),
            Address::Timer(number) => ('T', number),
            Address::Counter(number) => ('C', number),
            Address::Register(number) => ('D', number),
            Address::Analogue(number) => ('A', number),
            Address::Label(number) => ('L', number),
        };
        write!(f, "{letter}{number}")
    }
}
