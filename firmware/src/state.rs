//! `STATE.TXT`: inputs, outputs, uptime and scan times, kept on the card.
//!
//! Owns what the file says and when it is written; must not know how. Its first block is rewritten
//! in place: at once when an input or output has changed, but at most once a second; else every
//! minute; and never again once the card has failed.

use crate::board::Board;
use crate::board::clock;
use crate::board::flash::{Codes, FlashText, flash_codes};
use crate::card::writer::{Progress, Writer};
use crate::card::{CardFailed, Place};
use crate::decimal::{DIGITS, decimal};
use crate::operation::{Images, Operation, ScanTimes, State};
use unoclp_core::Image;

/// The text, with a mark for each digit of a value; what follows is blanks, and a line end.
const TEMPLATE: &str = include_str!("../../programs/STATE.TXT").trim_ascii_end();
const MARK: u8 = b'#';
const LINE_END: u16 = 510;
/// Which value is the uptime.
const UPTIME: u8 = 8;

/// The least time between two writings, and the most, ms.
const SOONEST: u16 = 1_000;
const LATEST: u16 = 60_000;
const SECOND: u16 = 1_000;

/// Keeps the file up to date.
pub struct Keeper {
    /// None where the card has no such file, or has failed.
    writer: Option<Writer>,
    text: Text,
    /// When the last writing began; none before the first. ms, wrapping.
    written: Option<u16>,
    /// s, in decimal.
    uptime: [u8; DIGITS],
    /// When the second began that is under way, ms, wrapping.
    second: u16,
}

impl Keeper {
    /// The state kept at this place, or nowhere.
    #[inline(never)]
    pub fn new(place: Option<Place>) -> Keeper {
        let mut uptime = [b' '; DIGITS];
        uptime[DIGITS - 1] = b'0';
        Keeper {
            writer: place.map(Writer::new),
            text: Text::default(),
            written: None,
            uptime,
            second: 0,
        }
    }

    /// Whether a block is on its way to the card.
    pub fn is_sending(&self) -> bool {
        self.writer.as_ref().is_some_and(Writer::is_sending)
    }

    /// One step, to be called between scans in RUN or STOP. It takes 0.1 ms at most, and never waits for
    /// the card.
    #[inline(never)]
    pub fn step(&mut self, board: &Board, operation: &mut Operation) {
        if self.advance(board, operation).is_err() {
            board.release_card();
            self.writer = None;
            operation.card_failed = true;
        }
    }

    fn advance(&mut self, board: &Board, operation: &Operation) -> Result<(), CardFailed> {
        let Some(writer) = &mut self.writer else {
            return Ok(());
        };
        // Compared with moments of the last minute only: 16 bits tell them apart.
        let now = clock::now() as u16;
        if now.wrapping_sub(self.second) >= SECOND {
            self.second = self.second.wrapping_add(SECOND);
            count(&mut self.uptime);
        }
        let text = &mut self.text;
        if writer.step(board, now, |at| text.byte(at))? == Progress::Going {
            return Ok(());
        }
        // Outputs as their pins are.
        let mut images = operation.images;
        images.set_outputs(match operation.state {
            State::Run => operation.outputs(),
            State::Stop | State::Fault => Image::default(),
        });
        let due = match self.written {
            None => true,
            Some(written) => {
                let least = if images == text.images {
                    LATEST
                } else {
                    SOONEST
                };
                now.wrapping_sub(written) >= least
            }
        };
        if due {
            self.written = Some(now);
            text.begin(images, &operation.times, &self.uptime);
            writer.begin(board)?;
        }
        Ok(())
    }
}

/// Counts on by one.
fn count(number: &mut [u8; DIGITS]) {
    for digit in number.iter_mut().rev() {
        match *digit {
            b'9' => *digit = b'0',
            b' ' => {
                *digit = b'1';
                break;
            }
            _ => {
                *digit += 1;
                break;
            }
        }
    }
}

/// The text of one writing: its values, and how far it has gone.
#[derive(Default)]
struct Text {
    /// What is left of the template.
    template: FlashText,
    images: Images,
    times: ScanTimes,
    /// The value that is next.
    value: u8,
    /// The digits of the value before it, and the one that is next; past the last when all have gone.
    /// The uptime, which comes before the other numbers, stands here from the beginning.
    digits: [u8; DIGITS],
    next: u8,
}

impl Text {
    fn begin(&mut self, images: Images, times: &ScanTimes, uptime: &[u8; DIGITS]) {
        self.template = flash_codes!(Codes::plain(TEMPLATE));
        self.images = images;
        self.times = *times;
        self.value = 0;
        self.digits = *uptime;
        self.next = DIGITS as u8;
    }

    /// The byte at this place of the block, 0 to 511; asked in order.
    #[inline(never)]
    fn byte(&mut self, at: u16) -> u8 {
        match self.template.next() {
            Some(MARK) => self.digit(),
            Some(byte) => byte,
            None if at < LINE_END => b' ',
            None if at == LINE_END => b'\r',
            None => b'\n',
        }
    }

    /// The digit that takes the place of the next mark.
    fn digit(&mut self) -> u8 {
        if self.next == DIGITS as u8 {
            let value = self.value;
            self.value += 1;
            let time = match value {
                // Four inputs, then four outputs.
                0..8 => {
                    return b'0' + (self.images.points >> value & 1);
                }
                UPTIME => 0,
                9 => self.times.last(),
                10 => self.times.least(),
                _ => self.times.most(),
            };
            if value == UPTIME {
                self.next = 0;
            } else {
                decimal(time.into(), &mut self.digits);
                self.next = DIGITS as u8 - 5;
            }
        }
        let digit = self.digits.get(usize::from(self.next));
        self.next += 1;
        digit.copied().unwrap_or(b' ')
    }
}
