//! The Modbus server: a slice of a request between two scans, and what it may see and change.
//!
//! Owns the way of a request from the serial port and back (`docs/modbus.md`); must not know how bytes are
//! moved, or what a program is. [`map`] says what an address stands for, [`upload`] takes a program.

#[cfg(mega)]
mod lines;
mod map;
#[cfg(mega)]
mod turns;
mod upload;

/// The line whose turn it is.
#[cfg(not(mega))]
macro_rules! line {
    ($server:ident, $board:ident) => {
        $board.serial
    };
}
#[cfg(mega)]
macro_rules! line {
    ($server:ident, $board:ident) => {
        $server.lines.now($board)
    };
}

use crate::board::{Board, clock};
use crate::engine::Data;
use crate::engine::memory::Memory;
use crate::operation::{Command, Operation};
use crate::settings::Settings;
use map::Map;
use unoclp_modbus::{Exception, Exchange, Frame, lock, refuse};
use upload::Upload;

/// Where the text of a block of an upload stands in the frame: after the head of function 16, and the
/// block's own.
const TEXT: usize = 9;

/// The server.
pub struct Server {
    frame: &'static mut Frame,
    /// The last request, and whether it is being done.
    exchange: Exchange,
    fills: bool,
    /// How many seconds ago the last one came.
    pub silence: u8,
    /// The settings that are kept.
    settings: &'static mut Settings,
    /// See [`Map::ended`].
    ended: Option<u8>,
    /// The two lines, of which each has its turn.
    #[cfg(mega)]
    lines: lines::Lines,
}

impl Server {
    /// A server with this memory for its frames, before the first scan.
    // Apart from who makes it, whose frame is large.
    #[cfg(not(mega))]
    pub fn new(frame: &'static mut Frame, settings: &'static mut Settings) -> Server {
        Server {
            frame,
            exchange: Exchange::default(),
            fills: false,
            silence: 0,
            settings,
            ended: None,
        }
    }

    /// From now on the serial port serves.
    #[cfg(not(mega))]
    pub fn start(&mut self, board: &Board) {
        board.serial.serve(&mut self.frame);
    }

    /// Answers the request that is being done by an exception.
    fn refuse(&mut self, board: &Board, exception: Exception) {
        self.fills = false;
        let length = refuse(self.frame, exception);
        line!(self, board).send(self.frame, length);
    }

    /// Does at most one thing: takes a request that has come, or does a slice of it, or answers. Where an
    /// upload is in progress it comes along.
    #[inline(never)]
    pub fn step(
        &mut self,
        board: &Board,
        operation: &mut Operation,
        memory: &mut Memory<'_>,
        upload: Option<&mut Upload<'_>>,
    ) {
        #[cfg(mega)]
        self.turn(board);
        let mut length = 0;
        if !self.fills {
            // Nearly always there is nothing to do.
            let Some(received) = line!(self, board).received() else {
                return;
            };
            length = received;
        }
        let mut map = Map {
            board,
            operation,
            settings: self.settings,
            now: clock::now(),
            memory,
            upload,
            ended: self.ended,
            #[cfg(mega)]
            forced: self.lines.forced(),
        };
        let answered = if self.fills {
            self.exchange.fill(self.frame, &mut map)
        } else {
            self.silence = 0;
            if lock::refuses(self.frame, map.settings.locks()) {
                return self.refuse(board, Exception::IllegalFunction);
            }
            self.exchange.begin(self.frame, length, &mut map)
        };
        self.fills = answered.is_none();
        let Some(length) = answered else {
            return;
        };
        line!(self, board).send(self.frame, length);
        if operation.command == Some(Command::Restart) {
            board.restart();
        }
    }

    /// Takes a program into program memory, if an upload was commanded, or leaves there what there is; operation
    /// has the outcome. Run memory is overwritten either way.
    #[inline(never)]
    pub fn receive(
        &mut self,
        board: &Board,
        operation: &mut Operation,
        memory: &mut [u8],
        data: &mut Data,
    ) {
        if !operation.takes(Command::Upload) {
            return;
        }
        operation.uploading = true;
        operation.fault = None;
        let mut upload = Upload::new(memory);
        while operation.uploading && operation.command.is_none() && !upload.is_forsaken() {
            let idle = &mut Memory::idle(data);
            self.step(board, operation, idle, Some(&mut upload));
            // Here and not in the step: the loader goes deep, and the stack has no room for both.
            if let Some(count) = upload.comes() {
                let text = self.frame.get(TEXT..TEXT + usize::from(count));
                if !upload.load(board, operation, text.unwrap_or_default()) {
                    self.refuse(board, Exception::ServerDeviceFailure);
                }
            }
        }
        let is_stored = !operation.uploading && operation.fault.is_none();
        self.ended = upload.last().filter(|_| is_stored);
        operation.uploading = false;
    }
}
