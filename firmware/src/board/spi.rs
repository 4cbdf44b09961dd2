//! The bus to the card: SPI (ATmega328P datasheet, section 19).

use super::chip::SPI;
use super::pins::Pins;

/// Clock bytes with the card not selected before the first command: at least 74 clocks
/// (SD Physical Layer Simplified Specification, 6.4.1).
const WAKE_BYTES: u8 = 10;
/// Enough to end what a card may be in the middle of: a block, its checksum, and an answer.
const PACKET_BYTES: u16 = 512 + 2 + 8;

/// The SPI bus with its one device, the card.
///
/// The card stays selected from its waking until [`release`], because commands, answers and data belong
/// together and nothing else shares the bus.
#[derive(Clone, Copy)]
pub struct CardBus<'b> {
    spi: &'b SPI,
    pins: &'b Pins,
}

impl<'b> CardBus<'b> {
    /// The bus, as it stands.
    pub fn new(spi: &'b SPI, pins: &'b Pins) -> CardBus<'b> {
        CardBus { spi, pins }
    }

    /// Wakes the card: clocks at 250 kHz while it is not selected, then selects it.
    pub fn wake(self) {
        self.spi
            .spcr()
            .write(|w| w.spe().set_bit().mstr().set_bit().spr().fosc_64_32());
        self.pins.select_card(false);
        for _ in 0..WAKE_BYTES {
            self.exchange(0xFF);
        }
        self.pins.select_card(true);
    }

    /// Goes to 4 MHz, which wires on a breadboard carry, once the card is out of its idle state; and
    /// selects it.
    pub fn full_speed(self) {
        // In this order: LED L leaves the clock line before the card listens.
        self.spi
            .spcr()
            .write(|w| w.spe().set_bit().mstr().set_bit().spr().fosc_4_2());
        self.pins.select_card(true);
    }

    /// Lets the card end what has been cut off, by a fault or a restart of the board: it would take
    /// commands for the rest of a block.
    #[inline(never)]
    pub fn end_packet(self) {
        self.full_speed();
        for _ in 0..PACKET_BYTES {
            self.exchange(0xFF);
        }
    }

    /// Sends a byte and gives the one that the card sends; 2 µs at full speed.
    #[inline(never)]
    pub fn exchange(self, byte: u8) -> u8 {
        self.spi.spdr().write(|w| w.set(byte));
        while self.spi.spsr().read().spif().bit_is_clear() {}
        self.spi.spdr().read().bits()
    }
}

/// Switches the bus off; the pins are the port's again, and the card is not selected.
pub fn release(spi: &SPI, pins: &Pins) {
    pins.select_card(false);
    spi.spcr().reset();
}
