//! The bus to the card: SPI with a deadline (ATmega328P datasheet, section 19).

use super::clock;
use super::pins::Pins;
use avr_device::atmega328p::SPI;
use embedded_hal::delay::DelayNs;
use embedded_hal::spi::{ErrorKind, ErrorType, Operation, SpiDevice};

/// Clock bytes with the card not selected before the first command: at least 74 clocks
/// (SD Physical Layer Simplified Specification, 6.4.1).
const WAKE_BYTES: u8 = 10;
/// Enough to end what a card may be in the middle of: a block, its check sum, and an answer.
const PACKET_BYTES: u16 = 512 + 2 + 8;
/// How long a slot may stay silent when it is woken, ms.
const SILENCE: u16 = 60;

/// A card did not answer in time.
#[derive(Debug)]
pub struct TooLate;

impl embedded_hal::spi::Error for TooLate {
    fn kind(&self) -> ErrorKind {
        ErrorKind::Other
    }
}

/// The SPI bus with its one device, the card.
///
/// Every transfer fails once the deadline has passed, whatever the card does: so every wait of the
/// card's driver ends. The card stays selected from its waking until [`release`], because commands, answers and data belong together and nothing else shares the bus.
pub struct CardBus<'b> {
    spi: &'b SPI,
    pins: &'b Pins,
    /// When the card's time began, ms, wrapping.
    since: u16,
    /// ms
    limit: u16,
    answered: bool,
}

impl<'b> CardBus<'b> {
    /// Switches the bus on, at 250 kHz.
    pub fn start(spi: &'b SPI, pins: &'b Pins) -> CardBus<'b> {
        let mut bus = CardBus::new(spi, pins);
        bus.start_speed();
        bus
    }

    /// Lets the card end what a restart of the board has cut off: it has kept its power, and would
    /// take the first commands for the rest of a block. It is long out of its idle state.
    pub fn end_packet(&mut self) {
        self.full_speed();
        self.pins.select_card(true);
        for _ in 0..PACKET_BYTES {
            self.exchange(0xFF);
        }
        self.start_speed();
    }

    fn start_speed(&mut self) {
        self.spi
            .spcr()
            .write(|w| w.spe().set_bit().mstr().set_bit().spr().fosc_64_32());
    }

    /// Switches the bus on again, at 4 MHz, and selects the card. Without a deadline, for
    /// [`exchange`](CardBus::exchange).
    #[inline(never)]
    pub fn resume(spi: &'b SPI, pins: &'b Pins) -> CardBus<'b> {
        let mut bus = CardBus::new(spi, pins);
        // In this order: LED L leaves the clock line before the card listens.
        bus.full_speed();
        pins.select_card(true);
        bus
    }

    fn new(spi: &'b SPI, pins: &'b Pins) -> CardBus<'b> {
        CardBus {
            spi,
            pins,
            since: 0,
            limit: 0,
            answered: false,
        }
    }

    /// Wakes the card: clocks while it is not selected, then selects it. From now it has so many
    /// ms, but far fewer until its first answer.
    pub fn wake(&mut self, limit: u16) {
        self.pins.select_card(false);
        for _ in 0..WAKE_BYTES {
            self.exchange(0xFF);
        }
        self.pins.select_card(true);
        self.answered = false;
        self.allow(limit);
    }

    /// Goes to 4 MHz, which wires on a breadboard carry, once the card is out of its idle state.
    pub fn full_speed(&mut self) {
        self.spi
            .spcr()
            .write(|w| w.spe().set_bit().mstr().set_bit().spr().fosc_4_2());
    }

    /// Gives the card this many ms from now.
    pub fn allow(&mut self, limit: u16) {
        self.since = clock::now() as u16;
        self.limit = limit;
    }

    /// Whether the card has sent anything at all.
    pub fn answered(&self) -> bool {
        self.answered
    }

    /// Sends a byte and gives the one that the card sends; 2 µs at full speed.
    pub fn exchange(&mut self, byte: u8) -> u8 {
        self.spi.spdr().write(|w| w.set(byte));
        while self.spi.spsr().read().spif().bit_is_clear() {}
        let answer = self.spi.spdr().read().bits();
        self.answered |= answer != 0xFF;
        answer
    }

    #[inline(never)]
    fn in_time(&self) -> Result<(), TooLate> {
        let limit = if self.answered { self.limit } else { SILENCE };
        if (clock::now() as u16).wrapping_sub(self.since) < limit {
            Ok(())
        } else {
            Err(TooLate)
        }
    }
}

/// Switches the bus off; the pins are the port's again, and the card is not selected.
pub fn release(spi: &SPI, pins: &Pins) {
    pins.select_card(false);
    spi.spcr().reset();
}

impl ErrorType for CardBus<'_> {
    type Error = TooLate;
}

/// What the card's driver calls are the four plain transfers: each is its own function, so that the
/// list of operations is never made.
impl SpiDevice for CardBus<'_> {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), TooLate> {
        for operation in operations {
            match operation {
                Operation::Read(bytes) => self.read(bytes)?,
                Operation::Write(bytes) => self.write(bytes)?,
                Operation::Transfer(answer, bytes) => self.transfer(answer, bytes)?,
                Operation::TransferInPlace(bytes) => self.transfer_in_place(bytes)?,
                Operation::DelayNs(ns) => Pause.delay_ns(*ns),
            }
        }
        Ok(())
    }

    fn read(&mut self, bytes: &mut [u8]) -> Result<(), TooLate> {
        bytes.fill(0xFF);
        self.transfer_in_place(bytes)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), TooLate> {
        self.in_time()?;
        for &byte in bytes {
            self.exchange(byte);
        }
        Ok(())
    }

    fn transfer(&mut self, answer: &mut [u8], bytes: &[u8]) -> Result<(), TooLate> {
        self.in_time()?;
        // The longer of the two decides (embedded-hal's contract).
        for index in 0..answer.len().max(bytes.len()) {
            let byte = self.exchange(bytes.get(index).copied().unwrap_or(0xFF));
            if let Some(place) = answer.get_mut(index) {
                *place = byte;
            }
        }
        Ok(())
    }

    fn transfer_in_place(&mut self, bytes: &mut [u8]) -> Result<(), TooLate> {
        self.in_time()?;
        for byte in bytes {
            *byte = self.exchange(*byte);
        }
        Ok(())
    }
}

/// Waits by counting cycles.
pub struct Pause;

impl DelayNs for Pause {
    fn delay_ns(&mut self, ns: u32) {
        // A shift and no division: up to twice as long as asked for, which no driver here does.
        self.delay_us(ns / 512 + 1);
    }

    fn delay_us(&mut self, us: u32) {
        for _ in 0..us {
            // With the loop around it 16 cycles or a few more: never shorter than asked for.
            avr_device::asm::delay_cycles(8);
        }
    }
}
