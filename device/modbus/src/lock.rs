//! What a board refuses, whoever asks: [`locks`](crate::map::locks).

use crate::Table;
use crate::frame::{Frame, operands, word};
use crate::map::{self, Command, setting};

pub use map::locks::{ALL, COMMANDS, SETTINGS, UPLOAD, WRITING};

const _: () = assert!(ALL as u16 == setting::LOCK.most);

/// The bit that a request falls under, which need not be a valid one; 0 for one that changes nothing.
fn of(frame: &Frame) -> u8 {
    let first = word(frame, 2);
    let lock = match frame[1] {
        5 | 15 => map::lock(Table::Coils, first),
        6 | 16 => map::lock(Table::HoldingRegisters, first),
        _ => return 0,
    };
    let (_, data) = operands(frame);
    // Of the commands, one is an upload's.
    if lock == COMMANDS && word(frame, data) == Command::Upload as u16 {
        UPLOAD
    } else {
        lock
    }
}

/// Whether a board that has this lock refuses a request. Broadcasts never change settings and never upload.
pub fn refuses(frame: &Frame, lock: u8) -> bool {
    // Who sends a broadcast is not told what came of it.
    let lock = if frame[0] == 0 {
        lock | UPLOAD | SETTINGS
    } else {
        lock
    };
    of(frame) & lock != 0
}
