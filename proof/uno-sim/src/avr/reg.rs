//! Data addresses of the registers that are looked at from outside (ATmega328P datasheet, section 30).

/// Port B (D8 to D13), direction; each port's output register follows its direction register.
pub const DDRB: u16 = 0x24;
/// EEPROM control register.
pub const EECR: u16 = 0x3F;
/// EEPROM data register.
pub const EEDR: u16 = 0x40;
/// EEPROM address: EEARL, then EEARH.
pub const EEAR: u16 = 0x41;
/// Timer 0, control A.
pub const TCCR0A: u16 = 0x44;
/// Timer 0, control B.
pub const TCCR0B: u16 = 0x45;
/// Timer 0, compare register A.
pub const OCR0A: u16 = 0x47;
/// SPI control register; SPE is bit 6.
pub const SPCR: u16 = 0x4C;
/// Why the chip was reset; PORF is bit 0, EXTRF bit 1, WDRF bit 3.
pub const MCUSR: u16 = 0x54;
/// Writing the flash; where it is not 0, `lpm` may read something else.
pub const SPMCSR: u16 = 0x57;
/// Stack pointer: SPL, then SPH.
pub const SP: u16 = 0x5D;
/// Watchdog control; WDE is bit 3, WDIE bit 6.
pub const WDTCSR: u16 = 0x60;
/// Timer 1, which interrupts are on.
pub const TIMSK1: u16 = 0x6F;
/// Result of the converter: ADCL, then ADCH.
pub const ADC: u16 = 0x78;
/// Converter, control and status A.
pub const ADCSRA: u16 = 0x7A;
/// Converter, control and status B.
pub const ADCSRB: u16 = 0x7B;
/// Converter, reference and channel.
pub const ADMUX: u16 = 0x7C;
/// Timer 1, control A.
pub const TCCR1A: u16 = 0x80;
/// Timer 1, control B.
pub const TCCR1B: u16 = 0x81;
/// Timer 1, what it counts to: ICR1L, then ICR1H.
pub const ICR1: u16 = 0x86;
/// Timer 1, compare register A: OCR1AL, then OCR1AH.
pub const OCR1A: u16 = 0x88;
/// USART control and status A.
pub const UCSR0A: u16 = 0xC0;
/// USART control and status B.
pub const UCSR0B: u16 = 0xC1;
/// USART control and status C.
pub const UCSR0C: u16 = 0xC2;
/// USART divider: UBRR0L, then UBRR0H.
pub const UBRR0: u16 = 0xC4;
/// USART data register.
pub const UDR0: u16 = 0xC6;
