//! The server of a board with two lines: USB for tools, and a bus. They take turns, a step each.
//!
//! Owns whose turn it is; must not know what a request asks for.

use super::Server;
use super::lines::{Lines, Port};
use crate::board::Board;
use crate::settings::Settings;
use core::mem;
use unoclp_modbus::{Exchange, Frame};

impl Server {
    /// A server with this memory for its frames, before the first scan.
    pub fn new(
        [frame, of_bus]: [&'static mut Frame; 2],
        settings: &'static mut Settings,
    ) -> Server {
        Server {
            frame,
            exchange: Exchange::default(),
            fills: false,
            silence: 0,
            settings,
            ended: None,
            lines: Lines {
                now: Port::Usb,
                frame: of_bus,
                exchange: Exchange::default(),
                fills: false,
                silence: 0,
                forced: Port::Usb,
            },
        }
    }

    /// From now on the serial ports serve.
    pub fn start(&mut self, board: &Board) {
        board.serial.serve(&mut self.frame);
        board.bus.serve(&mut self.lines.frame);
    }

    /// The other line has its turn, unless it is quiet or has its answer.
    #[inline(never)]
    pub(super) fn turn(&mut self, board: &Board) {
        let lines = &mut self.lines;
        let (other, rests) = match lines.now {
            Port::Usb => (Port::Bus, board.bus.is_quiet() || board.bus.is_sending()),
            Port::Bus => (
                Port::Usb,
                board.serial.is_quiet() || board.serial.is_sending(),
            ),
        };
        if rests {
            return;
        }
        lines.now = other;
        mem::swap(&mut self.frame, &mut lines.frame);
        mem::swap(&mut self.exchange, &mut lines.exchange);
        mem::swap(&mut self.fills, &mut lines.fills);
        mem::swap(&mut self.silence, &mut lines.silence);
    }

    /// For how many seconds the line that has forced has not asked, before the second that is over now; the other one's
    /// goes on by itself.
    pub fn silence(&mut self) -> &mut u8 {
        let Server { silence, lines, .. } = self;
        let (of, other) = match lines.now == lines.forced {
            true => (silence, &mut lines.silence),
            false => (&mut lines.silence, silence),
        };
        *other = other.saturating_add(1);
        of
    }
}
