//! Writes one block of the card beside the scans: in small steps, and without waiting for the card.
//!
//! Owns CMD24 and what follows it (SD Physical Layer Simplified Specification, 7.2.4); must not know
//! what the block says.

use super::commands::{BLOCK_BEGINS, CardFailed, Place, READY, SILENCE, answer, command};
use crate::board::Board;
use unoclp_core::Crc16;

/// Bytes of a block.
const BLOCK: u16 = 512;
/// Bytes of it that go to the card in one step: so few that no step has two numbers in it.
const STEP: u8 = 4;
/// How long a card may stay busy with a block, ms: twice what the specification allows SDHC (4.6.2.2).
const BUSY: u16 = 500;

// Commands.
const SEND_STATUS: u8 = 13;
const WRITE_BLOCK: u8 = 24;
/// The answer to a block, and the bits that make it (7.3.3.1).
const ACCEPTED: u8 = 0x05;
const DATA_RESPONSE: u8 = 0x1F;

/// Writes to one place of a card, which start-up has left ready.
pub struct Writer {
    place: Place,
    phase: Phase,
    crc: Crc16,
}

enum Phase {
    Idle,
    /// The card takes the block; so many bytes of it have gone.
    Sending(u16),
    /// The card, no longer selected, writes the block since `since`, and was `asked` last.
    Busy {
        since: u16,
        asked: u16,
    },
}

/// How far a block has come.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// There is more to do.
    Going,
    /// All done: the next block may begin.
    Ready,
}

impl Writer {
    /// To this place.
    pub fn new(place: Place) -> Writer {
        Writer {
            place,
            phase: Phase::Idle,
            crc: Crc16::starting_at(0),
        }
    }

    /// Announces a block to the card.
    pub fn begin(&mut self, board: &Board) -> Result<(), CardFailed> {
        let bus = board.resume_card();
        if command(bus, WRITE_BLOCK, self.place.argument) != READY {
            return Err(CardFailed);
        }
        bus.exchange(SILENCE);
        bus.exchange(BLOCK_BEGINS);
        self.crc = Crc16::starting_at(0);
        self.phase = Phase::Sending(0);
        Ok(())
    }

    /// Whether the card is selected, and takes a block.
    pub fn is_sending(&self) -> bool {
        matches!(self.phase, Phase::Sending(_))
    }

    /// One step at this time (ms, wrapping). `byte` gives the bytes of the block, in order.
    pub fn step(
        &mut self,
        board: &Board,
        now: u16,
        mut byte: impl FnMut(u16) -> u8,
    ) -> Result<Progress, CardFailed> {
        match &mut self.phase {
            Phase::Idle => return Ok(Progress::Ready),
            Phase::Sending(at) => {
                let bus = board.resume_card();
                for _ in 0..STEP {
                    let byte = byte(*at);
                    self.crc = self.crc.then(byte);
                    bus.exchange(byte);
                    *at += 1;
                }
                if *at == BLOCK {
                    let [high, low] = self.crc.to_be_bytes();
                    bus.exchange(high);
                    bus.exchange(low);
                    if answer(bus) & DATA_RESPONSE != ACCEPTED {
                        return Err(CardFailed);
                    }
                    board.release_card();
                    self.phase = Phase::Busy {
                        since: now,
                        asked: now,
                    };
                }
            }
            Phase::Busy { since, asked } if now != *asked => {
                *asked = now;
                let overdue = now.wrapping_sub(*since) > BUSY;
                let bus = board.resume_card();
                // Selected again, it has the line from the second byte on.
                bus.exchange(SILENCE);
                let ready = bus.exchange(SILENCE) == SILENCE;
                if ready {
                    // Its status, two bytes: whether the block has come to its place.
                    if command(bus, SEND_STATUS, 0) != READY || bus.exchange(SILENCE) != 0 {
                        return Err(CardFailed);
                    }
                    self.phase = Phase::Idle;
                } else if overdue {
                    return Err(CardFailed);
                }
                board.release_card();
            }
            Phase::Busy { .. } => {}
        }
        Ok(Progress::Going)
    }
}
