//! A program that comes over Modbus, through the loader that reads the card: twice, as from there.

use super::{Command, Memory, Panel, Server};
use crate::board::Board;
use crate::engine::{self, Data};
use crate::server::AT_ONCE;
use crate::store;
use unoclp_core::{Cause, Crc16, Fault, Loader, Profile};
use unoclp_modbus::Exception;

/// An upload that is under way.
pub struct Upload<'m> {
    loader: Loader<'m>,
    /// The number of the next block.
    next: u8,
    /// The check sum of what came the first time, once all of it has.
    first: Option<Crc16>,
}

/// Takes a program into program memory, or leaves there what there is; the panel has the outcome. Run memory is
/// overwritten either way.
#[inline(never)]
pub fn receive(board: &Board, server: &mut Server<'_>, memory: &mut [u8], data: &mut Data) {
    while server.panel.takes(Command::Upload) {
        server.panel.uploading = true;
        server.panel.fault = None;
        let mut upload = Upload {
            loader: loader(memory),
            next: 0,
            first: None,
        };
        while server.panel.uploading && server.panel.command.is_none() {
            server.step(board, Memory::idle(data), Some(&mut upload), AT_ONCE);
        }
        server.panel.uploading = false;
    }
}

fn loader(memory: &mut [u8]) -> Loader<'_> {
    Loader::with_table(memory, Profile::UNO, engine::instruction_table)
}

impl Upload<'_> {
    /// Takes a block: its number, how many bytes of text it holds, the text.
    #[inline(never)]
    pub fn take(
        &mut self,
        board: &Board,
        panel: &mut Panel,
        block: &[u8],
    ) -> Result<(), Exception> {
        let [number, count, rest @ ..] = block else {
            return Err(Exception::IllegalDataValue);
        };
        let Some(text) = rest.get(..usize::from(*count)) else {
            return Err(Exception::IllegalDataValue);
        };
        if rest.len() - text.len() > 1 {
            return Err(Exception::IllegalDataValue);
        }
        if *number == self.next.wrapping_sub(1) {
            // The last one again: its answer was lost.
            return Ok(());
        }
        if *number != self.next {
            return Err(Exception::IllegalDataValue);
        }
        self.next = self.next.wrapping_add(1);
        board.pins.led(number & 1 == 0);
        let taken = if text.is_empty() {
            self.end(board, panel)
        } else {
            text.iter().try_for_each(|&byte| self.loader.push(byte))
        };
        taken.map_err(|fault| {
            panel.fault = Some(fault);
            panel.uploading = false;
            Exception::ServerDeviceFailure
        })
    }

    /// All of the text has come, once or twice.
    #[inline(never)]
    fn end(&mut self, board: &Board, panel: &mut Panel) -> Result<(), Fault> {
        let program = self.loader.finish()?;
        let sum = Crc16::of(program.stored());
        let Some(first) = self.first else {
            self.first = Some(sum);
            self.loader = loader(program.into_memory());
            return Ok(());
        };
        if sum != first {
            return Err(Fault::without_line(Cause::FileChanged));
        }
        store::save(&board.eeprom, program.stored()).map_err(Fault::without_line)?;
        panel.uploading = false;
        Ok(())
    }
}
