//! The server of a board with two lines: USB for tools, and a bus. Each has a frame and a request of its own; they take
//! turns, a step each.
//!
//! Owns whose turn it is; must not know what a request asks for.

use super::Server;
use crate::board::{Board, bus, serial};
use crate::settings::Settings;
use core::mem;
use unoclp_modbus::{Exchange, Frame};

/// One of the lines.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Port {
    /// USB.
    Usb,
    /// The bus.
    Bus,
}

/// The lines of a server.
pub struct Lines {
    /// Whose turn it is: its state stands in the server.
    now: Port,
    /// The other one.
    frame: &'static mut Frame,
    exchange: Exchange,
    fills: bool,
    silence: u8,
    /// The one that has forced last: its silence ends that.
    forced: Port,
}

impl Lines {
    /// The one whose turn it is.
    pub fn now<'b>(&self, board: &'b Board) -> Line<'b> {
        match self.now {
            Port::Usb => Line::Usb(&board.serial),
            Port::Bus => Line::Bus(&board.bus),
        }
    }

    /// For a write: which line has forced, and whose turn it is.
    pub fn forced(&mut self) -> (&mut Port, Port) {
        (&mut self.forced, self.now)
    }
}

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

/// A line, to ask and to answer.
pub enum Line<'b> {
    Usb(&'b serial::Serial),
    Bus(&'b bus::Serial),
}

impl Line<'_> {
    /// As [`serial::Serial::received`].
    pub fn received(&self) -> Option<u8> {
        match self {
            Line::Usb(usb) => usb.received(),
            Line::Bus(bus) => bus.received(),
        }
    }

    /// As [`serial::Serial::send`].
    pub fn send(&self, frame: &Frame, length: u8) {
        match self {
            Line::Usb(usb) => usb.send(frame, length),
            Line::Bus(bus) => bus.send(frame, length),
        }
    }
}
