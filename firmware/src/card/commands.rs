//! What reading and writing a card have in common: its commands and answers
//! (SD Physical Layer Simplified Specification, sections 7.2 to 7.3).

use crate::board::spi::CardBus;

/// What the line gives while a card has nothing to say.
pub const SILENCE: u8 = 0xFF;
/// Answers to a command: in its idle state, no such command, ready (7.3.2.1).
pub const IDLE: u8 = 0x01;
pub const ILLEGAL: u8 = 0x04;
pub const READY: u8 = 0x00;
/// Stands before the bytes of a block (7.3.3.2).
pub const BLOCK_BEGINS: u8 = 0xFE;
/// How many bytes a card may let pass before it answers (7.5.1.1).
const PATIENCE: u8 = 8;

/// The card has refused something, or does not answer in time.
pub struct CardFailed;

/// A block of the card that may be overwritten. There is no other way to one than a `STATE.TXT`
/// that was found, and nothing but such a place is ever written.
pub struct Place {
    /// As the card's commands have it: a block's number, or its first byte on cards up to 2 GB.
    pub(super) argument: u32,
}

/// Sends the command of this number and gives the card's answer, or [`SILENCE`].
#[inline(never)]
pub fn command(bus: CardBus<'_>, number: u8, argument: u32) -> u8 {
    let [a, b, c, d] = argument.to_be_bytes();
    bus.exchange(SILENCE);
    let mut crc = send(bus, 0, 0x40 | number);
    crc = send(bus, crc, a);
    crc = send(bus, crc, b);
    crc = send(bus, crc, c);
    crc = send(bus, crc, d);
    bus.exchange(crc | 1);
    answer(bus)
}

/// Sends a byte of a command; gives the CRC-7 (4.5) up to here, in its upper bits.
#[inline(never)]
fn send(bus: CardBus<'_>, mut crc: u8, byte: u8) -> u8 {
    bus.exchange(byte);
    crc ^= byte;
    for _ in 0..8u8 {
        let carry = crc & 0x80 != 0;
        crc <<= 1;
        if carry {
            crc ^= 0x09 << 1;
        }
    }
    crc
}

/// The next byte that is not just an idle line, or [`SILENCE`].
#[inline(never)]
pub fn answer(bus: CardBus<'_>) -> u8 {
    let mut left = PATIENCE;
    loop {
        let byte = bus.exchange(SILENCE);
        if byte != SILENCE || left == 0 {
            return byte;
        }
        left -= 1;
    }
}
