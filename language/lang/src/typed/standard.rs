//! The function blocks of the norm (2.5.2.3): what they have, and in which cells.

use super::base::Base;

/// A function block of the norm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Standard {
    /// Keeps a bit; setting wins.
    Sr,
    /// Keeps a bit; resetting wins.
    Rs,
    /// 1 in the call in which CLK rises.
    RTrig,
    /// 1 in the call in which CLK falls.
    FTrig,
    /// Counts up.
    Ctu,
    /// Counts down.
    Ctd,
    /// Counts both ways.
    Ctud,
    /// Counts up in a DINT.
    CtuDint,
    /// Counts down in a DINT.
    CtdDint,
    /// Counts both ways in a DINT.
    CtudDint,
    /// A pulse of PT.
    Tp,
    /// Q follows IN by PT, where it rises.
    Ton,
    /// Q follows IN by PT, where it falls.
    Tof,
}

/// What a member of a block is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The caller gives it.
    Input,
    /// The caller reads it.
    Output,
    /// The block's own.
    Hidden,
}

/// A cell of a block: its name, its type, and for whom it is.
pub type Part = (&'static str, Base, Role);

use Base::{Bool, Dint, Int, Time};
use Role::{Hidden, Input, Output};

const TIMER: &[Part] = &[
    ("IN", Bool, Input),
    ("PT", Time, Input),
    ("Q", Bool, Output),
    ("ET", Time, Output),
    // IN of the call before, and when the time began to run.
    ("#M", Bool, Hidden),
    ("#AT", Base::Lint, Hidden),
];

/// Counters of INT, and of DINT.
const UP: [[Part; 6]; 2] = [up(Int), up(Dint)];
const DOWN: [[Part; 6]; 2] = [down(Int), down(Dint)];
const BOTH: [[Part; 10]; 2] = [both(Int), both(Dint)];

const fn up(number: Base) -> [Part; 6] {
    [
        ("CU", Bool, Input),
        ("R", Bool, Input),
        ("PV", number, Input),
        ("Q", Bool, Output),
        ("CV", number, Output),
        ("#CU", Bool, Hidden),
    ]
}

const fn down(number: Base) -> [Part; 6] {
    [
        ("CD", Bool, Input),
        ("LD", Bool, Input),
        ("PV", number, Input),
        ("Q", Bool, Output),
        ("CV", number, Output),
        ("#CD", Bool, Hidden),
    ]
}

const fn both(number: Base) -> [Part; 10] {
    [
        ("CU", Bool, Input),
        ("CD", Bool, Input),
        ("R", Bool, Input),
        ("LD", Bool, Input),
        ("PV", number, Input),
        ("QU", Bool, Output),
        ("QD", Bool, Output),
        ("CV", number, Output),
        ("#CU", Bool, Hidden),
        ("#CD", Bool, Hidden),
    ]
}

const EDGE: &[Part] = &[
    ("CLK", Bool, Input),
    ("Q", Bool, Output),
    ("#M", Bool, Hidden),
];

impl Standard {
    /// All of them.
    pub const ALL: [Standard; 13] = [
        Standard::Sr,
        Standard::Rs,
        Standard::RTrig,
        Standard::FTrig,
        Standard::Ctu,
        Standard::Ctd,
        Standard::Ctud,
        Standard::CtuDint,
        Standard::CtdDint,
        Standard::CtudDint,
        Standard::Tp,
        Standard::Ton,
        Standard::Tof,
    ];

    /// As it is written.
    pub const fn name(self) -> &'static str {
        match self {
            Standard::Sr => "SR",
            Standard::Rs => "RS",
            Standard::RTrig => "R_TRIG",
            Standard::FTrig => "F_TRIG",
            Standard::Ctu => "CTU",
            Standard::Ctd => "CTD",
            Standard::Ctud => "CTUD",
            Standard::CtuDint => "CTU_DINT",
            Standard::CtdDint => "CTD_DINT",
            Standard::CtudDint => "CTUD_DINT",
            Standard::Tp => "TP",
            Standard::Ton => "TON",
            Standard::Tof => "TOF",
        }
    }

    /// The block of this name, in upper case.
    pub fn named(name: &str) -> Option<Standard> {
        Standard::ALL.into_iter().find(|block| block.name() == name)
    }

    /// Its cells, in order.
    pub const fn parts(self) -> &'static [Part] {
        match self {
            Standard::Sr => &[
                ("S1", Bool, Input),
                ("R", Bool, Input),
                ("Q1", Bool, Output),
            ],
            Standard::Rs => &[
                ("S", Bool, Input),
                ("R1", Bool, Input),
                ("Q1", Bool, Output),
            ],
            Standard::RTrig | Standard::FTrig => EDGE,
            Standard::Ctu => &UP[0],
            Standard::CtuDint => &UP[1],
            Standard::Ctd => &DOWN[0],
            Standard::CtdDint => &DOWN[1],
            Standard::Ctud => &BOTH[0],
            Standard::CtudDint => &BOTH[1],
            Standard::Tp | Standard::Ton | Standard::Tof => TIMER,
        }
    }

    /// How many cells an instance takes.
    pub const fn cells(self) -> u32 {
        self.parts().len() as u32
    }

    /// The block that has one of the norm's longer names, in upper case: `TON_TIME`, `CTU_INT`.
    pub fn overloaded(name: &str) -> Option<Standard> {
        let (plain, of) = name.rsplit_once('_')?;
        let block = Standard::named(plain)?;
        let same = match of {
            "TIME" => block.is_timer(),
            "INT" => block.counts(),
            _ => false,
        };
        same.then_some(block)
    }

    /// The norm's name of a member that others call otherwise: RESET is R.
    fn usual(self, name: &str) -> &str {
        match (self, name) {
            (Standard::Sr, "SET1" | "S") => "S1",
            (Standard::Sr, "RESET") | (Standard::Ctu | Standard::Ctud, "RESET") => "R",
            (Standard::Rs, "SET") => "S",
            (Standard::Rs, "RESET1" | "R") => "R1",
            (Standard::Ctd | Standard::Ctud, "LOAD") => "LD",
            _ => name,
        }
    }

    /// The cell of this member, in upper case, and what it is; none of what is hidden.
    pub fn part(self, name: &str) -> Option<(u32, Part)> {
        let name = self.usual(name);
        let parts = (0..).zip(self.parts());
        let mut named = parts.filter(|(_, part)| part.0 == name && part.2 != Hidden);
        named.next().map(|(at, part)| (at, *part))
    }

    /// Whether it is an edge.
    pub const fn is_edge(self) -> bool {
        matches!(self, Standard::RTrig | Standard::FTrig)
    }

    /// Whether an instance may be called at one place alone: the board's timers and counters look at their inputs there.
    pub const fn has_one_call(self) -> bool {
        !matches!(self, Standard::Sr | Standard::Rs) && !self.is_edge()
    }

    /// Whether it is a counter.
    pub const fn counts(self) -> bool {
        use Standard::{Ctd, CtdDint, Ctu, CtuDint, Ctud, CtudDint};
        matches!(self, Ctu | Ctd | Ctud | CtuDint | CtdDint | CtudDint)
    }

    /// Whether it is one of the board's timers.
    pub const fn is_timer(self) -> bool {
        matches!(self, Standard::Tp | Standard::Ton | Standard::Tof)
    }
}
