//! A boot loader in memory, as Optiboot does it, and the line to it.

use std::time::Duration;
use unoclp_boot::{Failure, Image, Model, Next, Progress, Writer};

/// A firmware file with the vectors of the chip, and `size` bytes in all, at least 106.
pub fn hex(size: usize) -> Vec<u8> {
    hex_of(Model::Uno, size)
}

/// The same for the chip of this board; for a Mega at least 230 bytes.
pub fn hex_of(model: Model, size: usize) -> Vec<u8> {
    let vectors = if model == Model::Mega { 57 } else { 26 };
    let mut bytes: Vec<u8> = [0x0C, 0x94, 0x34, 0x00].repeat(vectors);
    bytes.extend([0xFF, 0xCF]);
    bytes.extend((bytes.len()..size).map(|at| (at * 7 + at / 256) as u8));
    encode(&bytes)
}

/// Bytes from address 0 on, as a file.
pub fn encode(bytes: &[u8]) -> Vec<u8> {
    let mut file = String::new();
    for (index, chunk) in bytes.chunks(16).enumerate() {
        let at = index * 16;
        if at > 0 && at.is_multiple_of(0x1_0000) {
            file += &record(&[2, 0, 0, 4, 0, (at >> 16) as u8]);
        }
        let [high, low] = ((index * 16) as u16).to_be_bytes();
        file += &record(&[&[chunk.len() as u8, high, low, 0], chunk].concat());
    }
    (file + ":00000001FF\r\n").into_bytes()
}

/// A record with its checksum.
pub fn record(bytes: &[u8]) -> String {
    let sum = bytes.iter().fold(0_u8, |sum, byte| sum.wrapping_sub(*byte));
    let digits = bytes.iter().chain([&sum]);
    let digits: String = digits.map(|byte| format!("{byte:02X}")).collect();
    format!(":{digits}\r\n")
}

pub fn image(size: usize) -> Image {
    image_of(Model::Uno, size)
}

pub fn image_of(model: Model, size: usize) -> Image {
    Image::read(&hex_of(model, size), model).expect("a firmware")
}

/// What becomes of a byte on its way.
pub enum Fate {
    Passes,
    Changes(u8),
    Drops,
}

/// Which way a byte goes, and the how many-eth of that way it is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Way {
    Out(usize),
    In(usize),
}

/// A chip with a boot loader.
pub struct Chip {
    pub flash: Vec<u8>,
    pub signature: [u8; 3],
    /// It has been told to start the firmware.
    pub started: bool,
    /// How often it was reset.
    pub resets: u32,
    /// The boot loader listens.
    listens: bool,
    address: usize,
    came: Vec<u8>,
    /// A bit at this address is stuck at 0.
    pub stuck: Option<usize>,
    /// Its boot loader speaks STK500v2; the page that it erases next, and the number of the next message.
    second: Option<(usize, u8)>,
}

impl Chip {
    /// That of a Mega.
    pub fn mega() -> Chip {
        Chip {
            flash: vec![0xA5; 0x4_0000],
            signature: [0x1E, 0x98, 0x01],
            second: Some((0, 1)),
            ..Chip::new()
        }
    }

    pub fn new() -> Chip {
        Chip {
            flash: vec![0xA5; 0x8000],
            signature: [0x1E, 0x95, 0x0F],
            started: false,
            resets: 0,
            listens: false,
            address: 0,
            came: Vec::new(),
            stuck: None,
            second: None,
        }
    }

    fn reset(&mut self) {
        self.resets += 1;
        self.listens = true;
        self.came.clear();
        self.second = self.second.map(|_| (0, 1));
    }

    /// Takes a byte, and gives what it answers.
    fn take(&mut self, byte: u8) -> Vec<u8> {
        if !self.listens {
            return Vec::new();
        }
        self.came.push(byte);
        if self.second.is_some() {
            return self.take_message();
        }
        let operands = match self.came[0] {
            b'U' => 2,
            b'd' => match self.came[..] {
                [_, high, low, ..] => 3 + usize::from(u16::from_be_bytes([high, low])),
                _ => 3,
            },
            b't' => 3,
            _ => 0,
        };
        if self.came.len() < operands + 2 {
            return Vec::new();
        }
        let request = std::mem::take(&mut self.came);
        if request.last() != Some(&b' ') {
            // Its watchdog starts the firmware.
            self.listens = false;
            return Vec::new();
        }
        let operands = &request[1..=operands];
        let data = match (request[0], operands) {
            (b'u', _) => self.signature.to_vec(),
            (b'U', &[low, high]) => {
                self.address = 2 * usize::from(u16::from_le_bytes([low, high]));
                Vec::new()
            }
            (b'd', [_, _, _, page @ ..]) => {
                for (at, byte) in (self.address..).zip(page) {
                    if let Some(cell) = self.flash.get_mut(at) {
                        *cell = *byte & if self.stuck == Some(at) { 0x7F } else { 0xFF };
                    }
                }
                Vec::new()
            }
            (b't', &[high, low, _]) => {
                let count = usize::from(u16::from_be_bytes([high, low]));
                let cells = self.flash.iter().cycle().skip(self.address);
                cells.take(count).copied().collect()
            }
            (b'Q', _) => {
                self.started = true;
                self.listens = false;
                Vec::new()
            }
            _ => Vec::new(),
        };
        [&[0x14][..], &data, &[0x10]].concat()
    }
}

