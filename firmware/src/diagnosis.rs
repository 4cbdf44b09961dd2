//! Self-diagnosis in every scan, at a bounded cost: the jobs take turns, one slice a scan.
//!
//! Owns what is looked at and how often; must not know what a fault leads to.

use crate::board::Board;
use crate::board::clock::Stamp;
use crate::board::watchdog;
use unoclp_core::{Cause, Crc16};

/// Bytes of the program that one slice checks.
const SLICE: usize = 8;

/// How long scans take, µs; 65,535 stands for anything longer.
#[derive(Clone, Copy, Default)]
pub struct ScanTimes {
    /// The last scan.
    pub last: u16,
    /// The shortest since scanning began.
    pub least: u16,
    /// The longest since scanning began.
    pub most: u16,
}

/// What the diagnosis keeps from scan to scan.
pub struct Diagnosis {
    times: ScanTimes,
    /// The check sum of the program as it was taken into run memory.
    expected: Crc16,
    /// The check sum so far, and the bytes that it is of.
    sum: Crc16,
    at: usize,
    turn: u8,
}

impl Diagnosis {
    /// Of a program that has just been taken into run memory.
    pub fn new(program: &[u8]) -> Diagnosis {
        Diagnosis {
            times: ScanTimes::default(),
            expected: Crc16::of(program),
            sum: Crc16::default(),
            at: 0,
            turn: 0,
        }
    }

    /// How long scans have taken; zeros before the first has ended.
    pub fn times(&self) -> ScanTimes {
        self.times
    }

    /// Notes how long a scan took.
    pub fn scanned(&mut self, from: Stamp, to: Stamp) {
        let time = to.micros_since(from);
        self.times = ScanTimes {
            last: time,
            least: match self.times.least {
                0 => time,
                least => least.min(time),
            },
            most: self.times.most.max(time),
        };
    }

    /// One slice of one job.
    ///
    /// # Errors
    /// The anomaly that it found.
    pub fn slice(&mut self, board: &Board, program: &[u8]) -> Result<(), Cause> {
        self.turn = if self.turn == 2 { 0 } else { self.turn + 1 };
        match self.turn {
            0 => self.check_program(program),
            1 if !watchdog::guard_is_whole() => Err(Cause::StackOverflow),
            2 if board.supply.is_low() => Err(Cause::SupplyLow),
            _ => Ok(()),
        }
    }

    fn check_program(&mut self, program: &[u8]) -> Result<(), Cause> {
        let rest = program.get(self.at..).unwrap_or_default();
        for &byte in rest.iter().take(SLICE) {
            self.sum.push(byte);
        }
        self.at += SLICE;
        if rest.len() > SLICE {
            return Ok(());
        }
        self.at = 0;
        if core::mem::take(&mut self.sum) == self.expected {
            Ok(())
        } else {
            Err(Cause::ProgramDamaged)
        }
    }
}
