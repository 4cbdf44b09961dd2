//! Wakes a card and reads its blocks, with a deadline for every wait.
//!
//! Owns the way into the card's ready state (SD Physical Layer Simplified Specification, 7.2.1) and CMD17
//! (7.2.3); must not know what the blocks say.

use super::commands::{self, BLOCK_BEGINS, CardFailed, IDLE, ILLEGAL, Place, READY, SILENCE};
use crate::board::Board;
use crate::board::clock::Deadline;
use crate::board::spi::CardBus;
use unoclp_card::{Block, Device};
use unoclp_core::{Cause, Crc16};

/// How long a slot may stay silent from the start on, ms. It is asked all the time: some cards miss the
/// first command after power-up.
const SILENT: u16 = 240;
/// How long a card may take until it is ready, ms. The specification allows it 1 s (4.2.3); together
/// with a block's time this gives a dead card up within 2 s.
const START: u16 = 1500;
/// How long one reading of a block may take, ms. The specification allows 100 ms (4.6.2.1).
const BLOCK: u16 = 120;
/// How often a block is read that arrives damaged: wires on a breadboard pick up noise.
const READS: u8 = 3;

// Commands, and what they ask for.
const GO_IDLE: u8 = 0;
const INTERFACE_CONDITION: u8 = 8;
/// 2.7 to 3.6 V, and a pattern that comes back.
const VOLTAGE: u32 = 0x1AA;
const PATTERN: u8 = 0xAA;
/// The answer of a card from before there was this command.
const OLD: u8 = IDLE | ILLEGAL;
const READ_BLOCK: u8 = 17;
const APPLICATION: u8 = 55;
const READ_OCR: u8 = 58;
const CRC: u8 = 59;
/// Behind [`APPLICATION`].
const OPERATING_CONDITION: u8 = 41;
/// In its argument: cards of more than 2 GB are welcome.
const HIGH_CAPACITY: u32 = 1 << 30;
/// In the first byte of the OCR: ready, and such a card.
const BY_NUMBER: u8 = 0xC0;

/// Wakes the card until it is ready; where it answers nonsense, again from the beginning. Gives whether it
/// has its blocks by their number, and not by their first byte.
#[inline(never)]
pub fn start(board: &Board) -> Result<bool, Cause> {
    let bus = board.card_bus();
    let (silent, ready) = (Deadline::from_start(SILENT), Deadline::after(START));
    let mut answered = false;
    loop {
        bus.wake();
        let answer = commands::command(bus, GO_IDLE, 0);
        if answer == IDLE
            && let Some(by_number) = get_ready(bus, ready)
        {
            return Ok(by_number);
        }
        answered |= answer != SILENCE;
        if answered && ready.has_passed() {
            return Err(Cause::CardDead);
        }
        if !answered && silent.has_passed() {
            return Err(Cause::NoCard);
        }
    }
}

/// A card that is ready, and room for a block of it.
pub struct Card<'b> {
    bus: CardBus<'b>,
    block: &'b mut Block,
    by_number: bool,
}

impl<'b> Card<'b> {
    /// A card that [`start`] has left ready.
    pub fn new(board: &'b Board, block: &'b mut Block, by_number: bool) -> Card<'b> {
        Card {
            bus: board.resume_card(),
            block,
            by_number,
        }
    }

    /// Where the block of this number is, as the card's commands have it.
    #[inline(never)]
    pub fn place(&self, number: u32) -> Place {
        let argument = if self.by_number { number } else { number << 9 };
        Place { argument }
    }

    #[inline(never)]
    fn read_once(&mut self, number: u32) -> Result<(), CardFailed> {
        let deadline = Deadline::after(BLOCK);
        let place = self.place(number);
        if commands::command(self.bus, READ_BLOCK, place.argument) != READY {
            return Err(CardFailed);
        }
        loop {
            match self.bus.exchange(SILENCE) {
                BLOCK_BEGINS => break,
                SILENCE if !deadline.has_passed() => {}
                _ => return Err(CardFailed),
            }
        }
        for byte in self.block.iter_mut() {
            *byte = self.bus.exchange(SILENCE);
        }
        let mut crc = Crc16::starting_at(0);
        crc.extend(self.block);
        let [high, low] = crc.to_be_bytes();
        if self.bus.exchange(SILENCE) == high && self.bus.exchange(SILENCE) == low {
            Ok(())
        } else {
            Err(CardFailed)
        }
    }
}

impl Device for Card<'_> {
    type Error = CardFailed;

    #[inline(never)]
    fn read(&mut self, number: u32) -> Result<(), CardFailed> {
        for _ in 0..READS {
            if self.read_once(number).is_ok() {
                return Ok(());
            }
            self.bus.end_packet();
        }
        Err(CardFailed)
    }

    fn block(&self) -> &Block {
        self.block
    }
}

/// From idle to ready; gives whether the card has its blocks by their number. None where its answers
/// make no sense, or it takes too long.
#[inline(never)]
fn get_ready(bus: CardBus<'_>, deadline: Deadline) -> Option<bool> {
    let command = |number, argument| commands::command(bus, number, argument);
    if command(CRC, 1) != IDLE {
        return None;
    }
    let mut wanted = 0;
    let answer = command(INTERFACE_CONDITION, VOLTAGE);
    if answer != OLD {
        // Silence has no pattern either.
        if last_of_four(bus) != PATTERN {
            return None;
        }
        wanted = HIGH_CAPACITY;
    }
    loop {
        command(APPLICATION, 0);
        match command(OPERATING_CONDITION, wanted) {
            READY => break,
            _ if deadline.has_passed() => return None,
            _ => {}
        }
    }
    if wanted == 0 {
        return Some(false);
    }
    if command(READ_OCR, 0) != READY {
        return None;
    }
    let by_number = bus.exchange(SILENCE) & BY_NUMBER == BY_NUMBER;
    Some(by_number)
}

fn last_of_four(bus: CardBus<'_>) -> u8 {
    for _ in 0..3u8 {
        bus.exchange(SILENCE);
    }
    bus.exchange(SILENCE)
}
