//! What drives a part.

use unoclp_core::Point;

/// Where a signal comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    /// An output of the PLC.
    Output(Point),
    /// The PWM of the output with this number.
    Pwm(u8),
    /// A value of another part, by the numbers of both.
    Value(usize, usize),
    /// Nothing: it is off.
    Nothing,
}

/// What drives a part; turned round where `not` stands before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Signal {
    pub source: Source,
    pub not: bool,
}

/// A contact of a part, and the input that it switches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Contact {
    pub input: Point,
    /// It opens as it is actuated.
    pub normally_closed: bool,
}

/// What a field of a part was given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Given {
    Nothing,
    Number(i32),
    Signal(Signal),
    Contact(Contact),
    Analogue(u8),
    Part(usize),
    Value(usize, usize),
    Choice(usize),
}

/// Where a value of a condition is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum At {
    /// In this cell of the plant.
    Cell(usize),
    /// An output of the PLC.
    Output(Point),
    /// An input.
    Input(Point),
    /// The time since the first step, ms.
    Clock,
}
