//! Self-diagnosis in every scan, at a bounded cost: the jobs take turns, one slice a scan.
//!
//! Owns what is looked at and how often; must not know what a fault leads to.

use crate::board::Board;
use crate::board::clock::Moment;
use crate::board::watchdog;
use core::{mem, slice};
use unoclp_core::{Cause, Crc16};

/// How long scans take, µs; 32,767 stands for anything longer.
#[derive(Clone, Copy, Default)]
pub struct ScanTimes {
    /// The last scan.
    pub last: u16,
    /// The shortest since scanning began.
    pub least: u16,
    /// The longest since scanning began.
    pub most: u16,
}

/// Whose turn a scan is.
pub enum Turn {
    /// The diagnosis has had it.
    Taken,
    /// That of what else goes on beside the scans.
    Free,
}

/// What the diagnosis keeps from scan to scan.
pub struct Diagnosis<'m> {
    /// Half µs.
    times: ScanTimes,
    turn: u8,
    /// The linked program, and what of it is still to be checked.
    program: &'m [u8],
    rest: slice::Iter<'m, u8>,
    /// The check sum so far, and what it was when the program was taken into run memory.
    sum: Crc16,
    expected: Crc16,
}

impl<'m> Diagnosis<'m> {
    /// Of a program that has just been taken into run memory.
    pub fn new(program: &'m [u8]) -> Diagnosis<'m> {
        Diagnosis {
            times: ScanTimes {
                last: 0,
                least: u16::MAX,
                most: 0,
            },
            turn: 0,
            program,
            rest: program.iter(),
            sum: Crc16::default(),
            expected: Crc16::of(program),
        }
    }

    /// How long scans have taken; zeros before the first has ended.
    #[inline(never)]
    pub fn times(&self) -> ScanTimes {
        ScanTimes {
            last: self.times.last / 2,
            least: self.times.least.min(self.times.most) / 2,
            most: self.times.most / 2,
        }
    }

    /// A scan has ended: it lasted from its beginning to that of the next.
    #[inline(always)]
    pub fn scanned(&mut self, begun: Moment, next: Moment) {
        match next.since_in_millisecond(begun) {
            Some(time) if time >= self.times.least && time <= self.times.most => {
                self.times.last = time;
            }
            _ => self.note(next.since(begun)),
        }
    }

    #[inline(never)]
    fn note(&mut self, time: Option<u16>) {
        if let Some(time) = time {
            self.times.last = time;
            self.times.least = self.times.least.min(time);
            self.times.most = self.times.most.max(time);
        }
    }

    /// One slice of one job, where it is the turn of one.
    ///
    /// # Errors
    /// The anomaly that it found.
    #[inline(always)]
    pub fn slice(&mut self, board: &Board) -> Result<Turn, Cause> {
        self.turn = self.turn.wrapping_add(1);
        match self.turn % 4 {
            0 => self.check_program(),
            1 if !watchdog::guard_is_whole() => Err(Cause::StackOverflow),
            2 if board.analogue.is_low() => Err(Cause::SupplyLow),
            1 | 2 => Ok(Turn::Taken),
            _ => Ok(Turn::Free),
        }
    }

    /// A byte of the program, or at its end the comparison.
    fn check_program(&mut self) -> Result<Turn, Cause> {
        if let Some(&byte) = self.rest.next() {
            self.sum.push(byte);
            return Ok(Turn::Taken);
        }
        self.rest = self.program.iter();
        if mem::take(&mut self.sum) == self.expected {
            Ok(Turn::Taken)
        } else {
            Err(Cause::ProgramDamaged)
        }
    }
}
