// Where the registers stand in the data space of the ATmega328P (datasheet, section 36), and their bits. Those of the
// ATmega2560 that are named here stand in the same places.

export const SPCR = 0x4c;
/** SPI is on, in SPCR. */
export const SPE = 1 << 6;

export const MCUSR = 0x54;
export const WDTCSR = 0x60;
export const WDCE = 1 << 4;
export const WDE = 1 << 3;

export const ADCSRA = 0x7a;
export const ADIF = 1 << 4;
export const ADSC = 1 << 6;

export const UCSRA = 0xc0;
export const UCSRB = 0xc1;
export const UCSRC = 0xc2;
export const UBRRL = 0xc4;
export const UBRRH = 0xc5;
export const UDR = 0xc6;

/** Working registers, which a reset leaves alone like the RAM. */
export const WORKING_REGISTERS = 32;

/** Cycles of a second, and of a millisecond. */
export const CLOCK_HZ = 16_000_000;
export const CYCLES_PER_MS = CLOCK_HZ / 1000;
