//! What a text says where it writes a point.

use crate::{Address, Count, Kind, Maker};

/// The letters of addresses, which may stand apart from their numbers: `I 0.0`.
pub const LETTERS: [&str; 26] = [
    "I", "IX", "Q", "QX", "M", "MX", "X", "Y", "W", "S", "SM", "IW", "AIW", "QW", "D", "MW", "MD",
    "VW", "MB", "IB", "QB", "T", "TM", "TIM", "C", "CNT",
];

/// A point as it is written.
#[derive(Clone, Copy, Debug)]
pub struct Written<'t> {
    /// What kind of point the letters name.
    pub kind: Kind,
    /// Its number; none where it is written as none can be: bit 8 of a byte, the digit 8 of an octal number.
    pub number: Option<u16>,
    /// Which point; none where no board can have it.
    pub address: Option<Address>,
    /// How the text counts here.
    pub count: Count,
    /// What stands before the number: `%IX`.
    pub before: &'t str,
    /// The part of a timer or counter that is meant: the `Q` of `T1.Q`.
    pub member: Option<&'t str>,
    letters: &'t str,
    digits: &'t str,
    bit: Option<&'t str>,
}

/// How a point is written, without what changes nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spelling {
    letters: String,
    word: u32,
    bit: Option<u32>,
}

impl Written<'_> {
    /// Byte and bit, or word and bit, where it is written so.
    pub fn byte_and_bit(&self) -> Option<(u16, u16)> {
        Some((self.digits.parse().ok()?, self.bit?.parse().ok()?))
    }

    /// The point of this kind and number in the way in which this one is written.
    pub fn like(&self, number: u16) -> Option<String> {
        let number = self.count.written(number)?;
        Some(format!("{}{number}", self.before))
    }

    /// What tells this way of writing from others: two texts with different ones count the point differently. `I1`,
    /// `I.1`, `% IX01` are one.
    pub fn spelling(&self) -> Spelling {
        let letters = match self.letters {
            "IX" | "QX" | "MX" => &self.letters[..1],
            letters => letters,
        };
        let number = |digits: &str| digits.parse().unwrap_or(u32::MAX);
        Spelling {
            letters: letters.to_owned(),
            word: number(self.digits),
            bit: self.bit.map(number),
        }
    }

    /// The name of the timer or counter, without `%` and points: `T1`, `TM1`, `C1`.
    pub fn name(&self) -> String {
        let letters = match self.letters {
            "TIM" => "T",
            "CNT" => "C",
            letters => letters,
        };
        let number = self.digits.trim_start_matches('0');
        let number = if number.is_empty() { "0" } else { number };
        format!("{letters}{number}")
    }
}

/// The point that a name spells, in capitals and without blanks; none where it spells none.
pub fn read(name: &str, maker: Maker) -> Option<Written<'_>> {
    let text = name.strip_prefix('%').unwrap_or(name);
    let is_letter = |c: char| c.is_ascii_uppercase();
    let (letters, rest) = text.split_at(text.find(|c| !is_letter(c)).unwrap_or(text.len()));
    let rest = rest.strip_prefix('.').unwrap_or(rest);
    let is_digit = |c: char| c.is_ascii_digit();
    let (digits, behind) = rest.split_at(rest.find(|c| !is_digit(c)).unwrap_or(rest.len()));
    let part = match behind {
        "" => None,
        behind => Some(behind.strip_prefix('.')?),
    };
    // SimuPLC writes points without it.
    let foreign = maker == Maker::Simuplc && name.starts_with('%');
    if digits.is_empty() || foreign {
        return None;
    }
    let before = &name[..name.len() - rest.len()];
    let block = match letters {
        _ if maker == Maker::Simuplc => None,
        "T" | "TM" | "TIM" => Some(Kind::Timer),
        "C" | "CNT" => Some(Kind::Counter),
        _ => None,
    };
    if let Some(kind) = block {
        let number = digits.parse().ok();
        return Some(Written {
            kind,
            number,
            address: address(kind, number),
            count: Count::Numbered,
            before,
            member: part,
            letters,
            digits,
            bit: None,
        });
    }
    if part.is_some_and(|bit| bit.is_empty() || !bit.chars().all(is_digit)) {
        return None;
    }
    let word = digits.parse().unwrap_or(u32::MAX);
    let (kind, count) = Count::of(letters, word, part.is_some(), maker)?;
    let number = count.number(digits, part);
    let kind = match (count, number) {
        (Count::Flags, Some(0)) => Kind::Always,
        _ => kind,
    };
    Some(Written {
        kind,
        number,
        address: address(kind, number),
        count,
        before,
        member: None,
        letters,
        digits,
        bit: part,
    })
}

fn address(kind: Kind, number: Option<u16>) -> Option<Address> {
    let number = u8::try_from(number?).ok()?;
    Some(Address::new(kind, number))
}

