//! The Arduino UNO: the only place that touches registers.
//!
//! | point | pin | port |
//! | --- | --- | --- |
//! | inputs 01–04 | D2–D5 | PD2–PD5 |
//! | outputs 01–04 | D6–D9 | PD6, PD7, PB0, PB1 |
//! | card | D10–D13 | PB2 CS, PB3 MOSI, PB4 MISO, PB5 SCK |
//! | LED L | D13 | PB5, when the card does not use it |
//! | serial | D0, D1 | USART0 |
//! | STOP | A5 | PC5 |

pub mod clock;
pub mod eeprom;
pub mod flash;
pub mod pins;
pub mod serial;
pub mod spi;
pub mod supply;
pub mod watchdog;

use avr_device::atmega328p::{Peripherals, SPI, TC1};

/// The chip's clock, Hz (ceramic resonator of the UNO).
pub const CLOCK_HZ: u32 = 16_000_000;

/// The parts of the board, ready to use.
pub struct Board {
    /// Inputs, outputs, LED L and the card's select line.
    pub pins: pins::Pins,
    /// The serial port.
    pub serial: serial::Serial,
    /// The EEPROM.
    pub eeprom: eeprom::Eeprom,
    /// The supply voltage.
    pub supply: supply::Supply,
    /// The watchdog.
    pub watchdog: watchdog::Watchdog,
    /// Why the board has started.
    pub start: watchdog::Start,
    spi: SPI,
    timer: TC1,
}

impl Board {
    /// Takes the board and sets it up, outputs first (NC-7).
    pub fn take() -> Board {
        // SAFETY: called once, by `main`, before anything else runs; so there is one owner of
        // each peripheral.
        let chip = unsafe { Peripherals::steal() };
        let pins = pins::Pins::new(chip.PORTB, chip.PORTC, chip.PORTD);
        let (watchdog, start) =
            watchdog::Watchdog::take(chip.WDT, &chip.CPU, clock::is_on(&chip.TC1));
        clock::start(&chip.TC1);
        Board {
            pins,
            serial: serial::Serial::new(chip.USART0),
            eeprom: eeprom::Eeprom::new(chip.EEPROM),
            supply: supply::Supply::start(chip.ADC),
            watchdog,
            start,
            spi: chip.SPI,
            timer: chip.TC1,
        }
    }

    /// This moment.
    #[inline(always)]
    pub fn moment(&self) -> clock::Moment {
        clock::moment(&self.timer)
    }

    /// The bus to the card, which still sleeps.
    pub fn card_bus(&self) -> spi::CardBus<'_> {
        let bus = spi::CardBus::new(&self.spi, &self.pins);
        if self.start != watchdog::Start::Power {
            // The card has kept its power, and is long out of its idle state.
            bus.end_packet();
        }
        bus
    }

    /// The bus to the card, at full speed, with the card selected: for what comes after start-up.
    pub fn resume_card(&self) -> spi::CardBus<'_> {
        let bus = spi::CardBus::new(&self.spi, &self.pins);
        bus.full_speed();
        bus
    }

    /// Gives D10 to D13 back: the card is no longer selected, and LED L is ours.
    pub fn release_card(&self) {
        spi::release(&self.spi, &self.pins);
    }
}
