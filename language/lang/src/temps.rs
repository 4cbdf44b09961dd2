//! Markers and registers that the program does not name.

use unoclp_core::Board;
use unoclp_core::isa::REGISTERS;

/// Which markers and registers are in use.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Temps {
    board: Board,
    /// Bit 0 is M 01.
    pub markers: u128,
    /// Bit 0 is D 01.
    pub registers: u128,
    /// Those that have ever held an intermediate result; no name may have one of them.
    temp_markers: u128,
    temp_registers: u128,
    busy_markers: u128,
    busy_registers: u128,
    /// Which kind has run out.
    pub none_left: Option<(&'static str, &'static str)>,
}

const MARKER_WORDS: (&str, &str) = ("marker", "memória");
const RETENTIVE_WORDS: (&str, &str) = ("retentive marker", "memória retentiva");
const REGISTER_WORDS: (&str, &str) = ("register", "registrador");

impl Temps {
    /// None in use.
    pub(crate) fn new(board: Board) -> Temps {
        Temps {
            board,
            markers: 0,
            registers: 0,
            temp_markers: 0,
            temp_registers: 0,
            busy_markers: 0,
            busy_registers: 0,
            none_left: None,
        }
    }

    /// A marker for a name, the lowest that is free; of those that keep their state where `retained`.
    pub(crate) fn named_marker(&mut self, retained: bool) -> u8 {
        let mut markers = self.board.markers_that(retained);
        let used = self.markers | self.temp_markers;
        let free = |&n: &u8| used >> (n - 1) & 1 == 0;
        match markers.find(free) {
            Some(n) => {
                self.markers |= 1 << (n - 1);
                n
            }
            None => {
                self.none_left = Some(if retained {
                    RETENTIVE_WORDS
                } else {
                    MARKER_WORDS
                });
                // What is told is told once: a marker of that kind goes on in its place.
                self.board.markers_that(retained).next().unwrap_or(1)
            }
        }
    }

    /// A register for a name, the lowest that is free.
    pub(crate) fn named_register(&mut self) -> u8 {
        let used = self.registers | self.temp_registers;
        let free = |&n: &u8| used >> (n - 1) & 1 == 0;
        match (1..=REGISTERS).find(free) {
            Some(n) => {
                self.registers |= 1 << (n - 1);
                n
            }
            None => {
                self.none_left = Some(REGISTER_WORDS);
                1
            }
        }
    }

    /// A marker for an intermediate result, the highest that is free.
    pub(crate) fn marker(&mut self) -> u8 {
        let used = self.markers | self.busy_markers;
        // One that has held such a result before has no name.
        match self
            .board
            .markers_that(false)
            .rev()
            .find(|n| used >> (n - 1) & 1 == 0)
        {
            Some(n) => {
                self.busy_markers |= 1 << (n - 1);
                self.temp_markers |= self.busy_markers;
                n
            }
            None => {
                self.none_left = Some(MARKER_WORDS);
                1
            }
        }
    }

    /// Likewise a register.
    pub(crate) fn register(&mut self) -> u8 {
        let used = self.registers | self.busy_registers;
        // Those beyond take run memory, the fewer the lower they are.
        let near = self.board.engine.near_registers;
        let mut all = (1..=near).rev().chain(near + 1..=REGISTERS);
        match all.find(|n| used >> (n - 1) & 1 == 0) {
            Some(n) => {
                self.busy_registers |= 1 << (n - 1);
                self.temp_registers |= self.busy_registers;
                n
            }
            None => {
                self.none_left = Some(REGISTER_WORDS);
                1
            }
        }
    }

    /// A marker that holds something for the whole program, the highest that is free.
    pub(crate) fn lasting_marker(&mut self) -> u8 {
        let marker = self.marker();
        self.markers |= 1 << (marker - 1);
        marker
    }

    /// Likewise a register.
    pub(crate) fn lasting_register(&mut self) -> u8 {
        let register = self.register();
        self.registers |= 1 << (register - 1);
        register
    }

    /// Whether this marker holds an intermediate result, which nothing else writes.
    pub(crate) fn is_busy(&self, marker: u8) -> bool {
        self.busy_markers >> marker.wrapping_sub(1) & 1 != 0
    }

    /// Likewise a register.
    pub(crate) fn is_busy_register(&self, register: u8) -> bool {
        self.busy_registers >> register.wrapping_sub(1) & 1 != 0
    }

    /// No intermediate result is needed any more.
    pub(crate) fn release(&mut self) {
        self.busy_markers = 0;
        self.busy_registers = 0;
    }
}
