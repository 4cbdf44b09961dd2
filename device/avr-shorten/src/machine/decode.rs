//! Instructions as the machine runs them (AVR Instruction Set Manual, DS40002198).

use crate::assembly::Code;
use crate::effects::register;
use crate::operands::number;

/// An instruction. Registers are 0 to 31, a pair is named by its low one, I/O addresses are those of `in`.
#[derive(Clone, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the fields are the operands")]
pub enum Op {
    /// `d = r`
    Move { to: u8, from: Value },
    /// Two registers at once.
    MovePair { to: u8, from: u8 },
    /// `d = d + r`, with the carry or without.
    Add { to: u8, from: u8, carry: bool },
    /// `d = d - v`, with the carry or without; a comparison keeps only the flags.
    Subtract {
        to: u8,
        value: Value,
        carry: bool,
        keep: bool,
    },
    /// `and`, `or`, `eor`, with a register or a constant.
    Logic { how: Logic, to: u8, value: Value },
    /// An operation on one register.
    One { how: One, register: u8 },
    /// `adiw` by a number, `sbiw` by a negative one.
    AddWord { to: u8, by: i16 },
    /// Sets a flag or clears it.
    Flag { bit: u8, set: bool },
    /// Bit of a register to T.
    StoreBit { from: u8, bit: u8 },
    /// T to a bit of a register.
    LoadBit { to: u8, bit: u8 },
    /// From an address in data space.
    Load { to: u8, from: Place },
    /// To an address in data space.
    Store { to: Place, from: u8 },
    /// Sets a bit at an I/O address, or clears it.
    Bit { address: u16, bit: u8, set: bool },
    /// From program memory, by Z.
    LoadProgram { to: u8, moves: bool },
    /// Onto the stack.
    Push(u8),
    /// From the stack.
    Pop(u8),
    /// Skips the next instruction if a bit of a register is set, or clear.
    SkipBit { register: u8, bit: u8, set: bool },
    /// The same for a bit at an I/O address.
    SkipIo { address: u16, bit: u8, set: bool },
    /// Skips the next instruction if two registers are equal.
    SkipEqual(u8, u8),
    /// Goes to a label if a flag is set, or clear.
    Branch { bit: u8, set: bool, target: String },
    /// Goes to a label.
    Jump(String),
    /// Calls a label.
    Call(String),
    /// Calls where Z points.
    CallPointer,
    /// Goes where Z points.
    JumpPointer,
    /// Back to the caller.
    Return,
    /// Back from an interrupt.
    ReturnFromInterrupt,
    /// `wdr`, `sleep`: seen from outside.
    Signal(&'static str),
    /// Nothing.
    Nop,
}

/// A register or a constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Value {
    /// What a register holds.
    Register(u8),
    /// A constant.
    Constant(u8),
}

/// How two bytes are joined bit by bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Logic {
    /// Both.
    And,
    /// One or both.
    Or,
    /// One but not both.
    Xor,
}

/// What is done to one register.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "their mnemonics say it")]
pub enum One {
    Com,
    Neg,
    Inc,
    Dec,
    Swap,
    Lsr,
    Asr,
    Ror,
}

/// An address in data space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the fields are the operands")]
pub enum Place {
    /// As `lds` and `in` name it.
    Fixed(u16),
    /// By a pointer, with an offset.
    Pointer { low: u8, offset: u16 },
    /// By a pointer that is raised afterwards.
    Raised { low: u8 },
    /// By a pointer that is lowered before.
    Lowered { low: u8 },
}

/// The flags by their bits in SREG.
#[allow(missing_docs, reason = "the datasheet's names")]
pub mod flag {
    pub const C: u8 = 0;
    pub const Z: u8 = 1;
    pub const N: u8 = 2;
    pub const V: u8 = 3;
    pub const S: u8 = 4;
    pub const H: u8 = 5;
    pub const T: u8 = 6;
    pub const I: u8 = 7;
}

/// What I/O addresses are moved by in data space.
const IO: u16 = 0x20;

