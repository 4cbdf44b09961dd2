//! A program that comes over Modbus, through the loader that reads the card: twice, as from there.

use super::{Command, Panel, Server};
use crate::board::Board;
use crate::board::eeprom::Eeprom;
use crate::engine::Data;
use crate::engine::memory::Memory;
use crate::instructions;
use crate::server::AT_ONCE;
use crate::store;
use core::mem;
use unoclp_core::{Cause, Crc16, Fault, Loader, Profile};
use unoclp_modbus::Exception;

/// An upload that is under way.
pub struct Upload<'m> {
    loader: Loader<'m>,
    /// The number of the last block, before the first none.
    last: Option<u8>,
    /// The check sum of the text so far, and of all of it when it came for the first time.
    sum: Crc16,
    first: Option<Crc16>,
    /// How many bytes of text the block in the frame has, which is still to be loaded.
    block: Option<u8>,
}

/// Where the text of a block stands in the frame: behind the head of function 16, and the block's own.
const TEXT: usize = 9;

/// Takes a program into program memory, or leaves there what there is; the panel has the outcome. Run memory is
/// overwritten either way.
#[inline(never)]
pub fn receive(board: &Board, server: &mut Server, memory: &mut [u8], data: &mut Data) {
    while server.panel.takes(Command::Upload) {
        server.panel.uploading = true;
        server.panel.fault = None;
        let mut upload = Upload {
            loader: loader(memory),
            last: None,
            sum: Crc16::default(),
            first: None,
            block: None,
        };
        while server.panel.uploading && server.panel.command.is_none() {
            server.step(board, Memory::idle(data), Some(&mut upload), AT_ONCE);
            // Here and not in the step: the loader goes deep, and the stack has no room for both.
            if let Some(count) = upload.block.take() {
                let text = server.frame.get(TEXT..TEXT + usize::from(count));
                let panel = &mut server.panel;
                if !upload.load(board, panel, text.unwrap_or_default()) {
                    server.refuse(board, Exception::ServerDeviceFailure);
                }
            }
        }
        server.panel.uploading = false;
    }
}

fn loader(memory: &mut [u8]) -> Loader<'_> {
    Loader::with_table(memory, Profile::UNO, instructions::read)
}

impl Upload<'_> {
    /// Takes a block: its number, how many bytes of text it holds, the text. It is loaded later.
    #[inline(never)]
    pub fn take(&mut self, block: &[u8]) -> Result<(), Exception> {
        let [number, count, rest @ ..] = block else {
            return Err(Exception::IllegalDataValue);
        };
        let padding = rest.len().wrapping_sub((*count).into());
        if padding > 1 {
            return Err(Exception::IllegalDataValue);
        }
        if self.last == Some(*number) {
            // The last one again: its answer was lost.
            return Ok(());
        }
        if *number != self.last.map_or(0, |last| last.wrapping_add(1)) {
            return Err(Exception::IllegalDataValue);
        }
        self.last = Some(*number);
        self.block = Some(*count);
        Ok(())
    }

    /// Loads the text of a block; says whether all is well so far.
    #[inline(never)]
    fn load(&mut self, board: &Board, panel: &mut Panel, text: &[u8]) -> bool {
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
            panel.uploading = false;
            self.conclude(&board.eeprom, &mut panel.fault);
        }
        panel.fault.is_none()
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
