//! What a point is.

use std::fmt;

macro_rules! points {
    ($($(#[$about:meta])* $name:ident $letter:literal,)*) => {
        /// What kind of point.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Kind {
            $($(#[$about])* $name,)*
        }

        /// A point of a board: which kind, and which of them. Whether a board has it, the board says.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Address {
            $($(#[$about])* $name(u8),)*
        }

        impl Kind {
            /// The letter that the board's documents write before its number.
            pub const fn letter(self) -> char {
                match self {
                    $(Kind::$name => $letter,)*
                }
            }
        }

        impl Address {
            /// The point of this kind and number.
            pub const fn new(kind: Kind, number: u8) -> Address {
                match kind {
                    $(Kind::$name => Address::$name(number),)*
                }
            }

            /// What kind it is.
            pub const fn kind(self) -> Kind {
                match self {
                    $(Address::$name(_) => Kind::$name,)*
                }
            }

            /// Which of its kind, counted as the kind says.
            pub const fn number(self) -> u8 {
                match self {
                    $(Address::$name(number) => number,)*
                }
            }
        }
    };
}

points! {
    /// An input, from 1.
    Input 'I',
    /// An output, from 1.
    Output 'Q',
    /// A marker, from 1.
    Marker 'M',
    /// A system marker, from 1.
    System 'S',
    /// A timer as a whole, from 1 in file order; in a text by the number in its name.
    Timer 'T',
    /// The Q of a timer.
    TimerQ 'T',
    /// The elapsed time of a timer.
    Elapsed 'T',
    /// The preset of a timer.
    TimerPreset 'T',
    /// A counter as a whole, from 1.
    Counter 'C',
    /// Whether a counter has reached its preset.
    Reached 'C',
    /// Whether a counter is at 0 or less.
    AtZero 'C',
    /// The number of a counter.
    Count 'C',
    /// The preset of a counter.
    CountPreset 'C',
    /// A register, from 1.
    Register 'D',
    /// An analogue input, from 0.
    Analogue 'A',
    /// A label, from 1.
    Label 'L',
    /// The PWM of an output, by the output's number.
    Pwm 'P',
    /// Eight markers as one number, from 1.
    Group 'M',
    /// All inputs as one number; its number is 0.
    Inputs 'I',
    /// All outputs as one number; its number is 0.
    Outputs 'Q',
    /// No point but always 1, as `SM0.0` of Siemens is; its number is 0.
    Always 'S',
}

/// The number of a point that a person has not given yet: no program has it. It is shown as `?`.
pub const UNKNOWN: u8 = u8::MAX;

impl Address {
    /// Whether it is one bit.
    pub const fn is_bit(self) -> bool {
        use Kind::{Always, AtZero, Input, Marker, Output, Reached, System, TimerQ};
        matches!(
            self.kind(),
            Input | Output | Marker | System | TimerQ | Reached | AtZero | Always
        )
    }

    /// Whether a program may write it.
    pub const fn is_written(self) -> bool {
        use Kind::{
            Count, CountPreset, Group, Marker, Output, Outputs, Pwm, Register, TimerPreset,
        };
        matches!(
            self.kind(),
            Output | Marker | Pwm | Register | Group | Outputs | Count | CountPreset | TimerPreset
        )
    }

    /// The point that the board's documents write so: `I1`, `q4`, `M57`; none where none is.
    pub fn parse(text: &str) -> Option<Address> {
        use Kind::{Analogue, Counter, Input, Label, Marker, Output, Register, System, Timer};
        let all = [
            Input, Output, Marker, System, Timer, Counter, Register, Analogue, Label,
        ];
        let letter = text.chars().next()?;
        let is_it = |kind: &Kind| kind.letter() == letter.to_ascii_uppercase();
        let kind = all.into_iter().find(is_it)?;
        let digits = text.get(1..)?;
        let is_number = digits.starts_with(|first: char| first.is_ascii_digit());
        let number = digits.parse().ok().filter(|number| *number != UNKNOWN);
        Some(Address::new(kind, number.filter(|_| is_number)?))
    }
}

impl fmt::Display for Address {
    /// `I1`, `Q4`, `M57`, `S2`, `T12`, `C3`, `D32`, `A0`, `L1`, `P1`; with `#` as a list of a program spells it:
    /// `I 01`, and a PWM by its output.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let letter = self.kind().letter();
        match (self, self.number()) {
            (_, UNKNOWN) => write!(f, "{letter}?"),
            (Address::Pwm(number), _) if f.alternate() => write!(f, "Q {number:02}"),
            (_, number) if f.alternate() => write!(f, "{letter} {number:02}"),
            (_, number) => write!(f, "{letter}{number}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_documents_write_is_read_again() {
        for text in ["I1", "Q4", "M57", "S2", "T12", "C3", "D32", "A0", "L1"] {
            let point = Address::parse(text).unwrap();
            assert_eq!(point.to_string(), text);
            assert_eq!(Address::new(point.kind(), point.number()), point);
        }
        assert_eq!(Address::parse("q4"), Some(Address::Output(4)));
        for text in ["", "I", "X1", "I+1", "I256", "I255", "é1", "I1 ", "P1"] {
            assert_eq!(Address::parse(text), None, "{text}");
        }
    }

    #[test]
    fn a_point_has_two_forms() {
        for (point, short, long) in [
            (Address::Register(7), "D7", "D 07"),
            (Address::Pwm(1), "P1", "Q 01"),
            (Address::Elapsed(12), "T12", "T 12"),
            (Address::Marker(UNKNOWN), "M?", "M?"),
        ] {
            assert_eq!(
                (point.to_string(), format!("{point:#}")),
                (short.into(), long.into())
            );
        }
    }
}
