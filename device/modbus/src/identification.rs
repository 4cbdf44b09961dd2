//! Function 43/14, Read Device Identification (section 6.21).

use crate::frame::{Frame, demand};
use crate::{Device, Exception};

/// The function code, and the MEI type.
pub(crate) const FUNCTION: u8 = 43;
pub(crate) const READ_DEVICE_IDENTIFICATION: u8 = 14;

/// Basic identification, as a stream and object by object.
const CONFORMITY: u8 = 0x81;

/// Vendor's name, product code, version.
const OBJECTS: u8 = 3;

/// The longest text: with three of them the reply still fits one frame, so no more ever follows.
const TEXT_BYTES: u8 = 80;

/// Where the objects begin in the reply.
pub(crate) const FIRST_OBJECT: u8 = 8;

/// Sends one object or, as a stream, all from that one on.
///
/// Codes 2 and 3, regular and extended, are answered with the basic objects, in accordance with the
/// server's conformity level; a stream from an object that does not exist starts at the first. The
/// code is judged before the object, since it says what the object means.
pub(crate) fn answer<D: Device>(
    frame: &mut Frame,
    length: u8,
    device: &D,
) -> Result<u8, Exception> {
    let [_, _, mei, code, object, ..] = *frame;
    demand(length > 2)?;
    if mei != READ_DEVICE_IDENTIFICATION {
        return Err(Exception::IllegalFunction);
    }
    demand(length == 5 && code.wrapping_sub(1) < 4)?;
    let exists = object < OBJECTS;
    let one = code == 4;
    if one && !exists {
        return Err(Exception::IllegalDataAddress);
    }
    let first = if exists { object } else { 0 };
    let end = if one { first.wrapping_add(1) } else { OBJECTS };

    frame[4] = CONFORMITY;
    frame[5] = 0; // No more follows,
    frame[6] = 0; // so there is no next object.
    frame[7] = end.wrapping_sub(first);
    let mut at = FIRST_OBJECT;
    for object in first..end {
        let header = at;
        at = at.wrapping_add(2);
        let mut bytes = 0;
        while bytes < TEXT_BYTES
            && let Some(byte) = device.identification(object, bytes)
        {
            frame[usize::from(at)] = byte;
            at = at.wrapping_add(1);
            bytes = bytes.wrapping_add(1);
        }
        frame[usize::from(header)] = object;
        frame[usize::from(header.wrapping_add(1))] = bytes;
    }
    Ok(at)
}
