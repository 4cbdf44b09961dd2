//! The forms of what is said to a boot loader and what it answers.

use crate::model::Protocol;

/// Bytes of STK500v1 (Atmel's AVR061, section 7).
const IN_SYNC: u8 = 0x14;
const OK: u8 = 0x10;
const END: u8 = b' ';
const GET_SYNC: u8 = b'0';

/// Bytes of STK500v2 (AVR068, sections 3 and 5): how a message begins, what stands before its body, and that all is well.
const START: u8 = 0x1B;
const TOKEN: u8 = 0x0E;
const COMMAND_OK: u8 = 0x00;
const SIGN_ON: u8 = 0x01;
/// What a boot loader says that it is, after the length of it.
const NAME: &[u8] = b"\x08AVRISP_2";
/// Bytes before the body.
const HEAD: usize = 5;

/// An answer that is expected: how it begins, what may be anything, and how it ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Answer {
    pub head: Vec<u8>,
    /// Bytes that say something.
    pub says: usize,
    pub tail: Vec<u8>,
    /// Whether a checksum is the last byte.
    pub sum: bool,
}

/// Whether an answer has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Came<'a> {
    /// Not yet.
    Less,
    /// Something else has.
    Garbled,
    /// It has, and says this.
    All(&'a [u8]),
}

impl Answer {
    /// Reads what has come.
    pub fn read<'a>(&self, came: &'a [u8]) -> Came<'a> {
        let Answer {
            head,
            says,
            tail,
            sum,
        } = self;
        let ends = head.len() + says;
        let whole = ends + tail.len() + usize::from(*sum);
        let begins = came.iter().zip(head).all(|(came, head)| came == head);
        match came.len() {
            _ if !begins => Came::Garbled,
            length if length < whole => Came::Less,
            length if length > whole || !came[ends..].starts_with(tail) => Came::Garbled,
            _ if *sum && check(came) != 0 => Came::Garbled,
            _ => Came::All(&came[head.len()..ends]),
        }
    }
}

impl Protocol {
    /// The question whether a boot loader is there.
    pub fn call(self) -> Vec<u8> {
        match self {
            Protocol::V1 => vec![GET_SYNC, END],
            Protocol::V2 => message(1, &[SIGN_ON]),
        }
    }

    /// The answer to it.
    pub fn called(self) -> Vec<u8> {
        match self {
            Protocol::V1 => vec![IN_SYNC, OK],
            Protocol::V2 => message(1, &[&[SIGN_ON, COMMAND_OK], NAME].concat()),
        }
    }

    /// A request as it is sent, and its answer, which says so many bytes. `number` counts from the first after the call.
    pub fn exchange(self, number: u8, request: &[u8], says: usize) -> (Vec<u8>, Answer) {
        match self {
            Protocol::V1 => (
                [request, &[END]].concat(),
                Answer {
                    head: vec![IN_SYNC],
                    says,
                    tail: vec![OK],
                    sum: false,
                },
            ),
            Protocol::V2 => {
                // What is read stands between two states.
                let tail = if says > 0 {
                    vec![COMMAND_OK]
                } else {
                    Vec::new()
                };
                let number = number.wrapping_add(1);
                let mut head = begin(number, 2 + says + tail.len());
                head.extend([request.first().copied().unwrap_or_default(), COMMAND_OK]);
                let answer = Answer {
                    head,
                    says,
                    tail,
                    sum: true,
                };
                (message(number, request), answer)
            }
        }
    }
}

/// What stands before the body of a message.
fn begin(number: u8, size: usize) -> Vec<u8> {
    let mut head = Vec::with_capacity(HEAD);
    let [high, low] = (size as u16).to_be_bytes();
    head.extend([START, number, high, low, TOKEN]);
    head
}

/// A message with this body.
fn message(number: u8, body: &[u8]) -> Vec<u8> {
    let mut message = begin(number, body.len());
    message.extend(body);
    message.push(check(&message));
    message
}

/// The checksum of STK500v2; of a message with its own it is 0.
fn check(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0, |sum, byte| sum ^ byte)
}
