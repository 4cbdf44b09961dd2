//! What a board may refuse, whoever asks: bits of [`setting::LOCK`].

use crate::frame::{Frame, operands, word};
use crate::map::{Command, holding, setting};

/// Uploads.
pub const UPLOAD: u8 = 1 << 0;
/// Changes of the settings.
pub const SETTINGS: u8 = 1 << 1;
/// All commands but that of an upload.
pub const COMMANDS: u8 = 1 << 2;
/// Writing of coils, registers and presets, and forcing.
pub const WRITING: u8 = 1 << 3;
/// All of these.
pub const ALL: u8 = UPLOAD | SETTINGS | COMMANDS | WRITING;

const _: () = assert!(ALL as u16 == setting::LOCK.most);

/// The bit that a request falls under, which need not be a valid one; 0 for one that changes nothing.
fn of(frame: &Frame) -> u8 {
    let first = word(frame, 2);
    let (_, data) = operands(frame);
    match frame[1] {
        5 | 15 => WRITING,
        6 | 16 if first >= holding::UPLOAD.first => UPLOAD,
        6 | 16 if first >= holding::SETTINGS.first => SETTINGS,
        6 | 16 if first != holding::COMMAND.first => WRITING,
        6 | 16 if word(frame, data) == Command::Upload as u16 => UPLOAD,
        6 | 16 => COMMANDS,
        _ => 0,
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
