//! Data addresses of the registers that are looked at from outside (ATmega328P datasheet, section 30).

/// Port B (D8 to D13), direction.
pub const DDRB: u16 = 0x24;
/// Port C (A0 to A5), direction.
pub const DDRC: u16 = 0x27;
/// Port D (D0 to D7), direction; each port's output register follows its direction register.
pub const DDRD: u16 = 0x2A;
/// EEPROM control register.
pub const EECR: u16 = 0x3F;
/// EEPROM data register.
pub const EEDR: u16 = 0x40;
/// EEPROM address: EEARL, then EEARH.
pub const EEAR: u16 = 0x41;
/// SPI control register; SPE is bit 6.
pub const SPCR: u16 = 0x4C;
/// Why the chip was reset; PORF is bit 0, EXTRF bit 1, WDRF bit 3.
pub const MCUSR: u16 = 0x54;
/// Stack pointer: SPL, then SPH.
pub const SP: u16 = 0x5D;
/// Watchdog control; WDE is bit 3, WDIE bit 6.
pub const WDTCSR: u16 = 0x60;
/// Timer 1, which interrupts are on.
pub const TIMSK1: u16 = 0x6F;
/// USART control and status B; RXEN0 is bit 4.
pub const UCSR0B: u16 = 0xC1;