/// Whether a name is that of a timer or counter as a whole: `T0`, `C1`.
pub fn is_block(name: &str) -> bool {
    let number = name
        .trim_start_matches('%')
        .strip_prefix(['T', 'C', 't', 'c']);
    number.is_some_and(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn at(kind: Kind, number: u8) -> Option<Address> {
        Some(Address::new(kind, number))
    }

    #[test]
    fn each_notation_names_its_points() {
        use Kind::{Always, Analogue, Input, Marker, Output, Register, System};
        for (name, expected) in [
            ("I1", at(Input, 1)),
            ("I.1", at(Input, 1)),
            ("%IX1", at(Input, 1)),
            ("%I0.0", at(Input, 1)),
            ("%IX0.7", at(Input, 8)),
            ("%IX1.0", at(Input, 9)),
            ("I1.2", at(Input, 11)),
            ("%I0.8", None),
            ("%IX9.7", at(Input, 80)),
            ("%Q0.3", at(Output, 4)),
            ("%QX1.0", at(Output, 9)),
            ("M.3", at(Marker, 3)),
            ("M1.0", at(Marker, 9)),
            ("M99", at(Marker, 99)),
            ("IW4", at(Analogue, 4)),
            ("%AIW4", at(Analogue, 2)),
            ("VW5", at(Register, 5)),
            ("SM0.0", at(Always, 0)),
            ("SM0.5", at(System, 2)),
            ("SM0.2", None),
            ("M300", None),
            ("I99999999999", None),
            ("M8191.7", None),
        ] {
            let written = read(name, Maker::Iec).unwrap_or_else(|| panic!("{name}"));
            assert_eq!(written.address, expected, "{name}");
        }
        for (maker, name, expected) in [
            (Maker::Twido, "%M0", at(Marker, 1)),
            (Maker::Twido, "%I1.0", at(Input, 9)),
            (Maker::Mitsubishi, "X10", at(Input, 9)),
            (Maker::Mitsubishi, "X8", None),
            (Maker::Mitsubishi, "Y0", at(Output, 1)),
            (Maker::Omron, "0.03", at(Input, 4)),
            (Maker::Omron, "100.01", at(Output, 2)),
            (Maker::Omron, "W1.00", at(Marker, 17)),
            (Maker::Simuplc, "AIW4", at(Analogue, 4)),
        ] {
            let written = read(name, maker).unwrap_or_else(|| panic!("{name}"));
            assert_eq!(written.address, expected, "{name}");
        }
        for name in ["I1", "%I0.0", "MX0.0", "T1", "AIW0.1"] {
            assert!(read(name, Maker::Simuplc).is_none(), "{name}");
        }
        for name in ["A1", "START", "I", "I1X", "IW0.1", "I0.", "%", "I1.2.3", ""] {
            assert!(read(name, Maker::Iec).is_none(), "{name}");
        }
    }

    #[test]
    fn what_is_written_is_read_again() {
        let all = [
            (Maker::Iec, "%IX1"),
            (Maker::Iec, "I0.0"),
            (Maker::Iec, "AIW0"),
            (Maker::Twido, "%MW0"),
            (Maker::Mitsubishi, "Y0"),
            (Maker::Omron, "100.00"),
            (Maker::Omron, "W0.00"),
        ];
        for (maker, name) in all {
            let written = read(name, maker).unwrap();
            for number in 1..=16 {
                let other = written.like(number.into()).unwrap();
                let again = read(&other, maker).and_then(|again| again.address);
                assert_eq!(again, at(written.kind, number), "{other}");
            }
        }
    }

    #[test]
    fn one_way_of_writing_has_one_spelling() {
        let spelling = |name| read(name, Maker::Iec).map(|written| written.spelling());
        for (one, other, same) in [
            ("I1", "%IX01", true),
            ("I.1", "I1", true),
            ("I1", "I0.0", false),
            ("D5", "MW5", false),
            ("AIW2", "AIW3", false),
            ("M1.0", "%MX1.0", true),
        ] {
            assert_eq!(spelling(one) == spelling(other), same, "{one} {other}");
        }
    }

    #[test]
    fn timers_and_counters_have_names_and_parts() {
        let of = |name| {
            let written = read(name, Maker::Iec).unwrap();
            (written.kind, written.name(), written.member)
        };
        assert_eq!(of("T1.Q"), (Kind::Timer, "T1".into(), Some("Q")));
        assert_eq!(of("%TM01"), (Kind::Timer, "TM1".into(), None));
        assert_eq!(of("TIM000"), (Kind::Timer, "T0".into(), None));
        assert_eq!(of("CNT2.CV"), (Kind::Counter, "C2".into(), Some("CV")));
        assert!(is_block("%T0") && is_block("c12") && !is_block("T") && !is_block("T1X"));
    }
}
