//! The dialect of a text in Instruction List.

use std::fmt;

/// Whose mnemonics a text uses. All are read in any text; the dialect decides what the makers disagree
/// about: from which number points count, and what a timer's preset counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dialect {
    /// IEC 61131-3, and Festo.
    #[default]
    Iec,
    /// Mitsubishi: LDI, ANI, ORI, OUT; points from 0.
    Mitsubishi,
    /// OMRON: LD NOT, AND NOT, OUT.
    Omron,
    /// Siemens S7-200: A, AN, O, ON, =; networks; LD keeps the result before it on a stack.
    S7200,
    /// Schneider Twido: BLK … END_BLK; markers from 0.
    Twido,
}

impl Dialect {
    /// Every dialect.
    pub const ALL: [Dialect; 5] = [
        Dialect::Iec,
        Dialect::Mitsubishi,
        Dialect::Omron,
        Dialect::S7200,
        Dialect::Twido,
    ];

    /// Its name on a command line: `iec`, `mitsubishi`, `omron`, `s7-200`, `twido`.
    pub const fn name(self) -> &'static str {
        match self {
            Dialect::Iec => "iec",
            Dialect::Mitsubishi => "mitsubishi",
            Dialect::Omron => "omron",
            Dialect::S7200 => "s7-200",
            Dialect::Twido => "twido",
        }
    }

    /// The dialect with this name.
    pub fn named(name: &str) -> Option<Dialect> {
        let mut all = Dialect::ALL.into_iter();
        all.find(|dialect| dialect.name().eq_ignore_ascii_case(name))
    }
}

impl fmt::Display for Dialect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// What the words of a text say about its dialect.
#[derive(Debug, Default)]
pub struct Signs {
    seen: [u32; 5],
    /// OUT, which Mitsubishi and OMRON share.
    out: bool,
    /// Whose a point can only be.
    point: Option<Dialect>,
}

impl Signs {
    /// A word that only this dialect has.
    pub fn see(&mut self, dialect: Dialect) {
        self.seen[dialect as usize] += 1;
    }

    /// Notes an OUT.
    pub fn see_out(&mut self) {
        self.out = true;
    }

    /// A point that only this dialect has; the first one counts.
    pub fn see_point(&mut self, dialect: Dialect) {
        self.point.get_or_insert(dialect);
    }

    /// The dialect of which most was seen; IEC where nothing was.
    pub fn dialect(&self) -> Dialect {
        let all = Dialect::ALL.into_iter();
        let most = all.rev().max_by_key(|&dialect| self.seen[dialect as usize]);
        match most {
            Some(dialect) if self.seen[dialect as usize] > 0 => dialect,
            _ if self.out => Dialect::Mitsubishi,
            _ => self.point.unwrap_or_default(),
        }
    }
}
