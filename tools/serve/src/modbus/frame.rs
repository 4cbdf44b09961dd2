//! Frames of Modbus TCP (*MODBUS Messaging on TCP/IP*, section 3.1.3), and the same as a board takes them.
//!
//! Owns heads, lengths and checksums. Must not know what a request asks.

use unoclp_modbus::client::Request;
use unoclp_modbus::{Crc, Exception};

/// Bytes of a head: transaction, protocol, length, unit.
pub(crate) const HEAD: usize = 7;

/// The head of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Head {
    /// By this the client knows the answer.
    transaction: [u8; 2],
    /// Whom it asks.
    pub unit: u8,
    /// Bytes of the request after it: at least its function.
    pub length: usize,
}

impl Head {
    /// The head of these bytes; none of what is no frame of Modbus, or says that it has no function or more than 253 bytes.
    pub fn of(bytes: [u8; HEAD]) -> Option<Head> {
        let [a, b, 0, 0, high, low, unit] = bytes else {
            return None;
        };
        // The unit is counted too.
        let length = usize::from(u16::from_be_bytes([high, low])).checked_sub(1)?;
        (1..=253).contains(&length).then_some(Head {
            transaction: [a, b],
            unit,
            length,
        })
    }

    /// That of a request to this unit.
    pub fn new(transaction: u16, unit: u8) -> Head {
        Head {
            transaction: transaction.to_be_bytes(),
            unit,
            length: 0,
        }
    }

    /// Whether it is that of an answer to this one.
    pub fn answers(self, asked: Head) -> bool {
        (self.transaction, self.unit) == (asked.transaction, asked.unit)
    }

    /// The frame of an answer to it, or of what is after it.
    pub fn frame(self, answer: &[u8]) -> Vec<u8> {
        let [a, b] = self.transaction;
        // An answer has at most 253 bytes.
        let [high, low] = (answer.len() as u16 + 1).to_be_bytes();
        let mut frame = vec![a, b, 0, 0, high, low, self.unit];
        frame.extend(answer);
        frame
    }
}

/// A request as the board at this address takes it; none where it is too long for one.
pub(crate) fn to_board(address: u8, request: &[u8]) -> Option<Request> {
    Request::forwarded(&of_board(address, request))
}

/// A board's answer, or a request to one, without address and checksum.
pub(crate) fn from_board(reply: &[u8]) -> Vec<u8> {
    let body = reply.len().checked_sub(2).and_then(|end| reply.get(1..end));
    body.unwrap_or_default().to_vec()
}

/// An answer of the board at this address, or a request to it, with address and checksum.
pub(crate) fn of_board(address: u8, answer: &[u8]) -> Vec<u8> {
    let mut reply = vec![address];
    reply.extend(answer);
    reply.extend(Crc::of(&reply).to_bytes());
    reply
}

/// The answer that refuses a request.
pub(crate) fn refusal(request: &[u8], exception: Exception) -> Vec<u8> {
    let function = request.first().copied().unwrap_or_default();
    vec![function | 0x80, exception as u8]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_head_that_lies_about_its_length_is_none() {
        for (bytes, length) in [
            ([1, 2, 0, 0, 0, 6, 9], Some(5)),
            ([1, 2, 0, 0, 0, 2, 9], Some(1)),
            ([1, 2, 0, 0, 0, 254, 9], Some(253)),
            ([1, 2, 0, 0, 0, 255, 9], None),
            ([1, 2, 0, 0, 0, 1, 9], None),
            ([1, 2, 0, 0, 0, 0, 9], None),
            ([1, 2, 0, 0, 255, 255, 9], None),
            ([1, 2, 0, 1, 0, 6, 9], None),
            ([1, 2, 1, 0, 0, 6, 9], None),
        ] {
            let head = Head::of(bytes);
            assert_eq!(head.map(|head| head.length), length, "{bytes:?}");
            assert!(head.is_none_or(|head| head.unit == 9), "{bytes:?}");
        }
    }

    #[test]
    fn a_request_goes_to_the_board_and_its_answer_comes_back() {
        let request = to_board(7, &[3, 0, 0, 0, 2]).unwrap();
        assert_eq!(request.bytes()[..6], [7, 3, 0, 0, 0, 2]);
        assert_eq!(Crc::of(request.bytes()).value(), 0);
        assert!(to_board(7, &[16; 253]).is_some());
        assert!(to_board(7, &[16; 254]).is_none());
        assert_eq!(to_board(7, &[3]).unwrap().bytes().len(), 4);
        assert_eq!(from_board(&[7, 3, 2, 0, 5, 1, 2]), [3, 2, 0, 5]);
        assert_eq!(from_board(&[7]), [0; 0]);
        let head = Head::of([1, 2, 0, 0, 0, 6, 9]).unwrap();
        assert_eq!(head.frame(&[3, 2, 0, 5]), [1, 2, 0, 0, 0, 5, 9, 3, 2, 0, 5]);
    }
}
