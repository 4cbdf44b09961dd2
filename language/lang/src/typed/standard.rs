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

use Base::{Bool, Int, Time};
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

const EDGE: &[Part] = &[
    ("CLK", Bool, Input),
    ("Q", Bool, Output),
    ("#M", Bool, Hidden),
];

impl Standard {
    /// All of them.
    pub const ALL: [Standard; 10] = [
        Standard::Sr,
        Standard::Rs,
        Standard::RTrig,
        Standard::FTrig,
        Standard::Ctu,
        Standard::Ctd,
        Standard::Ctud,
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
            Standard::Ctu => &[
                ("CU", Bool, Input),
                ("R", Bool, Input),
                ("PV", Int, Input),
                ("Q", Bool, Output),
                ("CV", Int, Output),
                ("#CU", Bool, Hidden),
            ],
            Standard::Ctd => &[
                ("CD", Bool, Input),
                ("LD", Bool, Input),
                ("PV", Int, Input),
                ("Q", Bool, Output),
                ("CV", Int, Output),
                ("#CD", Bool, Hidden),
            ],
            Standard::Ctud => &[
                ("CU", Bool, Input),
                ("CD", Bool, Input),
                ("R", Bool, Input),
                ("LD", Bool, Input),
                ("PV", Int, Input),
                ("QU", Bool, Output),
                ("QD", Bool, Output),
                ("CV", Int, Output),
                ("#CU", Bool, Hidden),
                ("#CD", Bool, Hidden),
            ],
            Standard::Tp | Standard::Ton | Standard::Tof => TIMER,
        }
    }

    /// How many cells an instance takes.
    pub const fn cells(self) -> u32 {
        self.parts().len() as u32
    }

    /// The cell of this member, in upper case, and what it is; none of what is hidden.
    pub fn part(self, name: &str) -> Option<(u32, Part)> {
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

    /// Whether it is one of the board's timers.
    pub const fn is_timer(self) -> bool {
        matches!(self, Standard::Tp | Standard::Ton | Standard::Tof)
    }
}