/// Reads an instruction. `None` if it is not known: then nothing can be said of the code around it.
pub fn decode(code: &Code) -> Option<Op> {
    let reg = |n: usize| register(code.operand(n)).map(|number| number as u8);
    let word = |n: usize| value(code.operand(n));
    let byte = |n: usize| word(n).map(|word| word as u8);
    let bit = |n: usize| byte(n).filter(|bit| *bit < 8);
    let io = |n: usize| word(n).filter(|at| *at < 0x40).map(|at| at + IO);
    let label = || Some(code.operand(0).to_owned()).filter(|label| !label.is_empty());
    let by = |n: usize| reg(n).map(Value::Register);
    let constant = |n: usize| byte(n).map(Value::Constant);
    let subtract = |value: Option<Value>, carry, keep| {
        let (to, value) = (reg(0)?, value?);
        Some(Op::Subtract {
            to,
            value,
            carry,
            keep,
        })
    };
    let logic = |how, value: Option<Value>| {
        let (to, value) = (reg(0)?, value?);
        Some(Op::Logic { how, to, value })
    };
    let one = |how| reg(0).map(|register| Op::One { how, register });
    let add = |from: Option<u8>, carry| {
        let (to, from) = (reg(0)?, from?);
        Some(Op::Add { to, from, carry })
    };
    let words = |sign: i16| {
        let by = word(1).filter(|by| *by < 64)? as i16 * sign;
        Some(Op::AddWord { to: reg(0)?, by })
    };
    let set = |bit, set| Some(Op::Flag { bit, set });
    match code.name.as_str() {
        "mov" => Some(Op::Move {
            to: reg(0)?,
            from: by(1)?,
        }),
        "ldi" => Some(Op::Move {
            to: reg(0)?,
            from: constant(1)?,
        }),
        "ser" => Some(Op::Move {
            to: reg(0)?,
            from: Value::Constant(0xFF),
        }),
        "movw" => Some(Op::MovePair {
            to: reg(0).filter(|n| n % 2 == 0)?,
            from: reg(1).filter(|n| n % 2 == 0)?,
        }),
        "add" => add(reg(1), false),
        "adc" => add(reg(1), true),
        "lsl" => add(reg(0), false),
        "rol" => add(reg(0), true),
        "sub" => subtract(by(1), false, true),
        "subi" => subtract(constant(1), false, true),
        "sbc" => subtract(by(1), true, true),
        "sbci" => subtract(constant(1), true, true),
        "cp" => subtract(by(1), false, false),
        "cpi" => subtract(constant(1), false, false),
        "cpc" => subtract(by(1), true, false),
        "and" => logic(Logic::And, by(1)),
        "andi" => logic(Logic::And, constant(1)),
        "tst" => logic(Logic::And, by(0)),
        "or" => logic(Logic::Or, by(1)),
        "ori" => logic(Logic::Or, constant(1)),
        "eor" => logic(Logic::Xor, by(1)),
        "clr" => logic(Logic::Xor, by(0)),
        "com" => one(One::Com),
        "neg" => one(One::Neg),
        "inc" => one(One::Inc),
        "dec" => one(One::Dec),
        "swap" => one(One::Swap),
        "lsr" => one(One::Lsr),
        "asr" => one(One::Asr),
        "ror" => one(One::Ror),
        "adiw" => words(1),
        "sbiw" => words(-1),
        "sec" => set(flag::C, true),
        "clc" => set(flag::C, false),
        "set" => set(flag::T, true),
        "clt" => set(flag::T, false),
        "sei" => set(flag::I, true),
        "cli" => set(flag::I, false),
        "bst" => Some(Op::StoreBit {
            from: reg(0)?,
            bit: bit(1)?,
        }),
        "bld" => Some(Op::LoadBit {
            to: reg(0)?,
            bit: bit(1)?,
        }),
        "in" => Some(Op::Load {
            to: reg(0)?,
            from: Place::Fixed(io(1)?),
        }),
        "lds" => Some(Op::Load {
            to: reg(0)?,
            from: Place::Fixed(word(1)?),
        }),
        "ld" | "ldd" => Some(Op::Load {
            to: reg(0)?,
            from: place(code.operand(1))?,
        }),
        "out" => Some(Op::Store {
            to: Place::Fixed(io(0)?),
            from: reg(1)?,
        }),
        "sts" => Some(Op::Store {
            to: Place::Fixed(word(0)?),
            from: reg(1)?,
        }),
        "st" | "std" => Some(Op::Store {
            to: place(code.operand(0))?,
            from: reg(1)?,
        }),
        "sbi" | "cbi" => Some(Op::Bit {
            address: io(0)?,
            bit: bit(1)?,
            set: code.name == "sbi",
        }),
        "lpm" if code.operands.len() == 2 => Some(Op::LoadProgram {
            to: reg(0)?,
            moves: match code.operand(1) {
                "Z" => false,
                "Z+" => true,
                _ => return None,
            },
        }),
        "push" => reg(0).map(Op::Push),
        "pop" => reg(0).map(Op::Pop),
        "sbrc" | "sbrs" => Some(Op::SkipBit {
            register: reg(0)?,
            bit: bit(1)?,
            set: code.name == "sbrs",
        }),
        "sbic" | "sbis" => Some(Op::SkipIo {
            address: io(0)?,
            bit: bit(1)?,
            set: code.name == "sbis",
        }),
        "cpse" => Some(Op::SkipEqual(reg(0)?, reg(1)?)),
        "jmp" | "rjmp" => label().map(Op::Jump),
        "call" | "rcall" => label().map(Op::Call),
        "icall" => Some(Op::CallPointer),
        "ijmp" => Some(Op::JumpPointer),
        "ret" => Some(Op::Return),
        "reti" => Some(Op::ReturnFromInterrupt),
        "wdr" => Some(Op::Signal("wdr")),
        "sleep" => Some(Op::Signal("sleep")),
        "nop" => Some(Op::Nop),
        name => {
            let (bit, set) = condition(name)?;
            let target = label()?;
            Some(Op::Branch { bit, set, target })
        }
    }
}

