//! The commands: what the card does with a frame of 6 bytes (section 7.3.1), and its responses (section 7.3.2).

use super::crc::crc7;
use super::exchange::Phase;
use super::registers::{self, BLOCK};
use super::{At, Command, Kind, Mode, Presence, SdCard, What};

/// Bits of R1 (section 7.3.2.1).
mod r1 {
    pub const IDLE: u8 = 0x01;
    pub const ILLEGAL: u8 = 0x04;
    pub const CRC: u8 = 0x08;
    pub const ADDRESS: u8 = 0x20;
    pub const PARAMETER: u8 = 0x40;
}

/// What follows R1.
enum Tail {
    Nothing,
    /// The further bytes of R2, R3 or R7.
    Bytes(Vec<u8>),
    /// A register, as a data packet.
    Register([u8; 16]),
    /// Memory goes out, or comes in.
    Memory(Phase),
    /// Busy for [`Timing::stop_busy`](super::Timing::stop_busy) bytes.
    Busy,
}

/// The error bits of an R1 with which the command is refused.
struct Refused(u8);

impl SdCard {
    /// A complete frame has come.
    pub(super) fn command(&mut self, frame: [u8; 6]) {
        let index = frame[0] & 0x3F;
        let argument = u32::from_be_bytes([frame[1], frame[2], frame[3], frame[4]]);
        let fault = self.fault_at(At::Command(self.log.commands.len()));
        let app = std::mem::take(&mut self.app);
        // ACMD41 is the only application command here; any other index after CMD55 is the plain command (section 4.3.9).
        let app = app && index == 41;
        let answer = self.answer(
            app,
            index,
            argument,
            crc7(&frame[..5]) == frame[5] >> 1,
            fault,
        );
        self.log.commands.push(Command {
            index,
            app,
            argument,
            answer,
            time: self.now,
        });
    }

    /// Does the command, queues the response, and gives its R1; `None` where the card keeps silent.
    fn answer(
        &mut self,
        app: bool,
        index: u8,
        argument: u32,
        intact: bool,
        fault: Option<What>,
    ) -> Option<u8> {
        match fault {
            Some(What::NoAnswer) => return None,
            Some(What::Removed) => {
                self.presence = Presence::Removed;
                return None;
            }
            Some(What::Stuck) => {
                self.presence = Presence::Stuck;
                self.phase = Phase::Waiting;
                self.out.clear();
                return None;
            }
            Some(What::NeverReady) => self.never_ready = true,
            _ => {}
        }
        if let Mode::Native { clocks } = self.mode {
            if index != 0 || !intact || clocks < 74 {
                return None;
            }
            self.mode = Mode::Idle;
        }
        // Programming ends by itself or by a reset; until then the card does not listen.
        if self.is_busy() && index != 0 {
            return None;
        }
        // CMD12 arrives while data is going out, and one more byte of that data is on its way: the stuff byte.
        let stuff = (index == 12).then(|| self.next_out());
        let streaming = matches!(
            self.phase,
            Phase::Sending { many: true, .. } | Phase::Stalled
        );
        self.phase = Phase::Waiting;
        self.out.clear();
        self.out.extend(stuff);

        let checked = self.crc_on || index == 0 || index == 8;
        let done = if (checked && !intact) || fault == Some(What::WrongCrc) && !moves_data(index) {
            Err(Refused(r1::CRC))
        } else if app {
            Ok(self.initialise(argument & 1 << 30 != 0))
        } else {
            self.execute(index, argument, streaming, fault)
        };
        let idle = if self.mode == Mode::Ready {
            0
        } else {
            r1::IDLE
        };
        let (r1, tail) = match done {
            Ok(tail) => (idle, tail),
            Err(Refused(bits)) => (idle | bits, Tail::Nothing),
        };
        self.respond(r1, tail, fault);
        Some(r1)
    }