/// As the Mega's boot loader does it.
impl Chip {
    fn take_message(&mut self) -> Vec<u8> {
        if self.came[0] != 0x1B {
            self.came.clear();
            return Vec::new();
        }
        let [_, number, high, low, token, ..] = self.came[..] else {
            return Vec::new();
        };
        let size = usize::from(u16::from_be_bytes([high, low]));
        let Some((_, next)) = self.second else {
            return Vec::new();
        };
        if token != 0x0E || !(1..=285).contains(&size) || !(number == 1 || number == next) {
            self.came.clear();
            return Vec::new();
        }
        if self.came.len() < size + 6 {
            return Vec::new();
        }
        let message = std::mem::take(&mut self.came);
        if message.iter().fold(0, |sum, byte| sum ^ byte) != 0 {
            return Vec::new();
        }
        let body = self.answer(&message[5..size + 5]);
        if let Some((_, next)) = &mut self.second {
            *next = number.wrapping_add(1);
        }
        let [high, low] = (body.len() as u16).to_be_bytes();
        let mut answer = [&[0x1B, number, high, low, 0x0E][..], &body].concat();
        answer.push(answer.iter().fold(0, |sum, byte| sum ^ byte));
        answer
    }

    fn answer(&mut self, body: &[u8]) -> Vec<u8> {
        let command = body[0];
        match *body {
            [0x01] => b"\x01\x00\x08AVRISP_2".to_vec(),
            [0x06, a, b, c, d] => {
                self.address = 2 * u32::from_be_bytes([a, b, c, d]) as usize;
                vec![command, 0]
            }
            [0x11, ..] => {
                self.started = true;
                self.listens = false;
                vec![command, 0]
            }
            [0x13, high, low, _, _, _, _, _, _, _, ref page @ ..] => {
                let page = &page[..page.len().min(u16::from_be_bytes([high, low]).into())];
                // One page after the other, whichever is written.
                if let Some((erased, _)) = &mut self.second {
                    self.flash[*erased..*erased + 256].fill(0xFF);
                    *erased += 256;
                }
                for (cell, byte) in self.flash[self.address..].iter_mut().zip(page) {
                    *cell &= byte;
                }
                vec![command, 0]
            }
            [0x14, high, low, _] => {
                let count = usize::from(u16::from_be_bytes([high, low]));
                let read = &self.flash[self.address..][..count];
                [&[command, 0], read, &[0]].concat()
            }
            [0x1B, _, 0x30, _, index, _] => {
                vec![command, 0, self.signature[usize::from(index) % 3], 0]
            }
            _ => vec![command, 0],
        }
    }
}

/// The line to a chip.
pub struct Bench<F> {
    pub chip: Chip,
    pub fate: F,
    pub now: Duration,
    pub seen: Vec<Progress>,
    /// What answers where no boot loader listens.
    pub babble: &'static [u8],
    /// A reset does not reach the chip.
    pub no_reset: bool,
    out: usize,
    back: usize,
}

impl<F: FnMut(Way) -> Fate> Bench<F> {
    pub fn new(fate: F) -> Bench<F> {
        Bench {
            chip: Chip::new(),
            fate,
            now: Duration::from_secs(1_000),
            seen: Vec::new(),
            babble: &[],
            no_reset: false,
            out: 0,
            back: 0,
        }
    }

    /// Writes an image, from the first step to the end.
    pub fn write(&mut self, image: &Image) -> Result<(), Failure> {
        self.drive(Writer::new(image), |_| None)
    }

    /// The same; where `lose` gives a reason, the port goes.
    pub fn drive(
        &mut self,
        mut writer: Writer,
        mut lose: impl FnMut(&Writer) -> Option<String>,
    ) -> Result<(), Failure> {
        let mut came = Vec::new();
        loop {
            if let Some(why) = lose(&writer) {
                writer.lose(why);
            }
            let step = writer.step(self.now, &came);
            if step.reset && !self.no_reset {
                self.chip.reset();
            }
            came = self.carry(&step.send);
            self.seen.push(writer.progress());
            match step.next {
                Next::Done(outcome) => return outcome,
                Next::Wait(until) if came.is_empty() => self.now = self.now.max(until),
                Next::Wait(_) => self.now += Duration::from_millis(1),
            }
        }
    }

    fn carry(&mut self, send: &[u8]) -> Vec<u8> {
        let mut came = Vec::new();
        for &byte in send {
            self.out += 1;
            let byte = match (self.fate)(Way::Out(self.out)) {
                Fate::Passes => byte,
                Fate::Changes(bits) => byte ^ bits,
                Fate::Drops => continue,
            };
            let answer = self.chip.take(byte);
            let answer = match self.chip.listens || !answer.is_empty() {
                true => &answer,
                false => self.babble,
            };
            for &byte in answer {
                self.back += 1;
                match (self.fate)(Way::In(self.back)) {
                    Fate::Passes => came.push(byte),
                    Fate::Changes(bits) => came.push(byte ^ bits),
                    Fate::Drops => {}
                }
            }
        }
        came
    }
}
