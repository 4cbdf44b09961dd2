//! The serial line, from its other end.

use super::Uno;
use crate::uart::{Flaw, Line, SentByte};
use std::borrow::Cow;

impl Uno {
    /// All bytes that the program has sent and that have not been taken. A byte is among them as soon as the port has
    /// taken it from the program, which may be two bytes before it has gone out.
    pub fn serial_bytes(&self) -> &[u8] {
        self.wired.uart().sent()
    }

    /// The same with the time of each.
    pub fn serial_log(&self) -> &[SentByte] {
        self.wired.uart().sent_log()
    }

    /// The same as text; what is not UTF-8 is replaced.
    pub fn serial(&self) -> Cow<'_, str> {
        String::from_utf8_lossy(self.serial_bytes())
    }

    /// All bytes that the program has sent, and forgets them.
    pub fn take_serial(&mut self) -> Vec<u8> {
        let log = self.wired.uart_mut().transmitter().take_until(u64::MAX);
        log.into_iter().map(|sent| sent.byte).collect()
    }

    /// Those that have gone out, with their stop bit, and forgets them.
    pub fn take_serial_log(&mut self) -> Vec<SentByte> {
        let now = self.cycles();
        self.wired.uart_mut().transmitter().take_until(now)
    }

    /// Sets how the other end sends from now on. What the program sends is not affected: it says itself how
    /// ([`SentByte`]).
    ///
    /// # Panics
    /// Where the rate is 0.
    pub fn set_serial_line(&mut self, line: Line) {
        assert!(line.baud > 0, "a line without a rate");
        self.wired.uart_mut().wire().set_line(line);
    }

    /// How the other end sends.
    pub fn serial_line(&self) -> Line {
        self.wired.uart().line()
    }

    /// Sends bytes to the program, one after the other at the rate of the line, from now on or as soon as what has been
    /// sent before is over. They come whether or not the program reads them: the chip holds two, and a third until the
    /// next one begins; with the receiver off, or at another rate, they are lost or misread. A reset does not hold them
    /// up.
    ///
    /// Gives the cycle at which the last stop bit ends. The program sees a byte half a bit before that.
    pub fn send_serial(&mut self, bytes: &[u8]) -> u64 {
        self.wired.send_serial(bytes, None, 0)
    }

    /// The same from this cycle on, counted from when the board was made.
    pub fn send_serial_at(&mut self, cycle: u64, bytes: &[u8]) -> u64 {
        self.wired.send_serial(bytes, None, cycle)
    }

    /// The same with this flaw in each byte.
    pub fn send_serial_flawed(&mut self, bytes: &[u8], flaw: Flaw) -> u64 {
        self.wired.send_serial(bytes, Some(flaw), 0)
    }

    /// Sends bytes over the second serial port, at the rate of [`Uno::set_bus_line`], as [`Uno::send_serial`] does.
    ///
    /// # Panics
    /// Where the board has none.
    pub fn send_bus(&mut self, bytes: &[u8]) -> u64 {
        self.wired.send_bus(bytes, 0)
    }

    /// The same from this cycle on, counted from when the board was made.
    ///
    /// # Panics
    /// Where the board has none.
    pub fn send_bus_at(&mut self, cycle: u64, bytes: &[u8]) -> u64 {
        self.wired.send_bus(bytes, cycle)
    }

    /// What the program has sent over it with its stop bits, and forgets that.
    ///
    /// # Panics
    /// Where the board has none.
    pub fn take_bus_log(&mut self) -> Vec<SentByte> {
        let now = self.cycles();
        self.wired.bus_mut().transmitter().take_until(now)
    }

    /// Sets how the other end of it sends.
    ///
    /// # Panics
    /// Where the board has none.
    pub fn set_bus_line(&mut self, line: Line) {
        self.wired.bus_mut().wire().set_line(line);
    }
}
