//! How texts count points: the number after the letters, there and back.

use crate::Kind;

/// Whose way of writing points a text has, where they differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Maker {
    /// IEC 61131-3, Festo, Siemens.
    #[default]
    Iec,
    /// Mitsubishi.
    Mitsubishi,
    /// OMRON.
    Omron,
    /// Schneider's Twido.
    Twido,
    /// SimuPLC, whose language is LCE.
    Simuplc,
}

/// How a number is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Count {
    /// As the point is numbered: `I1`, `IW0`.
    Numbered,
    /// From 0 what is numbered from 1: `%M0`.
    FromZero,
    /// Byte and bit, eight to a byte, from 0: `I0.0`.
    Eights,
    /// Word and bit, sixteen to a word, from 0: `W0.00`.
    Sixteens,
    /// In the word of this number, bits from 0: `100.00`.
    Channel(u16),
    /// From 0, octal: `X10`.
    Octal,
    /// By the first of two bytes: `AIW4`.
    Pairs,
    /// Siemens's flags of byte 0: always 1, the first scan, the clock.
    Flags,
    /// All of them, whatever the number: `IB0`.
    All,
}

/// The system markers that have a bit of Siemens's byte 0, by those bits.
const FLAGS: [(u32, u16); 3] = [(0, 0), (1, 1), (5, 2)];

impl Count {
    /// What letters and a dot say of a maker's points: the kind, and how it is counted.
    pub(crate) fn of(
        letters: &str,
        word: u32,
        dotted: bool,
        maker: Maker,
    ) -> Option<(Kind, Count)> {
        use Count::{All, Channel, Eights, Flags, FromZero, Numbered, Octal, Pairs, Sixteens};
        let plain = match maker {
            Maker::Twido | Maker::Mitsubishi => FromZero,
            _ => Numbered,
        };
        if maker == Maker::Simuplc
            && !matches!((letters, dotted), ("I" | "Q" | "M", true) | ("AIW", false))
        {
            return None;
        }
        Some(match (letters, dotted, maker) {
            ("I" | "IX", true, _) => (Kind::Input, Eights),
            ("I" | "IX", false, _) => (Kind::Input, Numbered),
            ("Q" | "QX", true, _) => (Kind::Output, Eights),
            ("Q" | "QX", false, _) => (Kind::Output, Numbered),
            ("M" | "MX", true, _) => (Kind::Marker, Eights),
            ("M" | "MX", false, _) => (Kind::Marker, plain),
            ("X", false, Maker::Mitsubishi) => (Kind::Input, Octal),
            ("Y", false, Maker::Mitsubishi) => (Kind::Output, Octal),
            ("W", true, Maker::Omron) => (Kind::Marker, Sixteens),
            ("", true, Maker::Omron) if word == 0 => (Kind::Input, Channel(0)),
            ("", true, Maker::Omron) if word == 10 => (Kind::Output, Channel(10)),
            ("", true, Maker::Omron) if word == 100 => (Kind::Output, Channel(100)),
            ("S", false, _) => (Kind::System, Numbered),
            ("SM", _, _) => (Kind::System, Flags),
            ("IW", false, _) | ("AIW", false, Maker::Simuplc) => (Kind::Analogue, Numbered),
            ("AIW", false, _) => (Kind::Analogue, Pairs),
            ("QW", false, _) => (Kind::Pwm, Numbered),
            ("D" | "MW" | "MD" | "VW", false, _) => (Kind::Register, plain),
            ("MB", false, _) => (Kind::Group, Numbered),
            ("IB", false, _) => (Kind::Inputs, All),
            ("QB", false, _) => (Kind::Outputs, All),
            _ => return None,
        })
    }

    /// The number of the point; none where nothing is counted so, such as bit 8 of a byte.
    pub(crate) fn number(self, digits: &str, bit: Option<&str>) -> Option<u16> {
        let decimal = |digits: &str| digits.parse::<u16>().ok();
        let bits = |most: u16, first: u16| {
            let bit = bit.and_then(decimal).filter(|bit| *bit < most)?;
            first.checked_mul(most)?.checked_add(bit)?.checked_add(1)
        };
        match self {
            Count::Numbered => decimal(digits),
            Count::FromZero => decimal(digits)?.checked_add(1),
            Count::Eights => bits(8, decimal(digits)?),
            Count::Sixteens => bits(16, decimal(digits)?),
            Count::Channel(_) => bits(16, 0),
            Count::Octal => u16::from_str_radix(digits, 8).ok()?.checked_add(1),
            Count::Pairs => Some(decimal(digits)? / 2),
            Count::Flags => {
                let bit = u32::from(bit.and_then(decimal)?);
                let flag = FLAGS
                    .iter()
                    .find(|flag| decimal(digits) == Some(0) && flag.0 == bit);
                flag.map(|flag| flag.1)
            }
            Count::All => Some(0),
        }
    }

    /// A number as it is written after the letters; none of what is not counted so.
    pub fn written(self, number: u16) -> Option<String> {
        let from_zero = number.checked_sub(1);
        Some(match self {
            Count::Numbered => number.to_string(),
            Count::FromZero => from_zero?.to_string(),
            Count::Eights => format!("{}.{}", from_zero? / 8, from_zero? % 8),
            Count::Sixteens => format!("{}.{:02}", from_zero? / 16, from_zero? % 16),
            Count::Channel(word) => format!("{word}.{:02}", from_zero.filter(|bit| *bit < 16)?),
            Count::Octal => format!("{:o}", from_zero?),
            Count::Pairs => number.checked_mul(2)?.to_string(),
            Count::Flags => {
                let flag = FLAGS.iter().find(|flag| flag.1 == number)?;
                format!("0.{}", flag.0)
            }
            Count::All => "0".to_owned(),
        })
    }
}
