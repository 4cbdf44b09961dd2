//! Writes one block of the card beside the scans: in small steps, and without waiting for the card.
//!
//! Owns CMD24 and what follows it (SD Physical Layer Simplified Specification, 7.2.4); must not know
//! what the block says. The driver that reads the card would wait for it, up to 250 ms for a block.

use super::Place;
use crate::board::Board;
use crate::board::spi::CardBus;
use embedded_sdmmc::embedded_sdmmc_types::sdcard::{self as sd, CmdId};
use unoclp_core::Crc16;

/// Bytes of a block.
const BLOCK: u16 = 512;
/// Bytes of it that go to the card in one step: so few that no step has two numbers in it.
const STEP: u8 = 4;
/// How long a card may stay busy with a block, ms: twice what the specification allows SDHC (4.6.2.2).
const BUSY: u16 = 500;
/// How many bytes a card may let pass before it answers (7.5.1.1).
const PATIENCE: u8 = 8;

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

/// The card has refused something, or does not answer in time.
pub struct CardFailed;

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
        let mut bus = board.resume_card();
        command(&mut bus, CmdId::CMD24_WriteBlock, self.place.argument)?;
        bus.exchange(0xFF);
        bus.exchange(sd::DATA_START_BLOCK);
        self.crc = Crc16::starting_at(0);
        self.phase = Phase::Sending(0);
        Ok(())
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
                let mut bus = board.resume_card();
                for _ in 0..STEP {
                    let byte = byte(*at);
                    self.crc.push(byte);
                    bus.exchange(byte);
                    *at += 1;
                }
                if *at == BLOCK {
                    let [high, low] = self.crc.value().to_be_bytes();
                    bus.exchange(high);
                    bus.exchange(low);
                    if answer(&mut bus)? & sd::DATA_RES_MASK != sd::DATA_RES_ACCEPTED {
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
                let mut bus = board.resume_card();
                // Selected again, it has the line from the second byte on.
                bus.exchange(0xFF);
                let ready = bus.exchange(0xFF) == 0xFF;
                if ready {
                    // Its status, two bytes: whether the block has come to its place.
                    command(&mut bus, CmdId::CMD13_SendStatus, 0)?;
                    if bus.exchange(0xFF) != 0 {
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

/// Sends a command; anything but "ready, no error" is a failure.
fn command(bus: &mut CardBus<'_>, command: CmdId, argument: u32) -> Result<(), CardFailed> {
    let [a, b, c, d] = argument.to_be_bytes();
    let frame = [0x40 | command as u8, a, b, c, d];
    bus.exchange(0xFF);
    for &byte in &frame {
        bus.exchange(byte);
    }
    bus.exchange(sd::crc7(&frame) << 1 | 1);
    if answer(bus)? == sd::R1_READY_STATE {
        Ok(())
    } else {
        Err(CardFailed)
    }
}

/// The next byte that is not just an idle line.
fn answer(bus: &mut CardBus<'_>) -> Result<u8, CardFailed> {
    for _ in 0..=PATIENCE {
        let byte = bus.exchange(0xFF);
        if byte != 0xFF {
            return Ok(byte);
        }
    }
    Err(CardFailed)
}
