//! The serial port: text during set-up, then Modbus frames by interrupts (ATmega328P datasheet, sections
//! 18 and 20).
//!
//! The interrupts of `port.s` move the bytes of a frame; what is here begins and ends that.

#[cfg(not(mega))]
use super::chip::PORTC;
#[cfg(mega)]
use super::chip::PORTD as PORTC;
use super::chip::{TC2, USART0};
use super::flash::{self, FlashText};
use super::shared::Shared;
use core::arch::global_asm;
use unoclp_modbus::Frame;

global_asm!(interrupts!(), include_str!("port.s"), options(raw));

/// Whether it is the second port of its board, a bus of Modbus: the direction is that of this one.
#[cfg(mega)]
const IS_BUS: bool = false;

/// U2X0: half as many clocks for each bit.
const DOUBLE_SPEED: u8 = 1 << 1;
/// 8 data bits.
const EIGHT_BITS: u8 = 0b110;
const RECEIVING: u8 = 1 << 7;
const LISTEN: u8 = RECEIVING | 1 << 4 | 1 << 3;
const ONLY_SEND: u8 = 1 << 3;
const SEND: u8 = 1 << 5 | ONLY_SEND;
/// TXCIE0: the last byte is going.
#[cfg(mega)]
const LAST: u8 = 1 << 6;
/// OCF2A
const SILENCE: u8 = 1 << 1;
/// PC4, A4: the direction of the RS-485 driver.
#[cfg(not(mega))]
const DIRECTION: u8 = 1 << 4;
/// PD1, D20: likewise.
#[cfg(mega)]
const DIRECTION: u8 = 1 << 1;
/// Counts of timer 2, of 64 µs, in 3.5 characters of 11 bits: so many 256ths of the divider.
const SILENCE_PER_DIVIDER: u16 = 77;
/// Up to this divider, which is that above 19200 baud, silence is 1.75 ms whatever the rate.
const FAST: u8 = 91;
/// That in such counts, since the last stop bit's middle; the first is shorter. A frame that follows at once has
/// come to its first stop bit 1.837 ms after that, at 115200 baud.
const SHORTEST_SILENCE: u8 = 27;

// The words are touched only while no interrupt of the port is enabled.

/// Where the frame stands.
#[unsafe(export_name = "PORT_FRAME")]
static FRAME: Shared<usize> = Shared::new(0);
/// How many bytes of it have come or gone, 255 at most; 0 while nothing goes on.
#[unsafe(export_name = "PORT_AT")]
static AT: Shared<u8> = Shared::new(0);
/// How many are to go, without the checksum.
#[unsafe(export_name = "PORT_END")]
static END: Shared<u8> = Shared::new(0);
/// 1 where byte 256 has come; 2 where a byte was damaged, or one too many.
#[unsafe(export_name = "PORT_OVER")]
static OVER: Shared<u8> = Shared::new(0);
#[unsafe(export_name = "PORT_CRC")]
static CRC: Shared<u16> = Shared::new(0);

// SAFETY: `port.s` defines it. It changes nothing, and leaves the registers of a call as a call does.
unsafe extern "C" {
    /// Whether the frame that has ended is sound and for this server; to be asked while no interrupt of the
    /// port is enabled.
    safe fn port_is_ours() -> u8;
}

/// What the line is like.
pub struct Line {
    /// The server's address on the bus.
    pub address: u8,
    /// The divider of the rate, with U2X.
    pub divider: u16,
    /// UPM0, in its place.
    pub parity_bits: u8,
    /// Whether A4 is the direction of an RS-485 driver.
    pub has_direction: bool,
}

/// The serial port.
pub struct Serial {
    usart: USART0,
    timer: TC2,
    pins: PORTC,
}

impl Serial {
    /// The port, with its line still closed.
    pub fn new(usart: USART0, timer: TC2, pins: PORTC) -> Serial {
        Serial { usart, timer, pins }
    }

