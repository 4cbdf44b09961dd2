//! A board in memory that answers requests: the server's protocol is that of the firmware.
#![allow(dead_code, reason = "each test uses its part")]

mod device;

pub use device::{Board, FAULT, RUN, STOP, kept};

use unoclp_modbus::map::holding;
use unoclp_modbus::{Crc, Exception, Exchange, FRAME_BYTES, lock, refuse};

/// What becomes of a request, on its way to the board or there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It is answered.
    Answered,
    /// It is lost on its way.
    Lost,
    /// It is done, but the answer is lost.
    AnswerLost,
    /// It is done, and answered seconds later.
    Slow,
    /// It is done, but something else comes back.
    Garbled,
    /// Another function is answered.
    Mistaken,
    /// The port goes, and does not come back.
    Unplugged,
}

/// Says what becomes of a request, given without its checksum.
pub type Trick = Box<dyn FnMut(&mut Board, &[u8]) -> Fate + Send>;

/// What the board and the line make of a request with its checksum: its fate, and what comes back.
pub fn answer(board: &mut Board, trick: &mut Trick, request: &[u8]) -> (Fate, Vec<u8>) {
    assert_eq!(Crc::of(request).value(), 0, "{request:02x?}");
    let request = &request[..request.len() - 2];
    let fate = trick(board, request);
    // The address in use is that of the last start, which is 1 here as long as nobody asks for another.
    let ours = request[0] == board.settings[0] as u8 || request[0] == 1;
    if matches!(fate, Fate::Lost | Fate::Unplugged) || !ours {
        return (fate, Vec::new());
    }
    let mut reply = handle(board, request);
    match fate {
        Fate::AnswerLost => reply.clear(),
        Fate::Garbled => *reply.last_mut().unwrap() ^= 1,
        Fate::Mistaken => {
            reply.truncate(reply.len() - 2);
            reply[1] ^= 7;
            reply.extend(Crc::of(&reply).to_bytes());
        }
        _ => {}
    }
    (fate, reply)
}

/// Whether a request without its checksum is a block of an upload.
pub fn is_block(request: &[u8]) -> bool {
    request[1] == 16 && request[2..4] == holding::UPLOAD.first.to_be_bytes()
}

/// The board's answer, with its checksum.
fn handle(board: &mut Board, request: &[u8]) -> Vec<u8> {
    let mut frame = [0; FRAME_BYTES];
    frame[..request.len()].copy_from_slice(request);
    let length = if request[1] == 43 && !board.identifies {
        (frame[1], frame[2]) = (0xAB, 1);
        3
    } else if lock::refuses(&frame, board.settings[4] as u8) {
        refuse(&mut frame, Exception::IllegalFunction)
    } else {
        let mut exchange = Exchange::default();
        let mut length = exchange.begin(&mut frame, request.len() as u8, board);
        while length.is_none() {
            length = exchange.fill(&mut frame, board);
        }
        length.unwrap_or_default()
    };
    let mut reply = frame[..length.into()].to_vec();
    reply.extend(Crc::of(&reply).to_bytes());
    reply
}

/// How long a request that begins so is: there is no silence on a pseudo-terminal.
pub fn request_length(came: &[u8]) -> Option<usize> {
    Some(match *came.get(1)? {
        15 | 16 => 9 + usize::from(*came.get(6)?),
        43 => 7,
        _ => 8,
    })
}
