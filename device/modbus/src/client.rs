//! The frames of a client: its requests, and what is an answer to them.

use crate::frame::{operands, word};
use crate::identification::{FIRST_OBJECT, FUNCTION, READ_DEVICE_IDENTIFICATION};
use crate::map::Span;
use crate::{Crc, Exception, FRAME_BYTES, Frame, Table};

/// The most words that one request writes (section 6.12).
pub const MOST_WORDS: usize = 123;

/// A request with its checksum, as it is sent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Request {
    frame: Frame,
    length: usize,
}

impl Request {
    /// Reads bits, at most 2000, or words, at most 125 (sections 6.1 to 6.4).
    pub fn read(server: u8, table: Table, first: u16, count: u16) -> Request {
        let [[a, b], [c, d]] = [first, count].map(u16::to_be_bytes);
        Request::of([server, table as u8, a, b, c, d])
    }

    /// Writes a coil (section 6.5).
    pub fn write_coil(server: u8, address: u16, on: bool) -> Request {
        let [a, b] = address.to_be_bytes();
        Request::of([server, 5, a, b, if on { 0xFF } else { 0 }, 0])
    }

    /// Writes a holding register (section 6.6).
    pub fn write_word(server: u8, address: u16, value: u16) -> Request {
        let [[a, b], [c, d]] = [address, value].map(u16::to_be_bytes);
        Request::of([server, 6, a, b, c, d])
    }

    /// Writes holding registers (section 6.12); none where there are more than [`MOST_WORDS`].
    pub fn write_words(server: u8, first: u16, values: &[u16]) -> Option<Request> {
        if values.len() > MOST_WORDS {
            return None;
        }
        let count = values.len() as u8;
        let [a, b] = first.to_be_bytes();
        let head = [server, 16, a, b, 0, count, 2 * count];
        let data = values.iter().flat_map(|value| value.to_be_bytes());
        Some(Request::of(head.into_iter().chain(data)))
    }

    /// Asks for the basic identification: vendor, product and version (section 6.21).
    pub fn identify(server: u8) -> Request {
        Request::of([server, FUNCTION, READ_DEVICE_IDENTIFICATION, 1, 0])
    }

    /// The request that another client has sent, whole; `None` for a frame with a bad checksum, or one too short or too
    /// long for a request. What it asks for is for the server to judge.
    pub fn forwarded(frame: &[u8]) -> Option<Request> {
        let fits = (4..=FRAME_BYTES).contains(&frame.len());
        let (body, _) = frame.split_last_chunk::<2>()?;
        let is_sound = fits && Crc::of(frame).value() == 0;
        is_sound.then(|| Request::of(body.iter().copied()))
    }

    /// Whom it asks.
    pub fn server(&self) -> u8 {
        self.frame[0]
    }

    /// Whether it changes nothing at the server: it reads, or asks for the identification.
    pub fn only_reads(&self) -> bool {
        matches!(self.frame[1], 1..=4 | FUNCTION)
    }

    /// The word that it writes to the first register of this span, if it does. What no board takes may write one too.
    pub fn written(&self, span: Span) -> Option<u16> {
        let offset = span.first.checked_sub(word(&self.frame, 2))?;
        let (count, data) = match self.frame[1] {
            6 | 16 if span.table == Table::HoldingRegisters => operands(&self.frame),
            _ => return None,
        };
        // A frame holds no more words than this.
        let offset = u8::try_from(offset).ok().filter(|_| offset < count)?;
        Some(word(&self.frame, data.checked_add(offset.checked_mul(2)?)?))
    }

    /// The answer by which a gateway refuses it.
    pub fn refusal(&self, exception: Exception) -> [u8; 5] {
        let [server, function, ..] = self.frame;
        let body = [server, function | 0x80, exception as u8];
        let [low, high] = Crc::of(&body).to_bytes();
        [body[0], body[1], body[2], low, high]
    }

    /// Puts the checksum after the bytes, which leave room for it.
    fn of(bytes: impl IntoIterator<Item = u8>) -> Request {
        let mut frame = [0; FRAME_BYTES];
        let (body, _) = frame.split_at_mut(FRAME_BYTES - 2);
        let mut length = 0;
        for (place, byte) in body.iter_mut().zip(bytes) {
            *place = byte;
            length += 1;
        }
        let sum = Crc::of(&frame[..length]).to_bytes();
        frame[length..length + 2].copy_from_slice(&sum);
        Request {
            frame,
            length: length + 2,
        }
    }

    /// What is sent.
    pub fn bytes(&self) -> &[u8] {
        &self.frame[..self.length]
    }

