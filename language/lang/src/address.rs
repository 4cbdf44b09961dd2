//! Addresses: `I1`, `%IX0.0`, `M.3`, `IW4`, `T1.Q`. What byte and bit mean is said here, once.
//!
//! | written | point |
//! | --- | --- |
//! | `I1` `I.1` `IX1` | the input with this number |
//! | `I0.0` … `I0.7` | inputs 01 … 08 |
//! | `I1.0` … `I1.3` | inputs 05 … 08 again: the board's second group of four |
//! | `Q0.0` … `Q0.3` | outputs 01 … 04 |
//! | `M1`, `M0.0` … `M7.7` | the marker with this number; markers 01 … 64 |
//! | `M0` of a Twido or Mitsubishi | marker 01: theirs count from 0 |
//! | `X0` `Y0` of Mitsubishi | input 01, output 01; octal |
//! | `0.00`, `10.00`, `100.00`, `W0.00` of OMRON | input 01, output 01, output 01, marker 01 |

use crate::Dialect;

/// What an address names; a number is yet to be checked.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Address {
    Input(u32),
    Output(u32),
    Marker(u32),
    System(u32),
    /// 1, as `SM0.0` always is.
    Always,
    Analogue(u32),
    Pwm(u32),
    Register(u32),
    /// Eight markers.
    Group(u32),
    Inputs,
    Outputs,
    /// A timer or counter, by its name without `%` and points, and the member that is meant.
    Timer(String, Option<String>),
    Counter(String, Option<String>),
}

/// The letters of addresses, which may stand apart from their numbers: `I 0.0`.
pub(crate) const LETTERS: [&str; 26] = [
    "I", "IX", "Q", "QX", "M", "MX", "X", "Y", "W", "S", "SM", "IW", "AIW", "QW", "D", "MW", "MD",
    "VW", "MB", "IB", "QB", "T", "TM", "TIM", "C", "CNT",
];

/// The address that a name spells; none where it spells none. The name is in upper case.
pub(crate) fn parse(name: &str, dialect: Dialect) -> Option<Address> {
    let text = name.strip_prefix('%').unwrap_or(name);
    let letters_end = text
        .find(|c: char| !c.is_ascii_uppercase())
        .unwrap_or(text.len());
    let (letters, rest) = text.split_at(letters_end);
    let rest = rest.strip_prefix('.').unwrap_or(rest);
    let digits_end = rest
        .find(|c: char| !c.is_ascii_digit())
        .unwrap_or(rest.len());
    let (digits, behind) = rest.split_at(digits_end);
    let first: u32 = digits.parse().ok()?;
    let member = match behind {
        "" => None,
        behind => Some(behind.strip_prefix('.')?),
    };
    let bit: Option<u32> = match member {
        Some(bit) if !matches!(letters, "T" | "TM" | "TIM" | "C" | "CNT") => {
            Some(bit.parse().ok()?)
        }
        _ => None,
    };
    let zero_based = u32::from(matches!(dialect, Dialect::Twido | Dialect::Mitsubishi));
    // A byte's bits, `per` points to a byte.
    let point = |per: u32, shift: u32| match bit {
        Some(bit) if bit > 7 => Some(u32::MAX),
        Some(bit) => Some(
            first
                .saturating_mul(per)
                .saturating_add(bit)
                .saturating_add(1),
        ),
        None => Some(first.saturating_add(shift)),
    };
    let word = |number: u32| bit.is_none().then_some(number);
    Some(match letters {
        "I" | "IX" => Address::Input(point(4, 0)?),
        "Q" | "QX" => Address::Output(point(4, 0)?),
        "M" | "MX" => Address::Marker(point(8, zero_based)?),
        "X" if dialect == Dialect::Mitsubishi => Address::Input(octal(digits, bit)?),
        "Y" if dialect == Dialect::Mitsubishi => Address::Output(octal(digits, bit)?),
        "W" if dialect == Dialect::Omron => Address::Marker(
            first
                .saturating_mul(16)
                .saturating_add(bit?)
                .saturating_add(1),
        ),
        "" if dialect == Dialect::Omron && first == 0 => Address::Input(bit?.saturating_add(1)),
        "" if dialect == Dialect::Omron && (first == 10 || first == 100) => {
            Address::Output(bit?.saturating_add(1))
        }
        "S" => Address::System(word(first)?),
        "SM" => match (first, bit) {
            (0, Some(0)) => Address::Always,
            (0, Some(1)) => Address::System(1),
            (0, Some(5)) => Address::System(2),
            _ => Address::System(u32::MAX),
        },
        "IW" => Address::Analogue(word(first)?),
        // Two bytes each.
        "AIW" => Address::Analogue(word(first / 2)?),
        "QW" => Address::Pwm(word(first)?),
        "D" | "MW" | "MD" | "VW" => Address::Register(word(first.saturating_add(zero_based))?),
        "MB" => Address::Group(word(first)?),
        "IB" => word(first).map(|_| Address::Inputs)?,
        "QB" => word(first).map(|_| Address::Outputs)?,
        "TIM" => Address::Timer(format!("T{first}"), member.map(str::to_owned)),
        "T" | "TM" => Address::Timer(format!("{letters}{first}"), member.map(str::to_owned)),
        "C" | "CNT" => Address::Counter(format!("C{first}"), member.map(str::to_owned)),
        _ => return None,
    })
}

