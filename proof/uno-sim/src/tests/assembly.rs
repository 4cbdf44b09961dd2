//! Registers and instructions (ATmega328P datasheet, section 30; AVR Instruction Set Manual).

// I/O addresses of the ATmega328P.
pub const DDRB: u16 = 0x04;
pub const PORTB: u16 = 0x05;
pub const PINC: u16 = 0x06;
pub const PORTC: u16 = 0x08;
pub const PIND: u16 = 0x09;
pub const DDRD: u16 = 0x0A;
pub const PORTD: u16 = 0x0B;
pub const EECR: u16 = 0x1F;
pub const EEDR: u16 = 0x20;
pub const EEARL: u16 = 0x21;
pub const EEARH: u16 = 0x22;
pub const TCCR0A: u16 = 0x24;
pub const TCCR0B: u16 = 0x25;
pub const OCR0A: u16 = 0x27;
pub const SPCR: u16 = 0x2C;
pub const SPSR: u16 = 0x2D;
pub const SPDR: u16 = 0x2E;
pub const MCUSR: u16 = 0x34;
pub const SPL: u16 = 0x3D;
pub const SPH: u16 = 0x3E;
// Data addresses.
pub const WDTCSR: u16 = 0x60;
pub const ADCL: u16 = 0x78;
pub const ADCH: u16 = 0x79;
pub const ADCSRA: u16 = 0x7A;
pub const ADMUX: u16 = 0x7C;
pub const TIMSK1: u16 = 0x6F;
pub const TCCR1A: u16 = 0x80;
pub const TCCR1B: u16 = 0x81;
pub const ICR1L: u16 = 0x86;
pub const ICR1H: u16 = 0x87;
pub const OCR1AL: u16 = 0x88;
pub const OCR1AH: u16 = 0x89;
pub const UCSR0A: u16 = 0xC0;
pub const UCSR0B: u16 = 0xC1;
pub const UCSR0C: u16 = 0xC2;
pub const UBRR0L: u16 = 0xC4;
pub const UBRR0H: u16 = 0xC5;
pub const UDR0: u16 = 0xC6;

// Numbers of interrupts (datasheet, table 11-6).
pub const TIMER1_OVF: usize = 13;
pub const USART_RX: usize = 18;
pub const USART_UDRE: usize = 19;
pub const USART_TX: usize = 20;
pub const ADC_DONE: usize = 21;

// The instructions (AVR Instruction Set Manual).
pub const NOP: u16 = 0x0000;
pub const SEI: u16 = 0x9478;
pub const SLEEP: u16 = 0x9588;
pub const RET: u16 = 0x9508;
pub const RETI: u16 = 0x9518;
/// `rjmp .-2`: to itself.
pub const HERE: u16 = rjmp(-1);

pub const fn ldi(r: u16, k: u16) -> u16 {
    0xE000 | (k & 0xF0) << 4 | (r - 16) << 4 | k & 0x0F
}

pub const fn out(io: u16, r: u16) -> u16 {
    0xB800 | (io & 0x30) << 5 | r << 4 | io & 0x0F
}

pub const fn input(r: u16, io: u16) -> u16 {
    0xB000 | (io & 0x30) << 5 | r << 4 | io & 0x0F
}

pub const fn sbi(io: u16, bit: u16) -> u16 {
    0x9A00 | io << 3 | bit
}

pub const fn cbi(io: u16, bit: u16) -> u16 {
    0x9800 | io << 3 | bit
}

/// Skips the next instruction where the bit is set.
pub const fn sbrs(r: u16, bit: u16) -> u16 {
    0xFE00 | r << 4 | bit
}

/// Skips the next instruction where the bit is clear.
pub const fn sbrc(r: u16, bit: u16) -> u16 {
    0xFC00 | r << 4 | bit
}

/// Skips the next instruction where the bit of an I/O register is clear.
pub const fn sbic(io: u16, bit: u16) -> u16 {
    0x9900 | io << 3 | bit
}

pub const fn andi(r: u16, k: u16) -> u16 {
    0x7000 | (k & 0xF0) << 4 | (r - 16) << 4 | k & 0x0F
}

pub const fn cpi(r: u16, k: u16) -> u16 {
    0x3000 | (k & 0xF0) << 4 | (r - 16) << 4 | k & 0x0F
}

pub const fn inc(r: u16) -> u16 {
    0x9403 | r << 4
}

pub const fn dec(r: u16) -> u16 {
    0x940A | r << 4
}

/// Jumps to the word `by` after the next one where the last result was not 0.
pub const fn brne(by: i16) -> u16 {
    0xF401 | (by as u16 & 0x7F) << 3
}

/// The same where it was 0.
pub const fn breq(by: i16) -> u16 {
    0xF001 | (by as u16 & 0x7F) << 3
}

pub const fn push(r: u16) -> u16 {
    0x920F | r << 4
}

/// The first word of `sts`; the address follows.
pub const fn sts(r: u16) -> u16 {
    0x9200 | r << 4
}

/// The first word of `lds`; the address follows.
pub const fn lds(r: u16) -> u16 {
    0x9000 | r << 4
}

/// To the word `by` after the next one.
pub const fn rjmp(by: i16) -> u16 {
    0xC000 | by as u16 & 0x0FFF
}

pub const fn rcall(by: i16) -> u16 {
    0xD000 | by as u16 & 0x0FFF
}

/// Writes a register to where X (r26 and r27) points, and moves X on.
pub const fn st_x(r: u16) -> u16 {
    0x920D | r << 4
}

/// A program with these handlers of interrupts, by number.
pub fn with_interrupts(main: &[u16], handlers: &[(usize, &[u16])]) -> Vec<u16> {
    // Two words for each of 26 vectors.
    let mut words = vec![NOP; 52];
    let jump = |from: usize, to: usize| rjmp((to - from - 1) as i16);
    words[0] = jump(0, words.len());
    words.extend(main);
    for &(number, handler) in handlers {
        words[2 * number] = jump(2 * number, words.len());
        words.extend(handler);
    }
    words
}
