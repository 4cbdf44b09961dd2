//! The bus side of the card: bytes in and out, chip select, data packets.

use super::crc::crc16;
use super::fault::garbage;
use super::registers::BLOCK;
use super::{At, Mode, Presence, SdCard, What, Write};

/// Start token of every data packet except those of CMD25 (section 7.3.3.2).
const START: u8 = 0xFE;
/// Data error token: the card's own error correction failed (section 7.3.3.3).
const TOKEN_ECC_FAILED: u8 = 0x04;
/// Data error token: the address ran out of the card.
const TOKEN_OUT_OF_RANGE: u8 = 0x08;
/// Data responses (section 7.3.3.1); the three upper bits are undefined, and set here.
const ACCEPTED: u8 = 0xE5;
const CRC_ERROR: u8 = 0xEB;
const WRITE_ERROR: u8 = 0xED;

/// What the card is in the middle of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Phase {
    /// For a command.
    Waiting,
    /// CMD17 and CMD18, sending memory: the next packet starts once everything before it is out.
    Sending {
        /// First byte of the memory.
        from: usize,
        /// Bytes of each packet.
        len: usize,
        /// CMD18: go on until CMD12.
        many: bool,
        /// What the command's own fault does to the next packet.
        fault: Option<What>,
        /// The bytes before the token are out, or on their way.
        announced: bool,
    },
    /// CMD18 has nothing more to send, but CMD12 has not come.
    Stalled,
    /// CMD24: waiting for the start token of the data for this byte of the memory.
    AwaitingToken { at: usize },
    /// CMD24: data and CRC16 so far.
    Receiving { at: usize, data: Vec<u8> },
}

impl SdCard {
    /// Drives chip select: `low` selects the card.
    pub fn select(&mut self, low: bool) {
        if !low {
            self.frame.clear();
        }
        self.log.selections += u64::from(low && !self.selected);
        self.selected = low;
    }

    /// Eight clocks: takes the byte on MOSI and gives the one on MISO, which the card decided on before.
    pub fn exchange(&mut self, mosi: u8) -> u8 {
        if self.presence == Presence::Removed {
            return 0xFF;
        }
        if !self.selected {
            self.busy = self.busy.saturating_sub(1);
            if let (Mode::Native { clocks }, 0xFF) = (&mut self.mode, mosi) {
                *clocks = clocks.saturating_add(8);
            }
            return 0xFF;
        }
        let miso = self.next_out();
        if self.presence == Presence::Present {
            self.take(mosi);
        }
        miso
    }

    /// The byte that the card puts on MISO next, while selected.
    pub(super) fn next_out(&mut self) -> u8 {
        if self.out.is_empty() && !self.is_busy() {
            self.send_more();
        }
        if let Some(byte) = self.out.pop_front() {
            return byte;
        }
        match self.presence {
            Presence::Leaving => self.presence = Presence::Removed,
            Presence::Stuck => return 0x00,
            Presence::Present | Presence::Removed => {}
        }
        if self.is_busy() {
            self.busy = self.busy.saturating_sub(1);
            return 0x00;
        }
        0xFF
    }

    /// Takes one byte of the host.
    fn take(&mut self, mosi: u8) {
        let starts_command = mosi & 0xC0 == 0x40;
        let answered = self.out.is_empty();
        match &mut self.phase {
            // Not before the host has had R1 (section 7.2.4).
            Phase::AwaitingToken { at } if mosi == START && answered => {
                self.phase = Phase::Receiving {
                    at: *at,
                    data: Vec::with_capacity(BLOCK + 2),
                };
            }
            Phase::Receiving { at, data } => {
                data.push(mosi);
                if data.len() == BLOCK + 2 {
                    let (at, packet) = (*at, std::mem::take(data));
                    self.phase = Phase::Waiting;
                    self.receive_block(at, &packet);
                }
            }
            _ if self.frame.is_empty() && !starts_command => {}
            _ => {
                self.frame.push(mosi);
                if let Ok(frame) = <[u8; 6]>::try_from(self.frame.as_slice()) {
                    self.frame.clear();
                    self.command(frame);
                }
            }
        }
    }

