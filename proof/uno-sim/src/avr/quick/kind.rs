//! What an opcode asks for, as far as it is quick (AVR Instruction Set Manual, DS40002198).

use std::sync::LazyLock;

/// The kinds of quick instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// simavr executes it.
    Slow,
    Nop,
    Movw,
    Cpc,
    Sbc,
    Add,
    Adc,
    Cpse,
    Cp,
    Sub,
    And,
    Eor,
    Or,
    Mov,
    Cpi,
    Sbci,
    Subi,
    Ori,
    Andi,
    LddY,
    LddZ,
    StdY,
    StdZ,
    Lds,
    Sts,
    LdX,
    LdXInc,
    LdYInc,
    LdZInc,
    StX,
    StXInc,
    StYInc,
    StZInc,
    Lpm,
    LpmInc,
    Push,
    Pop,
    Com,
    Neg,
    Swap,
    Inc,
    Dec,
    Asr,
    Lsr,
    Ror,
    Adiw,
    Sbiw,
    Ijmp,
    Icall,
    Ret,
    Jmp,
    Call,
    Rjmp,
    Rcall,
    Ldi,
    Brbs,
    Brbc,
    Bld,
    Bst,
    Sbrc,
    Sbrs,
    Bset,
    Bclr,
}

/// Mask and value of an opcode of each kind.
const PATTERNS: [(u16, u16, Kind); 64] = [
    (0xFFFF, 0x0000, Kind::Nop),
    (0xFF00, 0x0100, Kind::Movw),
    (0xFC00, 0x0400, Kind::Cpc),
    (0xFC00, 0x0800, Kind::Sbc),
    (0xFC00, 0x0C00, Kind::Add),
    (0xFC00, 0x1000, Kind::Cpse),
    (0xFC00, 0x1400, Kind::Cp),
    (0xFC00, 0x1800, Kind::Sub),
    (0xFC00, 0x1C00, Kind::Adc),
    (0xFC00, 0x2000, Kind::And),
    (0xFC00, 0x2400, Kind::Eor),
    (0xFC00, 0x2800, Kind::Or),
    (0xFC00, 0x2C00, Kind::Mov),
    (0xF000, 0x3000, Kind::Cpi),
    (0xF000, 0x4000, Kind::Sbci),
    (0xF000, 0x5000, Kind::Subi),
    (0xF000, 0x6000, Kind::Ori),
    (0xF000, 0x7000, Kind::Andi),
    (0xD208, 0x8000, Kind::LddZ),
    (0xD208, 0x8008, Kind::LddY),
    (0xD208, 0x8200, Kind::StdZ),
    (0xD208, 0x8208, Kind::StdY),
    (0xFE0F, 0x9000, Kind::Lds),
    (0xFE0F, 0x9001, Kind::LdZInc),
    (0xFE0F, 0x9004, Kind::Lpm),
    (0xFE0F, 0x9005, Kind::LpmInc),
    (0xFE0F, 0x9009, Kind::LdYInc),
    (0xFE0F, 0x900C, Kind::LdX),
    (0xFE0F, 0x900D, Kind::LdXInc),
    (0xFE0F, 0x900F, Kind::Pop),
    (0xFE0F, 0x9200, Kind::Sts),
    (0xFE0F, 0x9201, Kind::StZInc),
    (0xFE0F, 0x9209, Kind::StYInc),
    (0xFE0F, 0x920C, Kind::StX),
    (0xFE0F, 0x920D, Kind::StXInc),
    (0xFE0F, 0x920F, Kind::Push),
    (0xFE0F, 0x9400, Kind::Com),
    (0xFE0F, 0x9401, Kind::Neg),
    (0xFE0F, 0x9402, Kind::Swap),
    (0xFE0F, 0x9403, Kind::Inc),
    (0xFE0F, 0x9405, Kind::Asr),
    (0xFE0F, 0x9406, Kind::Lsr),
    (0xFE0F, 0x9407, Kind::Ror),
    (0xFE0F, 0x940A, Kind::Dec),
    (0xFFFF, 0x9409, Kind::Ijmp),
    (0xFFFF, 0x9508, Kind::Ret),
    (0xFFFF, 0x9509, Kind::Icall),
    // Flag I decides on interrupts.
    (0xFFFF, 0x9478, Kind::Slow),
    (0xFFFF, 0x94F8, Kind::Slow),
    (0xFF8F, 0x9408, Kind::Bset),
    (0xFF8F, 0x9488, Kind::Bclr),
    // Of 22 bits, the upper six are 0.
    (0xFFFF, 0x940C, Kind::Jmp),
    (0xFFFF, 0x940E, Kind::Call),
    (0xFF00, 0x9600, Kind::Adiw),
    (0xFF00, 0x9700, Kind::Sbiw),
    (0xF000, 0xC000, Kind::Rjmp),
    (0xF000, 0xD000, Kind::Rcall),
    (0xF000, 0xE000, Kind::Ldi),
    (0xFC00, 0xF000, Kind::Brbs),
    (0xFC00, 0xF400, Kind::Brbc),
    (0xFE08, 0xF800, Kind::Bld),
    (0xFE08, 0xFA00, Kind::Bst),
    (0xFE08, 0xFC00, Kind::Sbrc),
    (0xFE08, 0xFE00, Kind::Sbrs),
];

/// The kind of each opcode.
pub static KINDS: LazyLock<Box<[Kind; 1 << 16]>> = LazyLock::new(|| {
    let mut kinds = Box::new([Kind::Slow; 1 << 16]);
    for (opcode, kind) in (0..=u16::MAX).zip(kinds.iter_mut()) {
        let of_it = PATTERNS
            .iter()
            .find(|(mask, value, _)| opcode & mask == *value);
        *kind = of_it.map_or(Kind::Slow, |(_, _, kind)| *kind);
    }
    kinds
});

/// Whether the instruction that begins with this opcode has a second word.
pub fn is_long(opcode: u16) -> bool {
    opcode & 0xFC0F == 0x9000 || opcode & 0xFE0C == 0x940C
}