/// Whether a name is that of a timer or counter as a whole: `T0`, `C1`.
pub(crate) fn is_block(name: &str) -> bool {
    let number = name
        .trim_start_matches('%')
        .strip_prefix(['T', 'C', 't', 'c']);
    number.is_some_and(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
}

/// How an address is written: its letters, its number, and its bit. `I1`, `I.1`, `% IX01` are one spelling.
pub(crate) type Spelling = (String, u32, Option<u32>);

/// The spelling of an address, in upper case.
pub(crate) fn spelling(name: &str) -> Spelling {
    let text = name.strip_prefix('%').unwrap_or(name);
    let letters = text.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.');
    let digits = text[letters.len()..].trim_start_matches('.');
    let (first, bit) = match digits.split_once('.') {
        Some((first, bit)) => (first, bit.parse().ok()),
        None => (digits, None),
    };
    let letters = match letters {
        "IX" | "QX" | "MX" => &letters[..1],
        letters => letters,
    };
    (letters.to_owned(), first.parse().unwrap_or(0), bit)
}

fn octal(digits: &str, bit: Option<u32>) -> Option<u32> {
    match bit {
        Some(_) => None,
        None => u32::from_str_radix(digits, 8)
            .ok()
            .map(|number| number.saturating_add(1)),
    }
}

impl Dialect {
    /// Whether a name is an address here, such as `%IX1` or `T1.Q`, and not a name of somebody's own.
    pub fn is_address(self, name: &str) -> bool {
        parse(&name.to_uppercase(), self).is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses() {
        let iec = [
            ("I1", Some(Address::Input(1))),
            ("I.1", Some(Address::Input(1))),
            ("%IX1", Some(Address::Input(1))),
            ("%I0.0", Some(Address::Input(1))),
            ("%I0.7", Some(Address::Input(8))),
            ("%I1.2", Some(Address::Input(7))),
            ("%I0.8", Some(Address::Input(u32::MAX))),
            ("%Q0.3", Some(Address::Output(4))),
            ("M.3", Some(Address::Marker(3))),
            ("M1.0", Some(Address::Marker(9))),
            ("IW4", Some(Address::Analogue(4))),
            ("%AIW4", Some(Address::Analogue(2))),
            ("T1.Q", Some(Address::Timer("T1".into(), Some("Q".into())))),
            ("%TM1", Some(Address::Timer("TM1".into(), None))),
            (
                "C2.D",
                Some(Address::Counter("C2".into(), Some("D".into()))),
            ),
            ("SM0.0", Some(Address::Always)),
            ("A1", None),
            ("START", None),
            ("I", None),
            ("I1X", None),
            ("99999999999", None),
            ("I99999999999", None),
            ("M4294967295.7", Some(Address::Marker(u32::MAX))),
        ];
        for (name, expected) in iec {
            assert_eq!(parse(name, Dialect::Iec), expected, "{name}");
        }
        assert_eq!(parse("%M0", Dialect::Twido), Some(Address::Marker(1)));
        assert_eq!(parse("X10", Dialect::Mitsubishi), Some(Address::Input(9)));
        assert_eq!(parse("Y0", Dialect::Mitsubishi), Some(Address::Output(1)));
        assert_eq!(parse("0.03", Dialect::Omron), Some(Address::Input(4)));
        assert_eq!(parse("100.01", Dialect::Omron), Some(Address::Output(2)));
    }
}
