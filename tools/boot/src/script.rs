//! What is said to a boot loader, from the first question to the last.
//!
//! The first page is written last. Until then a stall stands in its place: a chip whose flash was written in part
//! waits with its pins off, rather than run into the middle of a program. The boot loader of the Mega erases one page
//! after the other, from the first on, whichever it writes: before the first page comes again it is reset.

use crate::image::Image;
use crate::message::Answer;
use crate::model::{Chip, Protocol};
use crate::stage::Stage;

/// Commands of STK500v1 (Atmel's AVR061, section 7).
mod v1 {
    pub const ENTER_PROGRAMMING: u8 = b'P';
    pub const LEAVE_PROGRAMMING: u8 = b'Q';
    pub const LOAD_ADDRESS: u8 = b'U';
    pub const PROGRAM_PAGE: u8 = b'd';
    pub const READ_PAGE: u8 = b't';
    pub const READ_SIGNATURE: u8 = b'u';
    pub const FLASH: u8 = b'F';
}

/// Commands of STK500v2 (AVR068, section 5).
mod v2 {
    pub const LOAD_ADDRESS: u8 = 0x06;
    pub const ENTER_PROGRAMMING: u8 = 0x10;
    pub const LEAVE_PROGRAMMING: u8 = 0x11;
    pub const PROGRAM_FLASH: u8 = 0x13;
    pub const READ_FLASH: u8 = 0x14;
    pub const READ_SIGNATURE: u8 = 0x1B;
    /// What a chip is told to read a byte of its signature.
    pub const SIGNATURE: u8 = 0x30;
}

/// `nop` and `rjmp .-4`, forever: a jump to itself alone is what simulators take for a crash.
const STALL: [u8; 4] = [0x00, 0x00, 0xFE, 0xCF];

/// A request and the answer to it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Exchange {
    pub stage: Stage,
    pub subject: Subject,
    /// What is sent. Where it is empty, the board is reset and called again.
    pub request: Vec<u8>,
    pub answer: Answer,
}

/// What an exchange is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Subject {
    /// Nothing that is compared.
    Order,
    /// The signature of the chip, from this byte on.
    Signature(usize),
    /// What shall stand in flash from this address on.
    Flash(u32, Vec<u8>),
}

/// All that is said once the boot loader has answered.
pub(crate) fn script(image: &Image) -> Vec<Exchange> {
    let chip = image.model().chip();
    let mut script = Script::new(chip.protocol);
    script.ask_signature();
    script.enter();
    let mut stall = vec![0xFF; chip.page];
    stall[..STALL.len()].copy_from_slice(&STALL);
    script.write(Stage::Writing, 0, &stall);
    script.compare(Stage::Writing, 0, &stall);
    for (address, page) in image.pages().skip(1) {
        script.write(Stage::Writing, address, &page);
    }
    for (address, page) in image.pages().skip(1) {
        script.compare(Stage::Comparing, address, &page);
    }
    if chip.protocol == Protocol::V2 {
        script.reset();
    }
    for (address, page) in image.pages().take(1) {
        script.write(Stage::Finishing, address, &page);
        script.compare(Stage::Finishing, address, &page);
    }
    script.leave();
    script.exchanges
}

/// What asks a boot loader of the other kind which chip it is on.
pub(crate) fn stranger(chip: &Chip) -> (Protocol, Vec<Exchange>) {
    let other = match chip.protocol {
        Protocol::V1 => Protocol::V2,
        Protocol::V2 => Protocol::V1,
    };
    let mut script = Script::new(other);
    script.ask_signature();
    (other, script.exchanges)
}

struct Script {
    protocol: Protocol,
    /// How many exchanges there were since the last call.
    number: u8,
    exchanges: Vec<Exchange>,
}

impl Script {
    fn new(protocol: Protocol) -> Script {
        Script {
            protocol,
            number: 0,
            exchanges: Vec::new(),
        }
    }

    fn say(&mut self, stage: Stage, subject: Subject, request: &[u8]) {
        self.number = self.number.wrapping_add(1);
        let says = match (&subject, self.protocol) {
            (Subject::Order, _) => 0,
            (Subject::Signature(_), Protocol::V1) => 3,
            (Subject::Signature(_), Protocol::V2) => 1,
            (Subject::Flash(_, page), _) => page.len(),
        };
        let (request, answer) = self.protocol.exchange(self.number, request, says);
        self.exchanges.push(Exchange {
            stage,
            subject,
            request,
            answer,
        });
    }

    fn ask_signature(&mut self) {
        match self.protocol {
            Protocol::V1 => self.say(Stage::Meeting, Subject::Signature(0), &[v1::READ_SIGNATURE]),
            Protocol::V2 => {
                for index in 0..3 {
                    let request = [v2::READ_SIGNATURE, 4, v2::SIGNATURE, 0, index, 0];
                    self.say(Stage::Meeting, Subject::Signature(index.into()), &request);
                }
            }
        }
    }

    fn enter(&mut self) {
        let request = match self.protocol {
            Protocol::V1 => v1::ENTER_PROGRAMMING,
            Protocol::V2 => v2::ENTER_PROGRAMMING,
        };
        self.say(Stage::Meeting, Subject::Order, &[request]);
    }

    fn leave(&mut self) {
        let request = match self.protocol {
            Protocol::V1 => &[v1::LEAVE_PROGRAMMING][..],
            Protocol::V2 => &[v2::LEAVE_PROGRAMMING, 1, 1],
        };
        self.say(Stage::Finishing, Subject::Order, request);
    }

    fn reset(&mut self) {
        self.number = 0;
        self.exchanges.push(Exchange {
            stage: Stage::Finishing,
            subject: Subject::Order,
            request: Vec::new(),
            answer: Answer {
                head: Vec::new(),
                says: 0,
                tail: Vec::new(),
                sum: false,
            },
        });
    }

    fn write(&mut self, stage: Stage, address: u32, page: &[u8]) {
        self.load(stage, address);
        let [high, low] = (page.len() as u16).to_be_bytes();
        let head = match self.protocol {
            Protocol::V1 => &[v1::PROGRAM_PAGE, high, low, v1::FLASH][..],
            // How it is programmed is the boot loader's matter: the seven bytes are of other programmers.
            Protocol::V2 => &[v2::PROGRAM_FLASH, high, low, 0, 0, 0, 0, 0, 0, 0],
        };
        let request = [head, page].concat();
        self.say(stage, Subject::Order, &request);
    }

    fn compare(&mut self, stage: Stage, address: u32, page: &[u8]) {
        self.load(stage, address);
        let [high, low] = (page.len() as u16).to_be_bytes();
        let request = match self.protocol {
            Protocol::V1 => [v1::READ_PAGE, high, low, v1::FLASH],
            Protocol::V2 => [v2::READ_FLASH, high, low, 0],
        };
        self.say(stage, Subject::Flash(address, page.to_vec()), &request);
    }

    /// Addresses of flash are counted in words.
    fn load(&mut self, stage: Stage, address: u32) {
        let [a, b, c, d] = (address / 2).to_be_bytes();
        let request = match self.protocol {
            Protocol::V1 => &[v1::LOAD_ADDRESS, d, c][..],
            Protocol::V2 => &[v2::LOAD_ADDRESS, a, b, c, d],
        };
        self.say(stage, Subject::Order, request);
    }
}