    fn respond(&mut self, r1: u8, tail: Tail, fault: Option<What>) {
        self.out
            .extend((0..self.timing.response_delay).map(|_| 0xFF));
        self.out.push_back(r1);
        let extra = match fault {
            Some(What::Busy(bytes)) => bytes,
            _ => 0,
        };
        self.busy = extra;
        match tail {
            Tail::Nothing => {}
            Tail::Bytes(bytes) => self.out.extend(bytes),
            Tail::Busy => self.busy = self.timing.stop_busy.saturating_add(extra),
            Tail::Memory(phase) => {
                // A read is late instead of busy.
                if matches!(phase, Phase::Sending { .. }) {
                    self.busy = 0;
                }
                self.phase = phase;
            }
            Tail::Register(register) => {
                self.busy = 0;
                self.send_delay(fault);
                self.send_packet(&register, fault);
            }
        }
    }

    fn execute(
        &mut self,
        index: u8,
        argument: u32,
        streaming: bool,
        fault: Option<What>,
    ) -> Result<Tail, Refused> {
        let ready = self.mode == Mode::Ready;
        Ok(match index {
            0 => {
                self.mode = Mode::Idle;
                self.crc_on = false;
                self.go_idle();
                Tail::Nothing
            }
            1 => self.initialise(argument & 1 << 30 != 0),
            8 if !ready && self.kind != Kind::SdV1 => {
                self.host_is_v2 = true;
                // VHS 0001: 2.7 to 3.6 V, which is all this card takes. The check pattern goes back as it came.
                let [_, _, vhs, pattern] = argument.to_be_bytes();
                let accepted = if vhs & 0x0F == 1 { 1 } else { 0 };
                Tail::Bytes(vec![0, 0, accepted, pattern])
            }
            55 => {
                self.app = true;
                Tail::Nothing
            }
            58 => Tail::Bytes(registers::ocr(self.kind, ready).to_be_bytes().to_vec()),
            59 => {
                self.crc_on = argument & 1 == 1;
                Tail::Nothing
            }
            _ if !ready => return Err(Refused(r1::ILLEGAL)),
            9 => Tail::Register(self.geometry.csd()),
            10 => Tail::Register(registers::cid()),
            12 if streaming => Tail::Busy,
            13 => Tail::Bytes(vec![0]),
            16 => {
                // READ_BL_PARTIAL: 1 to 512 bytes; high capacity takes it and keeps to 512 (section 4.3.2).
                if !(1..=BLOCK as u32).contains(&argument) {
                    return Err(Refused(r1::PARAMETER));
                }
                if self.kind != Kind::Sdhc {
                    self.block_len = argument;
                }
                Tail::Nothing
            }
            17 | 18 => Tail::Memory(Phase::Sending {
                from: self.locate(argument, self.block_len as usize)?,
                len: self.block_len as usize,
                many: index == 18,
                // The other faults have struck already.
                fault: fault.filter(|what| {
                    use What::{Busy, Garbage, WrongCrc, WrongToken};
                    matches!(what, WrongCrc | WrongToken | Garbage | Busy(_))
                }),
                announced: false,
            }),
            24 => {
                // WRITE_BL_PARTIAL is 0.
                if self.block_len as usize != BLOCK {
                    return Err(Refused(r1::PARAMETER));
                }
                Tail::Memory(Phase::AwaitingToken {
                    at: self.locate(argument, BLOCK)?,
                })
            }
            _ => return Err(Refused(r1::ILLEGAL)),
        })
    }

    /// ACMD41 and CMD1: one round of the initialisation. `hcs`: the host can handle high capacity.
    fn initialise(&mut self, hcs: bool) -> Tail {
        let willing = !self.never_ready && (self.kind != Kind::Sdhc || hcs && self.host_is_v2);
        if self.mode == Mode::Idle && willing {
            if self.polls < self.timing.init_polls {
                self.polls += 1;
            } else {
                self.mode = Mode::Ready;
            }
        }
        Tail::Nothing
    }

    /// Turns the address of a command into a place in the memory for `len` bytes.
    fn locate(&self, argument: u32, len: usize) -> Result<usize, Refused> {
        let unit = if self.kind == Kind::Sdhc { BLOCK } else { 1 };
        let at = argument as usize * unit;
        if at % BLOCK + len > BLOCK {
            Err(Refused(r1::ADDRESS))
        } else if at + len > self.image.len() {
            Err(Refused(r1::PARAMETER))
        } else {
            Ok(at)
        }
    }
}

/// True for the commands that send a data packet, so that a wrong CRC can be the packet's.
fn moves_data(index: u8) -> bool {
    matches!(index, 9 | 10 | 17 | 18)
}
