//! What stands where in a frame, and a refusal in its place.

use crate::Exception;

/// The longest frame of Modbus RTU: address, 253 bytes, CRC.
pub const FRAME_BYTES: usize = 256;

/// Where a frame stands without its CRC: byte 0 the address, byte 1 the function code. Whatever is after
/// the request may be anything.
///
/// It holds the request first, and then, in its place, the reply.
pub type Frame = [u8; FRAME_BYTES];

/// The length of most requests, and of the reply to a write: address, function code, two words.
pub(crate) const FIXED: u8 = 6;

/// The two bytes from `at` on, high byte first, as Modbus sends all words.
#[inline(never)]
pub(crate) fn word(frame: &Frame, at: u8) -> u16 {
    let high = frame[usize::from(at)];
    let low = frame[usize::from(at.wrapping_add(1))];
    u16::from(high) << 8 | u16::from(low)
}

/// How many words or bits a request is about, and where those that it writes stand in the frame.
pub(crate) fn operands(frame: &Frame) -> (u16, u8) {
    if matches!(frame[1], 5 | 6) {
        (1, 4)
    } else {
        (word(frame, 4), 7)
    }
}

/// Turns the request into an exception response (section 7) of the length that is returned: 0 for a broadcast, which
/// gets none.
#[inline(never)]
pub fn refuse(frame: &mut Frame, exception: Exception) -> u8 {
    frame[1] |= 0x80;
    frame[2] = exception as u8;
    if frame[0] == 0 { 0 } else { 3 }
}

/// A request that is not `sound` has a quantity, value or length that is not allowed.
pub(crate) fn demand(sound: bool) -> Result<(), Exception> {
    if sound {
        Ok(())
    } else {
        Err(Exception::IllegalDataValue)
    }
}