    /// Sets the line up and switches the transmitter on. The direction pin, where there is one, stays low, so
    /// that text does not reach the bus.
    #[inline(always)]
    pub fn open(&mut self, line: &Line) {
        let Serial { usart, timer, pins } = self;
        let divider = line.divider;
        usart.ubrr0().write(|w| w.set(divider - 1));
        // SAFETY: any value may be written to these; the reserved bits are 0.
        unsafe {
            usart.ucsr0a().write(|w| w.bits(DOUBLE_SPEED));
            usart
                .ucsr0c()
                .write(|w| w.bits(line.parity_bits | EIGHT_BITS));
            usart.ucsr0b().write(|w| w.bits(ONLY_SEND));
            #[cfg(mega)]
            if IS_BUS && line.has_direction {
                pins.ddrd().write(|w| w.bits(DIRECTION));
            }
            #[cfg(not(mega))]
            if line.has_direction {
                pins.ddrc().write(|w| w.bits(DIRECTION));
            }
        }
        let silence = if divider <= FAST.into() {
            SHORTEST_SILENCE
        } else {
            ((divider * SILENCE_PER_DIVIDER) >> 8) as u8 + 2
        };
        timer.ocr2a().write(|w| w.set(silence));
        timer.tccr2b().write(|w| w.cs2().prescale_1024());
        // Nothing is compared with OCR2B, so it holds the address: a scan that goes astray writes to RAM, and
        // the board is asked for its fault after that.
        timer.ocr2b().write(|w| w.set(line.address));
    }

    /// Sends a text that stands in program memory.
    pub fn text(&self, text: FlashText) {
        for code in text {
            self.code(code);
        }
    }

    /// Sends what a code of a text stands for.
    #[inline(never)]
    pub fn code(&self, mut code: u8) {
        while let Some([first, second]) = flash::pair(code) {
            self.code(first);
            code = second;
        }
        self.byte(code);
    }

    /// Sends one byte, as soon as the transmitter takes it (87 µs a byte at 115200 baud).
    pub fn byte(&self, byte: u8) {
        while self.usart.ucsr0a().read().udre0().bit_is_clear() {}
        self.usart.udr0().write(|w| w.set(byte));
    }

    /// From now on there are only frames, and they stand here: the interrupts write there, except between
    /// [`received`](Serial::received) and [`send`](Serial::send).
    pub fn serve(&self, frame: &mut &'static mut Frame) {
        FRAME.set(frame.as_mut_ptr() as usize);
        self.listen();
    }

    /// Whether nothing is being received, handled or sent.
    #[inline(always)]
    pub fn is_quiet(&self) -> bool {
        AT.get() == 0
    }

    /// The length of a frame for this server that has ended, without its checksum: it stands in the
    /// frame, and the port is deaf until [`send`](Serial::send). Any other frame that has ended is dropped.
    ///
    /// The receiver goes on meanwhile, so a frame that has just begun after another station's loses
    /// nothing: it holds two bytes while its interrupt waits.
    pub fn received(&self) -> Option<u8> {
        let has_ended = || self.timer.tifr2().read().bits() & SILENCE != 0;
        let listens = self.usart.ucsr0b().read().bits() & RECEIVING != 0;
        if self.is_quiet() || !listens || !has_ended() {
            return None;
        }
        self.control(LISTEN & !RECEIVING);
        // Unless another has begun at the last moment.
        if has_ended() {
            if port_is_ours() != 0 {
                self.control(ONLY_SEND);
                return Some(AT.get() - 2 + OVER.get());
            }
            AT.set(0);
        }
        self.control(LISTEN);
        None
    }

    /// Sends so many bytes of the frame, and the checksum, and listens again. Nobody may change the frame
    /// until then. Listens at once where there are none, and where the request was a broadcast, which nobody
    /// answers.
    pub fn send(&self, frame: &Frame, length: u8) {
        if length == 0 || frame[0] == 0 {
            return self.listen();
        }
        AT.set(0);
        END.set(length);
        CRC.set(0xFFFF);
        #[cfg(mega)]
        if IS_BUS && self.pins.ddrd().read().bits() & DIRECTION != 0 {
            self.pins.portd().modify(|_, w| w.pd1().set_bit());
        }
        #[cfg(not(mega))]
        if self.pins.ddrc().read().bits() & DIRECTION != 0 {
            self.pins.portc().modify(|_, w| w.pc4().set_bit());
        }
        // So that it is not quiet in between: the first byte goes at once.
        self.control(SEND);
    }

    /// Whether an answer is on its way.
    #[cfg(mega)]
    pub fn is_sending(&self) -> bool {
        self.usart.ucsr0b().read().bits() & (SEND | LAST) & !ONLY_SEND != 0
    }

    fn listen(&self) {
        AT.set(0);
        self.control(LISTEN);
    }

    #[inline(never)]
    fn control(&self, bits: u8) {
        // SAFETY: any value may be written.
        self.usart.ucsr0b().write(|w| unsafe { w.bits(bits) });
    }
}
