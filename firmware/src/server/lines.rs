//! The two lines of a board that serves a bus beside USB. Each has a frame and a request of its own.
//!
//! Owns which line is which; must not know the server.

use crate::board::{Board, bus, serial};
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
    pub(super) now: Port,
    /// The other one.
    pub(super) frame: &'static mut Frame,
    pub(super) exchange: Exchange,
    pub(super) fills: bool,
    pub(super) silence: u8,
    /// The one that has forced last: its silence ends that.
    pub(super) forced: Port,
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
