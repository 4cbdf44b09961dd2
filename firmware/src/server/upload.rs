//! A program that comes over Modbus, through the loader that reads the card: twice, as from there.

use crate::board::Board;
use crate::board::clock::Deadline;
use crate::board::eeprom::Eeprom;
use crate::instructions::Uno;
use crate::operation::Operation;
use crate::store;
use core::mem;
use unoclp_core::{Cause, Crc16, Fault, Loader};
use unoclp_modbus::Exception;

/// ms without a block that end an upload.
const PATIENCE: u16 = 10_000;

/// An upload that is under way.
// In this order: what lies beyond 63 bytes is reached by detours.
#[repr(C)]
pub struct Upload<'m> {
    /// The number of the last block, before the first none.
    last: Option<u8>,
    /// The checksum of its text.
    last_sum: Crc16,
    /// When the client is taken to have left.
    until: Deadline,
    /// The checksum of the text so far, and of all of it when it came for the first time.
    sum: Crc16,
    first: Option<Crc16>,
    /// How many bytes of text the block in the frame has, which is still to be loaded.
    block: Option<u8>,
    loader: Loader<'m, Uno>,
}

impl<'m> Upload<'m> {
    /// Before its first block, with this memory.
    pub fn new(memory: &'m mut [u8]) -> Upload<'m> {
        Upload {
            last: None,
            last_sum: Crc16::default(),
            until: Deadline::after(PATIENCE),
            sum: Crc16::default(),
            first: None,
            block: None,
            loader: Loader::new(memory, Uno),
        }
    }

    /// Whether no block has come for a long time.
    pub fn is_forsaken(&self) -> bool {
        self.until.has_passed()
    }

    /// The number of the last block.
    pub fn last(&self) -> Option<u8> {
        self.last
    }

    /// How many bytes of text there are to be [loaded](Upload::load), if a block has come.
    pub fn comes(&mut self) -> Option<u8> {
        self.block.take()
    }

    /// Takes a block: its number, how many bytes of text it holds, the text. It is loaded later.
    ///
    /// The last one again is taken for a repetition whose answer was lost. With another text it is another
    /// client's, and the upload is over.
    #[inline(never)]
    pub fn take(&mut self, block: &[u8], operation: &mut Operation) -> Result<(), Exception> {
        let [number, count, rest @ ..] = block else {
            return Err(Exception::IllegalDataValue);
        };
        let padding = rest.len().wrapping_sub((*count).into());
        if padding > 1 {
            return Err(Exception::IllegalDataValue);
        }
        let sum = Crc16::of(rest.get(..usize::from(*count)).unwrap_or_default());
        if self.last == Some(*number) {
            if sum == self.last_sum {
                return Ok(());
            }
            operation.uploading = false;
            operation.fault = Some(Fault::without_line(Cause::FileChanged));
            return Err(Exception::ServerDeviceFailure);
        }
        if *number != self.last.map_or(0, |last| last.wrapping_add(1)) {
            return Err(Exception::IllegalDataValue);
        }
        self.until = Deadline::after(PATIENCE);
        self.last = Some(*number);
        self.last_sum = sum;
        self.block = Some(*count);
        Ok(())
    }

    /// Loads the text of a block; says whether all is well so far.
    #[inline(never)]
    pub fn load(&mut self, board: &Board, operation: &mut Operation, text: &[u8]) -> bool {
        board.pins.led(self.last.is_some_and(|last| last & 1 == 0));
        self.sum.extend(text);
        let again = self.first.is_some();
        let over = if !text.is_empty() {
            !again && text.iter().any(|&byte| self.loader.push(byte).is_err())
        } else if again {
            true
        } else {
            self.first = Some(mem::take(&mut self.sum));
            self.loader.end().is_err()
        };
        if over {
            operation.uploading = false;
            self.conclude(&board.eeprom, &mut operation.fault);
        }
        operation.fault.is_none()
    }

    /// All of the text has come twice, or it has a fault: stores the program, or says what is wrong.
    #[inline(never)]
    fn conclude(&mut self, eeprom: &Eeprom, fault: &mut Option<Fault>) {
        *fault = match self.loader.finish() {
            Ok(_) if self.first != Some(self.sum) => Some(Fault::without_line(Cause::FileChanged)),
            Ok(program) => store::save(eeprom, program.stored())
                .err()
                .map(Fault::without_line),
            Err(fault) => Some(fault),
        };
    }
}