    /// Queues the bytes before a token.
    pub(super) fn send_delay(&mut self, fault: Option<What>) {
        let extra = match fault {
            Some(What::Busy(extra)) => extra,
            _ => 0,
        };
        let delay = self.timing.data_delay.saturating_add(extra);
        self.out.extend((0..delay).map(|_| 0xFF));
    }

    /// Queues a data packet: token, data, CRC16; or what a fault makes of it.
    pub(super) fn send_packet(&mut self, data: &[u8], fault: Option<What>) {
        let garbled;
        let data = match fault {
            Some(What::WrongToken) => {
                self.out.push_back(TOKEN_ECC_FAILED);
                return;
            }
            Some(What::Garbage) => {
                garbled = garbage(data.len());
                &garbled
            }
            _ => data,
        };
        self.out.push_back(START);
        if fault == Some(What::Removed) {
            self.out.extend(&data[..data.len() / 2]);
            self.presence = Presence::Leaving;
            return;
        }
        self.out.extend(data);
        let crc = match fault {
            Some(What::WrongCrc) => !crc16(data),
            _ => crc16(data),
        };
        self.out.extend(crc.to_be_bytes());
    }

    /// Goes on with a read that is under way: first the bytes before the token, then the packet. So a packet that
    /// CMD12 forestalls is never begun, nor counted.
    fn send_more(&mut self) {
        let Phase::Sending {
            from,
            len,
            many,
            fault,
            announced,
        } = &mut self.phase
        else {
            return;
        };
        let (from, len, many, own_fault) = (*from, *len, *many, *fault);
        let first_time = !std::mem::replace(announced, true);
        let fault = own_fault.or(self.fault_at(At::Block(self.blocks)));
        if first_time {
            self.send_delay(fault);
            if !self.out.is_empty() {
                return;
            }
        }
        self.phase = if many { Phase::Stalled } else { Phase::Waiting };
        let Some(data) = self.image.get(from..from + len).map(<[u8]>::to_vec) else {
            self.out.push_back(TOKEN_OUT_OF_RANGE);
            return;
        };
        self.blocks += 1;
        match fault {
            Some(What::NoAnswer) => return,
            Some(What::Stuck) => {
                self.presence = Presence::Stuck;
                return;
            }
            Some(What::NeverReady) => self.never_ready = true,
            _ => {}
        }
        self.log.blocks_read += 1;
        self.send_packet(&data, fault);
        if many && !matches!(fault, Some(What::WrongToken | What::Removed)) {
            self.phase = Phase::Sending {
                from: from + len,
                len,
                many,
                fault: None,
                announced: false,
            };
        }
    }

    /// A whole packet of a write has come: 512 bytes and CRC16.
    fn receive_block(&mut self, at: usize, packet: &[u8]) {
        let (data, crc) = packet.split_at(BLOCK);
        let fault = self.fault_at(At::Block(self.blocks));
        self.blocks += 1;
        let damaged = self.crc_on && crc != crc16(data).to_be_bytes();
        match fault {
            Some(What::NoAnswer) => return,
            Some(What::Removed) => {
                self.presence = Presence::Removed;
                return;
            }
            Some(What::WrongToken) => return self.out.push_back(WRITE_ERROR),
            Some(What::WrongCrc) => return self.out.push_back(CRC_ERROR),
            _ if damaged => return self.out.push_back(CRC_ERROR),
            Some(What::Stuck) => self.presence = Presence::Stuck,
            Some(What::NeverReady) => self.never_ready = true,
            Some(What::Garbage | What::Busy(_)) | None => {}
        }
        let garbled;
        let data = if fault == Some(What::Garbage) {
            garbled = garbage(BLOCK);
            &garbled
        } else {
            data
        };
        if let Some(memory) = self.image.get_mut(at..at + BLOCK) {
            memory.copy_from_slice(data);
            self.log.blocks_written += 1;
            self.log.writes.push(Write {
                block: at / BLOCK,
                time: self.now,
            });
        }
        self.out.push_back(ACCEPTED);
        self.busy = match fault {
            Some(What::Busy(bytes)) => self.timing.write_busy.saturating_add(bytes),
            _ => self.timing.write_busy,
        };
        self.busy_until = self.now.saturating_add(self.write_time);
    }
}