/// The flag that a branch looks at, and whether it goes where that is set.
fn condition(name: &str) -> Option<(u8, bool)> {
    Some(match name {
        "breq" => (flag::Z, true),
        "brne" => (flag::Z, false),
        "brlo" | "brcs" => (flag::C, true),
        "brsh" | "brcc" => (flag::C, false),
        "brmi" => (flag::N, true),
        "brpl" => (flag::N, false),
        "brvs" => (flag::V, true),
        "brvc" => (flag::V, false),
        "brlt" => (flag::S, true),
        "brge" => (flag::S, false),
        "brhs" => (flag::H, true),
        "brhc" => (flag::H, false),
        "brts" => (flag::T, true),
        "brtc" => (flag::T, false),
        "brie" => (flag::I, true),
        "brid" => (flag::I, false),
        _ => return None,
    })
}

fn place(text: &str) -> Option<Place> {
    let low = |c: char| match c {
        'X' => Some(26),
        'Y' => Some(28),
        'Z' => Some(30),
        _ => None,
    };
    if let Some(base) = text.strip_prefix('-') {
        let low = low(base.chars().next()?)?;
        return Some(Place::Lowered { low });
    }
    let low = low(text.chars().next()?)?;
    match text.get(1..)? {
        "" => Some(Place::Pointer { low, offset: 0 }),
        "+" => Some(Place::Raised { low }),
        offset => {
            let offset = u16::try_from(number(offset.strip_prefix('+')?)?).ok()?;
            Some(Place::Pointer { low, offset })
        }
    }
}

/// What a number or an address comes to. The linker's addresses are not known yet: each symbol gets one of
/// its own in RAM, the same in every run.
fn value(text: &str) -> Option<u16> {
    let text = text.trim();
    if let Some(number) = number(text) {
        return Some(number as u16);
    }
    if let Some(inner) = text.strip_suffix(')') {
        let (name, inner) = inner.split_once('(')?;
        let inner = value(inner)?;
        return match name {
            "lo8" => Some(inner & 0xFF),
            "hi8" => Some(inner >> 8),
            "pm_lo8" => Some(inner >> 1 & 0xFF),
            "pm_hi8" => Some(inner >> 9),
            "gs" | "pm" => Some(inner >> 1),
            "" => Some(inner),
            "-" => Some(inner.wrapping_neg()),
            _ => None,
        };
    }
    if let Some((base, offset)) = text.rsplit_once('+') {
        return Some(value(base)?.wrapping_add(value(offset)?));
    }
    if let Some((base, offset)) = text.rsplit_once('-').filter(|(base, _)| !base.is_empty()) {
        return Some(value(base)?.wrapping_sub(value(offset)?));
    }
    let plain = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '$');
    (!text.is_empty() && text.chars().all(plain)).then(|| {
        let hash = text.bytes().fold(0x811C_9DC5_u32, |hash, byte| {
            (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
        });
        0x100 + (hash >> 8) as u16 % 0x700
    })
}
