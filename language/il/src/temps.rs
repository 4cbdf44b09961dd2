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
            none_left: None,
        }
    }

    /// A marker for a name, the lowest that is free; of those that keep their state where `retained`.
    pub(crate) fn named_marker(&mut self, retained: bool) -> u8 {
        let mut markers = self.board.markers_that(retained);
        let used = self.markers;
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

    /// Whether a marker is free for a name; of those that keep their state where `retained`.
    pub(crate) fn has_marker(&self, retained: bool) -> bool {
        let used = self.markers;
        let mut markers = self.board.markers_that(retained);
        markers.any(|n| used >> (n - 1) & 1 == 0)
    }

    /// A register for a name, the lowest that is free.
    pub(crate) fn named_register(&mut self) -> u8 {
        let used = self.registers;
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
}
