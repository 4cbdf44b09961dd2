//! The serial port of the chip, USART0, with the times of the line (ATmega328P datasheet, section 19).
//!
//! simavr's own port has a receive buffer of 64 bytes, counts every character as 11 bits, says that all has been sent
//! after each byte, and buffers no byte on the way out. So it is not used. This model knows nothing of simavr: the
//! callbacks of `wiring` tell it what the program does, and the time.
//!
//! Not modelled: nine data bits, the synchronous modes, MPCM. A character to be sent starts at once where the chip waits
//! for the next tick of its baud clock, and UDRE comes back at once where the chip takes two cycles.

mod line;
mod receiver;
mod transmitter;
mod wire;

pub(crate) use line::Setting;
pub use line::{Flaw, Line, Parity};
use receiver::Receiver;
pub use transmitter::SentByte;
use transmitter::Transmitter;
use wire::Wire;

/// Bits of UCSR0A.
const RXC: u8 = 1 << 7;
const TXC: u8 = 1 << 6;
const UDRE: u8 = 1 << 5;
const FE: u8 = 1 << 4;
const DOR: u8 = 1 << 3;
const UPE: u8 = 1 << 2;
const U2X: u8 = 1 << 1;
const MPCM: u8 = 1 << 0;
/// Bits of UCSR0B. The enable bits of the interrupts stand where UCSR0A has their flags.
const RXEN: u8 = 1 << 4;
const TXEN: u8 = 1 << 3;
const UCSZ2: u8 = 1 << 2;
const INTERRUPTS: u8 = RXC | TXC | UDRE;

/// Which interrupts are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Requests {
    /// USART_RX: a byte can be read.
    pub received: bool,
    /// USART_UDRE: a byte can be written.
    pub room: bool,
    /// USART_TX: all has been sent.
    pub sent: bool,
}

/// The port, and the line to it. All times are cycles since the board was made.
pub(crate) struct Uart {
    wire: Wire,
    receiver: Receiver,
    transmitter: Transmitter,
    /// U2X and MPCM.
    mode: u8,
    /// UCSR0B.
    control: u8,
}

impl Uart {
    /// As after a reset, with nothing on the line.
    pub fn new() -> Uart {
        Uart {
            wire: Wire::default(),
            receiver: Receiver::default(),
            transmitter: Transmitter::default(),
            mode: 0,
            control: 0,
        }
    }

    /// A reset of the chip: what is on the line comes on.
    pub fn reset(&mut self) {
        self.receiver = Receiver::default();
        self.transmitter.reset();
        (self.mode, self.control) = (0, 0);
    }

    /// The line from the other end.
    pub fn wire(&mut self) -> &mut Wire {
        &mut self.wire
    }

    /// How the other end sends.
    pub fn line(&self) -> Line {
        self.wire.line()
    }

    /// What the program has sent.
    pub fn transmitter(&mut self) -> &mut Transmitter {
        &mut self.transmitter
    }

    /// The bytes that the program has sent.
    pub fn sent(&self) -> &[u8] {
        self.transmitter.bytes()
    }

    /// The same with their times.
    pub fn sent_log(&self) -> &[SentByte] {
        self.transmitter.log()
    }

    /// UCSR0A, as the program reads it.
    pub fn status(&self) -> u8 {
        let bit = |mask, set| if set { mask } else { 0 };
        let first = self.receiver.first();
        self.mode
            | bit(RXC, first.is_some())
            | bit(TXC, self.transmitter.is_complete())
            | bit(UDRE, self.transmitter.has_room())
            | bit(FE, first.is_some_and(|first| first.framing_error))
            | bit(DOR, first.is_some_and(|first| first.after_loss))
            | bit(UPE, first.is_some_and(|first| first.parity_error))
    }

    /// The program writes to UCSR0A.
    pub fn set_status(&mut self, value: u8) {
        self.mode = value & (U2X | MPCM);
        if value & TXC != 0 {
            self.transmitter.clear_complete();
        }
    }

    /// UCSR0B.
    pub fn control(&self) -> u8 {
        self.control
    }

    /// The program writes to UCSR0B.
    pub fn set_control(&mut self, value: u8, now: u64) {
        self.control = value & (INTERRUPTS | RXEN | TXEN | UCSZ2);
        self.receiver.switch(value & RXEN != 0, now);
    }

    /// The program writes to UDR0.
    pub fn set_data(&mut self, byte: u8, now: u64, setting: Setting) {
        if self.control & TXEN != 0 {
            self.transmitter.send(byte, now, setting);
        }
    }

    /// The program reads UDR0.
    pub fn take_data(&mut self, now: u64) -> u8 {
        self.receiver.take(&self.wire, now)
    }

    /// What the interrupts stand at.
    pub fn requests(&self) -> Requests {
        let asked = self.status() & self.control;
        Requests {
            received: asked & RXC != 0,
            room: asked & UDRE != 0,
            sent: asked & TXC != 0,
        }
    }

    /// The CPU has taken the interrupt USART_TX, which clears its flag.
    pub fn sent_is_served(&mut self) {
        self.transmitter.clear_complete();
    }

    /// The cycle at which [`Uart::pass`] is to be called next.
    pub fn due(&self, setting: Setting) -> Option<u64> {
        let received = self.receiver.due(&self.wire, setting);
        received.into_iter().chain(self.transmitter.due()).min()
    }

    /// Time has come to `now`.
    pub fn pass(&mut self, now: u64, setting: Setting) {
        self.transmitter.pass(now);
        self.receiver.pass(&mut self.wire, now, setting);
    }
}
