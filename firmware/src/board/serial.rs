//! The serial port, 115200 8N1, sending only (ATmega328P datasheet, section 20).

use super::CLOCK_HZ;
use super::flash::{self, FlashText};
use crate::decimal::{DIGITS, decimal};
use avr_device::atmega328p::USART0;

const BAUD: u32 = 115_200;
/// Divider with U2X, rounded: 16, which is 117647 baud, 2.1 % fast, as the Arduino core has it.
const DIVIDER: u16 = ((CLOCK_HZ / 4 / BAUD - 1) / 2) as u16;

/// The serial port.
pub struct Serial {
    usart: USART0,
}

impl Serial {
    /// Sets the rate and switches the transmitter on; 8N1 is what the chip has after a reset.
    pub fn new(usart: USART0) -> Serial {
        usart.ubrr0().write(|w| w.set(DIVIDER));
        usart.ucsr0a().write(|w| w.u2x0().set_bit());
        usart.ucsr0b().write(|w| w.txen0().set_bit());
        Serial { usart }
    }

    /// Sends a text that stands in program memory.
    pub fn text(&mut self, text: FlashText) {
        for code in text {
            self.code(code);
        }
    }

    /// Sends what a code of a text stands for.
    #[inline(never)]
    pub fn code(&mut self, mut code: u8) {
        while let Some([first, second]) = flash::pair(code) {
            self.code(first);
            code = second;
        }
        self.byte(code);
    }

    /// Sends a number in decimal.
    pub fn number(&mut self, number: u32) {
        let mut digits = [0; DIGITS];
        decimal(number, &mut digits);
        for &digit in &digits {
            if digit != b' ' {
                self.byte(digit);
            }
        }
    }

    /// Sends one byte, as soon as the transmitter takes it (87 µs a byte).
    pub fn byte(&mut self, byte: u8) {
        while self.usart.ucsr0a().read().udre0().bit_is_clear() {}
        self.usart.udr0().write(|w| w.set(byte));
    }
}
