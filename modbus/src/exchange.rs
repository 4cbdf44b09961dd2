//! A request that is done in slices.

use crate::frame::{FIXED, Frame, operands, refuse, word};
use crate::{Device, Exception, Table};

/// A valid request that is being done.
#[derive(Debug, PartialEq, Eq)]
pub struct Exchange {
    pub(crate) task: Task,
    /// The next address, and how many there are from it on.
    pub(crate) address: u16,
    pub(crate) left: u16,
    /// Where they stand in the frame.
    pub(crate) at: u8,
}

/// What is done with each of the addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Task {
    ReadBits(Table),
    ReadWords(Table),
    WriteBits,
    /// [`Task::WriteWords`] follows.
    CheckWords,
    WriteWords,
}

impl Exchange {
    /// Does the next slice: at most `most` words, or `most` bytes of 8 bits each. `Some` once all is done:
    /// the length of the reply in the frame, or 0 where nothing is to be sent. It is not called again then.
    ///
    /// Nobody else may change the frame in between. An exchange may be dropped at any time; what it has
    /// written stays.
    ///
    /// A slice of words ends before an even address, so that no value of two words is torn. It may
    /// therefore be a word shorter than `most`, and is of two words where `most` is less.
    ///
    /// A write of words is checked as a whole, in slices; the call that checks the last of them writes
    /// the first slice too. So a call checks at most `most` words and writes at most as many, and what
    /// fits one slice is checked and written without a scan in between. A longer write takes effect over
    /// several scans.
    #[inline(never)]
    pub fn fill<D: Device>(&mut self, frame: &mut Frame, device: &mut D, most: u8) -> Option<u8> {
        let mut units = self.slice(most);
        let length = loop {
            if self.left == 0 {
                match self.task {
                    Task::ReadBits(_) | Task::ReadWords(_) => break self.at,
                    Task::CheckWords => self.check_is_done(frame),
                    // The reply to a write is what it began with: function, first address, quantity.
                    Task::WriteBits => break FIXED,
                    Task::WriteWords => {
                        device.words_are_set();
                        break FIXED;
                    }
                }
                units = self.slice(most);
            }
            if units == 0 {
                return None;
            }
            units = units.wrapping_sub(1);
            if let Err(exception) = self.step(frame, device) {
                break refuse(frame, exception);
            }
        };
        let broadcast = frame[0] == 0;
        Some(if broadcast { 0 } else { length })
    }

    /// Back to the first word, to write now.
    fn check_is_done(&mut self, frame: &Frame) {
        (self.left, self.at) = operands(frame);
        self.address = word(frame, 2);
        self.task = Task::WriteWords;
    }

    /// How many words or bytes of bits the next slice may have.
    fn slice(&self, most: u8) -> u8 {
        match self.task {
            Task::ReadBits(_) | Task::WriteBits => most.max(1),
            _ => {
                let most = most.max(2);
                // One less where it would end between the words of a pair.
                most.wrapping_sub((self.address as u8).wrapping_add(most) & 1)
            }
        }
    }

    /// Does one word, or 8 bits. There is one left.
    fn step<D: Device>(&mut self, frame: &mut Frame, device: &mut D) -> Result<(), Exception> {
        let at = usize::from(self.at);
        let low = usize::from(self.at.wrapping_add(1));
        match self.task {
            Task::ReadBits(_) | Task::WriteBits => {
                let mut bits = match self.task {
                    Task::ReadBits(_) => 0,
                    _ => frame[at],
                };
                let mut bit = 1;
                while bit != 0 && self.left != 0 {
                    if let Task::ReadBits(table) = self.task {
                        if device.bit(table, self.address) {
                            bits |= bit;
                        }
                    } else {
                        device.set_bit(self.address, bits & bit != 0);
                    }
                    bit <<= 1;
                    self.advance();
                }
                frame[at] = bits;
                self.at = self.at.wrapping_add(1);
                return Ok(());
            }
            Task::ReadWords(table) => {
                let word = device.word(table, self.address);
                frame[at] = (word >> 8) as u8;
                frame[low] = word as u8;
            }
            Task::CheckWords => device.check_word(self.address, word(frame, self.at))?,
            Task::WriteWords => device.set_word(self.address, word(frame, self.at)),
        }
        self.at = self.at.wrapping_add(2);
        self.advance();
        Ok(())
    }

    /// To the next address; behind 65535 none is left.
    fn advance(&mut self) {
        self.address = self.address.wrapping_add(1);
        self.left = self.left.wrapping_sub(1);
    }
}