    /// What has come back is an answer, or it is none; `None` while more must come to tell.
    pub fn answer<'r>(&self, came: &'r [u8]) -> Option<Result<Reply<'r>, NoReply>> {
        let length = length(came)?;
        if came.len() < length {
            return None;
        }
        Some(self.judge(came, length))
    }

    fn judge<'r>(&self, came: &'r [u8], length: usize) -> Result<Reply<'r>, NoReply> {
        let [server, function, ..] = self.frame;
        let [from, answered, rest @ .., _, _] = came else {
            return Err(NoReply::Garbled);
        };
        if came.len() != length || Crc::of(came).value() != 0 || *from != server {
            return Err(NoReply::Garbled);
        }
        if *answered == function | 0x80 {
            let exception = rest.first().and_then(|&code| Exception::of(code));
            return Err(exception.map_or(NoReply::Garbled, NoReply::Refused));
        }
        let count = u16::from_be_bytes([self.frame[4], self.frame[5]]);
        let (data, fits) = match function {
            1 | 2 => (
                rest.get(1..).unwrap_or_default(),
                rest.len() == 1 + usize::from(count.div_ceil(8)),
            ),
            3 | 4 => (
                rest.get(1..).unwrap_or_default(),
                rest.len() == 1 + 2 * usize::from(count),
            ),
            FUNCTION => (
                rest.get(FIRST_OBJECT as usize - 2..).unwrap_or_default(),
                true,
            ),
            // A write is answered by how it began.
            _ => (&[][..], *rest == self.frame[2..6]),
        };
        if *answered == function && fits {
            Ok(Reply { data })
        } else {
            Err(NoReply::Garbled)
        }
    }
}

/// Why what has come back is no reply.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoReply {
    /// It is no answer to this request.
    Garbled,
    /// The server refuses it.
    Refused(Exception),
}

/// A sound answer to a request, with as much data as was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reply<'r> {
    data: &'r [u8],
}

impl<'r> Reply<'r> {
    /// The words that were read.
    pub fn words(self) -> impl Iterator<Item = u16> + 'r {
        let pairs = self.data.as_chunks().0.iter();
        pairs.map(|pair| u16::from_be_bytes(*pair))
    }

    /// The bits that were read, and those that fill up their last byte.
    pub fn bits(self) -> impl Iterator<Item = bool> + 'r {
        let bits = |byte: &u8| {
            (0..8).map({
                let byte = *byte;
                move |bit| byte >> bit & 1 != 0
            })
        };
        self.data.iter().flat_map(bits)
    }

    /// The texts of an identification, as they are numbered.
    pub fn texts(self) -> Texts<'r> {
        Texts(self.data)
    }
}

/// The texts of an identification: number, length, bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Texts<'r>(&'r [u8]);

impl<'r> Iterator for Texts<'r> {
    type Item = &'r [u8];

    fn next(&mut self) -> Option<&'r [u8]> {
        let [_, length, rest @ ..] = self.0 else {
            return None;
        };
        let (text, rest) = rest.split_at_checked((*length).into())?;
        self.0 = rest;
        Some(text)
    }
}

/// How many bytes an answer that begins so has, its checksum among them; `None` while that is not told yet.
fn length(came: &[u8]) -> Option<usize> {
    let &[_, function, third, ..] = came else {
        return None;
    };
    Some(match function {
        1..=4 => 5 + usize::from(third),
        5 | 6 | 15 | 16 => 8,
        FUNCTION => identification_length(came)?,
        0x80.. => 5,
        // It is no answer, and as long as it is.
        _ => came.len().max(5),
    })
}

fn identification_length(came: &[u8]) -> Option<usize> {
    let (head, objects) = came.split_at_checked(FIRST_OBJECT.into())?;
    let count = usize::from(*head.last()?);
    let mut texts = Texts(objects);
    let all = texts.by_ref().take(count).count() == count;
    all.then(|| came.len() - texts.0.len() + 2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::{coil, holding};

    #[test]
    fn what_a_request_writes_to_a_register_is_told() {
        let (command, ends) = (holding::COMMAND, holding::FORCING_ENDS);
        let several = |first, words: &[u16]| Request::write_words(1, first, words).unwrap();
        let claims = Request::of([1, 16, 0x01, 0x90, 0xFF, 0xFF, 2, 0, 5]);
        for (request, span, written) in [
            (Request::write_word(1, 400, 5), command, Some(5)),
            (Request::write_word(1, 401, 5), command, None),
            (several(400, &[2]), command, Some(2)),
            (several(402, &[1, 2, 3, 4, 5]), ends, Some(5)),
            (several(402, &[1, 2, 3, 4]), ends, None),
            (several(402, &[1]), command, None),
            (several(278, &[7; MOST_WORDS]), command, Some(7)),
            (several(277, &[7; MOST_WORDS]), command, None),
            (claims.clone(), command, Some(5)),
            (claims, holding::REGISTERS, None),
            (Request::write_coil(1, 400, true), command, None),
            (Request::write_word(1, 0, 5), coil::OUTPUTS, None),
            (
                Request::read(1, Table::HoldingRegisters, 400, 1),
                command,
                None,
            ),
            (Request::of([1, 6]), command, None),
        ] {
            assert_eq!(
                request.written(span),
                written,
                "{:?} {span:?}",
                request.bytes()
            );
        }
    }
}
