//! What is said to a boot loader, from the first question to the last.
//!
//! The first page is written last. Until then a stall stands in its place: a chip whose flash was written in part
//! waits with its pins off, rather than run into the middle of a program.

use crate::image::Image;
use crate::model::{PAGE, SIGNATURE};
use crate::stage::Stage;

/// Bytes of STK500v1 (Atmel's AVR061, section 7).
pub(crate) const IN_SYNC: u8 = 0x14;
pub(crate) const OK: u8 = 0x10;
const END: u8 = b' ';
const GET_SYNC: u8 = b'0';
const ENTER_PROGRAMMING: u8 = b'P';
const LEAVE_PROGRAMMING: u8 = b'Q';
const LOAD_ADDRESS: u8 = b'U';
const PROGRAM_PAGE: u8 = b'd';
const READ_PAGE: u8 = b't';
const READ_SIGNATURE: u8 = b'u';
const FLASH: u8 = b'F';

/// `nop` and `rjmp .-4`, for ever: a jump to itself alone is what simulators take for a crash.
const STALL: [u8; 4] = [0x00, 0x00, 0xFE, 0xCF];

/// A request and the answer to it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Exchange {
    pub stage: Stage,
    pub request: Vec<u8>,
    /// What stands in the answer, between [`IN_SYNC`] and [`OK`].
    pub answer: Vec<u8>,
    /// The page that it is about.
    pub address: u16,
}

/// The question whether a boot loader is there.
pub(crate) const SYNC: [u8; 2] = [GET_SYNC, END];
/// The answer to it.
pub(crate) const SYNCED: [u8; 2] = [IN_SYNC, OK];

/// All that is said once the boot loader has answered.
pub(crate) fn script(image: &Image) -> Vec<Exchange> {
    let mut script = Script(Vec::new());
    script.say(Stage::Meeting, 0, &[READ_SIGNATURE], &SIGNATURE);
    script.say(Stage::Meeting, 0, &[ENTER_PROGRAMMING], &[]);
    let mut stall = vec![0xFF; PAGE];
    stall[..STALL.len()].copy_from_slice(&STALL);
    script.write(Stage::Writing, 0, &stall);
    script.compare(Stage::Writing, 0, &stall);
    for (address, page) in image.pages().skip(1) {
        script.write(Stage::Writing, address, &page);
    }
    for (address, page) in image.pages().skip(1) {
        script.compare(Stage::Comparing, address, &page);
    }
    for (address, page) in image.pages().take(1) {
        script.write(Stage::Finishing, address, &page);
        script.compare(Stage::Finishing, address, &page);
    }
    script.say(Stage::Finishing, 0, &[LEAVE_PROGRAMMING], &[]);
    script.0
}

struct Script(Vec<Exchange>);

impl Script {
    fn say(&mut self, stage: Stage, address: u16, request: &[u8], answer: &[u8]) {
        self.0.push(Exchange {
            stage,
            request: [request, &[END]].concat(),
            answer: answer.to_vec(),
            address,
        });
    }

    fn write(&mut self, stage: Stage, address: u16, page: &[u8]) {
        self.load(stage, address);
        let head = [PROGRAM_PAGE, 0, PAGE as u8, FLASH];
        self.say(stage, address, &[&head[..], page].concat(), &[]);
    }

    fn compare(&mut self, stage: Stage, address: u16, page: &[u8]) {
        self.load(stage, address);
        self.say(stage, address, &[READ_PAGE, 0, PAGE as u8, FLASH], page);
    }

    /// Addresses of flash are counted in words.
    fn load(&mut self, stage: Stage, address: u16) {
        let [low, high] = (address / 2).to_le_bytes();
        self.say(stage, address, &[LOAD_ADDRESS, low, high], &[]);
    }
}
