//! The line to the program: its level at any time.

use super::{Flaw, Line};
use std::collections::VecDeque;

/// The characters that the other end sends. Between them the line is high.
#[derive(Default)]
pub(crate) struct Wire {
    line: Line,
    characters: VecDeque<Character>,
}

struct Character {
    start: u64,
    line: Line,
    /// Start bit first, in the lowest bit.
    bits: u16,
    count: u64,
}

impl Character {
    fn new(start: u64, byte: u8, flaw: Option<Flaw>, line: Line) -> Character {
        let mut bits = u16::from(byte) << 1;
        let mut count = 9;
        if let Some(parity) = line.parity.bit(byte) {
            bits |= u16::from(parity) << count;
            count += 1;
        }
        let stop = 1 << count;
        bits |= stop;
        bits ^= match flaw {
            None => 0,
            Some(Flaw::Framing) => stop,
            Some(Flaw::Parity) => stop >> 1,
        };
        Character {
            start,
            line,
            bits,
            count: count + 1,
        }
    }

    /// When bit `n` begins.
    fn begin(&self, n: u64) -> u64 {
        self.start + self.line.bits(n)
    }

    fn end(&self) -> u64 {
        self.begin(self.count)
    }

    fn bit(&self, n: u64) -> bool {
        self.bits >> n & 1 == 1
    }
}

impl Wire {
    /// How the other end sends from now on.
    pub fn set_line(&mut self, line: Line) {
        self.line = line;
    }

    pub fn line(&self) -> Line {
        self.line
    }

    /// Puts a character on the line at `at`, or as soon as those before it are over. The end of its stop bit.
    pub fn send(&mut self, byte: u8, flaw: Option<Flaw>, at: u64) -> u64 {
        let start = at.max(self.end());
        let character = Character::new(start, byte, flaw, self.line);
        let end = character.end();
        self.characters.push_back(character);
        end
    }

    /// When the last character is over; 0 where there is none.
    pub fn end(&self) -> u64 {
        self.characters.back().map_or(0, Character::end)
    }

    /// Whether the line is high.
    pub fn level(&self, cycle: u64) -> bool {
        let character = self.characters.iter().find(|one| cycle < one.end());
        let Some(character) = character.filter(|one| one.start <= cycle) else {
            return true;
        };
        let begun = |n: &u64| character.begin(*n) <= cycle;
        let bit = (0..character.count).rev().find(begun);
        bit.is_none_or(|n| character.bit(n))
    }

    /// When the line goes low for the first time at or after `from`.
    pub fn falling_edge(&self, from: u64) -> Option<u64> {
        let mut before = true;
        let mut end = 0;
        for character in &self.characters {
            before |= character.start > end;
            for n in 0..character.count {
                let level = character.bit(n);
                if before && !level && character.begin(n) >= from {
                    return Some(character.begin(n));
                }
                before = level;
            }
            end = character.end();
        }
        None
    }

    /// Forgets the characters that are over at this time.
    pub fn forget(&mut self, before: u64) {
        while self
            .characters
            .front()
            .is_some_and(|one| one.end() < before)
        {
            self.characters.pop_front();
        }
    }
}
