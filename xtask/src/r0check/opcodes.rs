//! The opcode table of Microchip's *AVR Instruction Set Manual* (DS40002198) for the AVRe+ core of
//! the ATmega328P, in the manual's notation: `d` the first register, `r` the second, `k` an
//! address or offset, `A` an I/O address; `x` is any other operand bit.

use self::Control::{Branches, Calls, CallsZ, Jumps, JumpsZ, Proceeds, Returns, Skips};
use self::Use::{Changes, LoadsR0, Multiplies, Neither, Reads, StoresR0, Writes};

/// What an instruction does with its register `d`; register `r` is always only read.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Use {
    Neither,
    Reads,
    Writes,
    Changes,
    /// Reads `d` and leaves the product in r1:r0.
    Multiplies,
    /// `lpm` and `elpm` without operands.
    LoadsR0,
    /// `spm` takes the word in r1:r0.
    StoresR0,
}

/// Where control goes after the instruction, before its operands are known.
#[derive(Clone, Copy)]
pub enum Control {
    Proceeds,
    Skips,
    Branches,
    Jumps,
    JumpsZ,
    Calls,
    CallsZ,
    Returns,
}

#[rustfmt::skip]
pub const TABLE: &[(&str, &str, Use, Control)] = &[
    ("0000 0000 0000 0000", "nop",    Neither,    Proceeds),
    ("0000 0001 dddd rrrr", "movw",   Writes,     Proceeds),
    ("0000 0010 dddd rrrr", "muls",   Multiplies, Proceeds),
    ("0000 0011 0ddd 0rrr", "mulsu",  Multiplies, Proceeds),
    ("0000 0011 0ddd 1rrr", "fmul",   Multiplies, Proceeds),
    ("0000 0011 1ddd 0rrr", "fmuls",  Multiplies, Proceeds),
    ("0000 0011 1ddd 1rrr", "fmulsu", Multiplies, Proceeds),
    ("0000 01rd dddd rrrr", "cpc",    Reads,      Proceeds),
    ("0000 10rd dddd rrrr", "sbc",    Changes,    Proceeds),
    ("0000 11rd dddd rrrr", "add",    Changes,    Proceeds),
    ("0001 00rd dddd rrrr", "cpse",   Reads,      Skips),
    ("0001 01rd dddd rrrr", "cp",     Reads,      Proceeds),
    ("0001 10rd dddd rrrr", "sub",    Changes,    Proceeds),
    ("0001 11rd dddd rrrr", "adc",    Changes,    Proceeds),
    ("0010 00rd dddd rrrr", "and",    Changes,    Proceeds),
    ("0010 01rd dddd rrrr", "eor",    Changes,    Proceeds),
    ("0010 10rd dddd rrrr", "or",     Changes,    Proceeds),
    ("0010 11rd dddd rrrr", "mov",    Writes,     Proceeds),
    ("0011 xxxx dddd xxxx", "cpi",    Reads,      Proceeds),
    ("0100 xxxx dddd xxxx", "sbci",   Changes,    Proceeds),
    ("0101 xxxx dddd xxxx", "subi",   Changes,    Proceeds),
    ("0110 xxxx dddd xxxx", "ori",    Changes,    Proceeds),
    ("0111 xxxx dddd xxxx", "andi",   Changes,    Proceeds),
    ("10x0 xx0d dddd xxxx", "ldd",    Writes,     Proceeds),
    ("10x0 xx1r rrrr xxxx", "std",    Neither,    Proceeds),
    ("1001 000d dddd 0000 kkkk kkkk kkkk kkkk", "lds", Writes, Proceeds),
    ("1001 001r rrrr 0000 kkkk kkkk kkkk kkkk", "sts", Neither, Proceeds),
    ("1001 000d dddd 0001", "ld",     Writes,     Proceeds), // Z+
    ("1001 000d dddd 0010", "ld",     Writes,     Proceeds), // -Z
    ("1001 000d dddd 010x", "lpm",    Writes,     Proceeds),
    ("1001 000d dddd 1001", "ld",     Writes,     Proceeds), // Y+
    ("1001 000d dddd 1010", "ld",     Writes,     Proceeds), // -Y
    ("1001 000d dddd 1100", "ld",     Writes,     Proceeds), // X
    ("1001 000d dddd 1101", "ld",     Writes,     Proceeds), // X+
    ("1001 000d dddd 1110", "ld",     Writes,     Proceeds), // -X
    ("1001 000d dddd 1111", "pop",    Writes,     Proceeds),
    ("1001 001r rrrr 0001", "st",     Neither,    Proceeds), // Z+
    ("1001 001r rrrr 0010", "st",     Neither,    Proceeds), // -Z
    ("1001 001r rrrr 1001", "st",     Neither,    Proceeds), // Y+
    ("1001 001r rrrr 1010", "st",     Neither,    Proceeds), // -Y
    ("1001 001r rrrr 1100", "st",     Neither,    Proceeds), // X
    ("1001 001r rrrr 1101", "st",     Neither,    Proceeds), // X+
    ("1001 001r rrrr 1110", "st",     Neither,    Proceeds), // -X
    ("1001 001r rrrr 1111", "push",   Neither,    Proceeds),
    ("1001 010d dddd 0000", "com",    Changes,    Proceeds),
    ("1001 010d dddd 0001", "neg",    Changes,    Proceeds),
    ("1001 010d dddd 0010", "swap",   Changes,    Proceeds),
    ("1001 010d dddd 0011", "inc",    Changes,    Proceeds),
    ("1001 010d dddd 0101", "asr",    Changes,    Proceeds),
    ("1001 010d dddd 0110", "lsr",    Changes,    Proceeds),
    ("1001 010d dddd 0111", "ror",    Changes,    Proceeds),
    ("1001 010d dddd 1010", "dec",    Changes,    Proceeds),
    ("1001 0100 0xxx 1000", "bset",   Neither,    Proceeds),
    ("1001 0100 1xxx 1000", "bclr",   Neither,    Proceeds),
    ("1001 0100 0000 1001", "ijmp",   Neither,    JumpsZ),
    ("1001 0101 0000 1000", "ret",    Neither,    Returns),
    ("1001 0101 0000 1001", "icall",  Neither,    CallsZ),
    ("1001 0101 0001 1000", "reti",   Neither,    Returns),
    ("1001 0101 1000 1000", "sleep",  Neither,    Proceeds),
    ("1001 0101 1001 1000", "break",  Neither,    Proceeds),
    ("1001 0101 1010 1000", "wdr",    Neither,    Proceeds),
    ("1001 0101 1100 1000", "lpm",    LoadsR0,    Proceeds),
    ("1001 0101 1110 1000", "spm",    StoresR0,   Proceeds),
    ("1001 010k kkkk 110k kkkk kkkk kkkk kkkk", "jmp", Neither, Jumps),
    ("1001 010k kkkk 111k kkkk kkkk kkkk kkkk", "call", Neither, Calls),
    ("1001 0110 xxdd xxxx", "adiw",   Changes,    Proceeds),
    ("1001 0111 xxdd xxxx", "sbiw",   Changes,    Proceeds),
    ("1001 1000 xxxx xxxx", "cbi",    Neither,    Proceeds),
    ("1001 1001 xxxx xxxx", "sbic",   Neither,    Skips),
    ("1001 1010 xxxx xxxx", "sbi",    Neither,    Proceeds),
    ("1001 1011 xxxx xxxx", "sbis",   Neither,    Skips),
    ("1001 11rd dddd rrrr", "mul",    Multiplies, Proceeds),
    ("1011 0AAd dddd AAAA", "in",     Writes,     Proceeds),
    ("1011 1AAr rrrr AAAA", "out",    Neither,    Proceeds),
    ("1100 kkkk kkkk kkkk", "rjmp",   Neither,    Jumps),
    ("1101 kkkk kkkk kkkk", "rcall",  Neither,    Calls),
    ("1110 xxxx dddd xxxx", "ldi",    Writes,     Proceeds),
    ("1111 00kk kkkk kxxx", "brbs",   Neither,    Branches),
    ("1111 01kk kkkk kxxx", "brbc",   Neither,    Branches),
    ("1111 100d dddd 0xxx", "bld",    Changes,    Proceeds),
    ("1111 101d dddd 0xxx", "bst",    Reads,      Proceeds),
    ("1111 110r rrrr 0xxx", "sbrc",   Neither,    Skips),
    ("1111 111r rrrr 0xxx", "sbrs",   Neither,    Skips),
];
