//! The function blocks of the standard (2.5.2.3) and the board's own: what they have, and in which cells.

use super::base::Base;

/// A function block of the standard, or of the board.
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
    /// Counts up in a UDINT.
    CtuUdint,
    /// Counts down in a UDINT.
    CtdUdint,
    /// Counts both ways in a UDINT.
    CtudUdint,
    /// A pulse of PT.
    Tp,
    /// Q follows IN by PT, where it rises.
    Ton,
    /// Q follows IN by PT, where it falls.
    Tof,
    /// Q follows the time for which IN has been 1 in all; a reset alone ends it (NC-14).
    Tonr,
    /// A counter of the board (NC-15): 32 bits wide, counts both ways, and what of it a call does not give is not done.
    /// QU and QD are what the number and the preset say at each moment.
    Counter,
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

use Base::{Bool, Dint, Int, Time, Udint};
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

/// Where each part of a counter that counts both ways stands.
pub mod counter {
    /// PV.
    pub const PRESET: u32 = 4;
    /// QU.
    pub const UP: u32 = 5;
    /// QD.
    pub const DOWN: u32 = 6;
    /// CV.
    pub const NUMBER: u32 = 7;
}

/// Counters of INT, of DINT, and of UDINT.
const UP: [[Part; 6]; 3] = [up(Int), up(Dint), up(Udint)];
const DOWN: [[Part; 6]; 3] = [down(Int), down(Dint), down(Udint)];
const BOTH: [[Part; 10]; 3] = [both(Int), both(Dint), both(Udint)];

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
    /// Those of the standard, which texts declare by these names.
    pub const ALL: [Standard; 16] = [
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
        Standard::CtuUdint,
        Standard::CtdUdint,
        Standard::CtudUdint,
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
            Standard::CtuUdint => "CTU_UDINT",
            Standard::CtdUdint => "CTD_UDINT",
            Standard::CtudUdint => "CTUD_UDINT",
            Standard::Tp => "TP",
            Standard::Ton => "TON",
            Standard::Tof => "TOF",
            Standard::Tonr => "TONR",
            Standard::Counter => "COUNTER",
        }
    }

    /// The block of the standard that has this name, in upper case.
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
            Standard::CtuUdint => &UP[2],
            Standard::Ctd => &DOWN[0],
            Standard::CtdDint => &DOWN[1],
            Standard::CtdUdint => &DOWN[2],
            Standard::Ctud => &BOTH[0],
            Standard::CtudDint => &BOTH[1],
            Standard::CtudUdint => &BOTH[2],
            Standard::Tp | Standard::Ton | Standard::Tof | Standard::Tonr => TIMER,
            Standard::Counter => &BOTH[1],
        }
    }

    /// How many cells an instance takes.
    pub const fn cells(self) -> u32 {
        self.parts().len() as u32
    }

    /// The block that has one of the standard's longer names, in upper case: `TON_TIME`, `CTU_INT`. Those that count in 64 bits
    /// count in 32.
    pub fn overloaded(name: &str) -> Option<Standard> {
        let (plain, of) = name.rsplit_once('_')?;
        let block = Standard::named(plain)?;
        match (block, of) {
            (Standard::Tp | Standard::Ton | Standard::Tof, "TIME") => Some(block),
            (Standard::Ctu | Standard::Ctd | Standard::Ctud, "INT") => Some(block),
            (Standard::Ctu | Standard::Ctd | Standard::Ctud, "LINT") => {
                Standard::named(&format!("{plain}_DINT"))
            }
            (Standard::Ctu | Standard::Ctd | Standard::Ctud, "ULINT") => {
                Standard::named(&format!("{plain}_UDINT"))
            }
            _ => None,
        }
    }

    /// The standard's name of a member that others call otherwise: RESET is R.
    fn usual(self, name: &str) -> &str {
        match (self.plain(), name) {
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

    /// The input that sets or resets a latch; none of another block.
    pub const fn latch_input(self, set: bool) -> Option<&'static str> {
        match (self, set) {
            (Standard::Sr, true) => Some("S1"),
            (Standard::Sr, false) => Some("R"),
            (Standard::Rs, true) => Some("S"),
            (Standard::Rs, false) => Some("R1"),
            _ => None,
        }
    }

    /// Whether it is one of the board's timers.
    pub const fn is_timer(self) -> bool {
        matches!(
            self,
            Standard::Tp | Standard::Ton | Standard::Tof | Standard::Tonr
        )
    }

    /// The counter of INT that counts as this one does; any other block is itself.
    pub const fn plain(self) -> Standard {
        match self {
            Standard::CtuDint | Standard::CtuUdint => Standard::Ctu,
            Standard::CtdDint | Standard::CtdUdint => Standard::Ctd,
            Standard::CtudDint | Standard::CtudUdint => Standard::Ctud,
            other => other,
        }
    }

    /// Whether it is one of the board's counters.
    pub const fn is_counter(self) -> bool {
        matches!(
            self.plain(),
            Standard::Ctu | Standard::Ctd | Standard::Ctud | Standard::Counter
        )
    }

    /// The cell of its preset; none of what has none.
    pub const fn preset(self) -> Option<u32> {
        match self.plain() {
            Standard::Tp | Standard::Ton | Standard::Tof | Standard::Tonr => Some(1),
            Standard::Ctu | Standard::Ctd => Some(2),
            Standard::Ctud | Standard::Counter => Some(counter::PRESET),
            _ => None,
        }
    }

    /// The cell of a counter's number.
    pub const fn number(self) -> Option<u32> {
        match self.plain() {
            Standard::Ctu | Standard::Ctd => Some(4),
            Standard::Ctud | Standard::Counter => Some(counter::NUMBER),
            _ => None,
        }
    }

    /// The cells that say whether a counter has reached its preset, and whether it is 0 or less.
    pub const fn reached(self) -> [Option<u32>; 2] {
        match self.plain() {
            Standard::Ctu => [Some(3), None],
            Standard::Ctd => [None, Some(3)],
            Standard::Ctud | Standard::Counter => [Some(counter::UP), Some(counter::DOWN)],
            _ => [None, None],
        }
    }
}
