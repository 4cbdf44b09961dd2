//! What an instruction does, as far as the rules need to know: its length, where control goes, which
//! registers and flags it reads and writes.

use super::assembly::Code;

/// A set of registers and flags, a bit for each: r0 to r31, then [`CARRY`], [`FLAGS`] and [`T`].
pub type Set = u64;

/// The flag C.
pub const CARRY: Set = 1 << 32;
/// The flags Z, N, V, S and H together.
pub const FLAGS: Set = 1 << 33;
/// The flag T.
pub const T: Set = 1 << 34;
/// Everything.
pub const ALL: Set = (1 << 35) - 1;

/// What a called function may change: r0, r18 to r27, r30, r31, and the flags.
pub const CLOBBERED: Set = 1 | 0x0ffc_0000 | 0xc000_0000 | CARRY | FLAGS | T;
/// What a called function may take: arguments are in r8 to r25, and r1 is 0.
const ARGUMENTS: Set = 0x03ff_ff00 | 1 << 1;
/// What a caller may take when a function returns: the result is in r18 to r25; r2 to r17, r28 and
/// r29 are the caller's, and r1 is 0.
pub const RETURNED: Set = 0x03ff_fffe | 0x3000_0000;

/// Where control goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flow<'a> {
    /// To the next instruction.
    Next,
    /// To the next instruction or over it.
    Skip,
    /// To a label or to the next instruction.
    Branch(&'a str),
    /// To a label.
    Jump(&'a str),
    /// To a function, and back.
    Call(&'a str),
    /// To a pointer, and back.
    CallPointer,
    /// Back to the caller, or to a pointer.
    Leave,
}

/// What an instruction does.
#[derive(Clone, Copy, Debug)]
pub struct Effects {
    /// Registers and flags that it reads.
    pub reads: Set,
    /// Registers and flags that it writes.
    pub writes: Set,
}

/// The bytes of an instruction, at most: the linker makes half of `call` and `jmp` where that reaches.
pub fn bytes(code: &Code) -> usize {
    match code.name.as_str() {
        "call" | "jmp" | "lds" | "sts" => 4,
        _ => 2,
    }
}

/// The bytes of an instruction, at least.
pub fn short_bytes(code: &Code) -> usize {
    match code.name.as_str() {
        "call" | "jmp" => 2,
        _ => bytes(code),
    }
}

/// Where an instruction leads.
pub fn flow(code: &Code) -> Flow<'_> {
    let target = code.operand(0);
    match code.name.as_str() {
        "rjmp" | "jmp" => Flow::Jump(target),
        "call" | "rcall" => Flow::Call(target),
        "icall" => Flow::CallPointer,
        "ret" | "reti" | "ijmp" => Flow::Leave,
        "cpse" | "sbrc" | "sbrs" | "sbic" | "sbis" => Flow::Skip,
        "break" => Flow::Next,
        name if name.starts_with("br") => Flow::Branch(target),
        _ => Flow::Next,
    }
}

/// The condition that holds where that of a branch does not.
pub fn opposite(name: &str) -> Option<&'static str> {
    const PAIRS: [(&str, &str); 9] = [
        ("breq", "brne"),
        ("brlo", "brsh"),
        ("brcs", "brcc"),
        ("brmi", "brpl"),
        ("brlt", "brge"),
        ("brts", "brtc"),
        ("brvs", "brvc"),
        ("brhs", "brhc"),
        ("brie", "brid"),
    ];
    PAIRS.iter().find_map(|&(a, b)| match name {
        _ if name == a => Some(b),
        _ if name == b => Some(a),
        _ => None,
    })
}

/// Whether an instruction writes a register that unlocks another write for four cycles: of the watchdog,
/// the clock, the EEPROM, the program memory, the vectors (ATmega328P datasheet DS40002061, sections 8.6.3,
/// 9.12.2, 11.9.2, 12.5.1, 27.9.1).
pub fn is_timed(code: &Code) -> bool {
    let place = code.operand(0);
    match code.name.as_str() {
        "sts" => matches!(place, "96" | "97"),
        "out" | "sbi" | "cbi" => matches!(place, "31" | "53" | "55"),
        "spm" => true,
        _ => false,
    }
}

/// The number of a register operand.
pub fn register(operand: &str) -> Option<u32> {
    let number = operand.strip_prefix('r')?.parse().ok()?;
    (number < 32).then_some(number)
}

/// What an instruction reads and writes. One that is not known may do anything.
pub fn effects(code: &Code) -> Effects {
    known(code).unwrap_or(Effects {
        reads: ALL,
        writes: ALL,
    })
}

fn known(code: &Code) -> Option<Effects> {
    let one = |n: usize| register(code.operand(n)).map(|number| 1_u64 << number);
    let pair = |n: usize| one(n).map(|set| set | set << 1);
    let same = code.operand(0) == code.operand(1);
    let arithmetic = CARRY | FLAGS;
    let (reads, writes) = match code.name.as_str() {
        "mov" => (one(1)?, one(0)?),
        "movw" => (pair(1)?, pair(0)?),
        "ldi" => (0, one(0)?),
        "ser" => (0, one(0)?),
        "eor" if same => (0, one(0)? | FLAGS),
        "clr" => (0, one(0)? | FLAGS),
        "sub" if same => (0, one(0)? | arithmetic),
        "add" | "sub" => (one(0)? | one(1)?, one(0)? | arithmetic),
        // The flag Z goes on from one byte of a number to the next.
        "adc" | "sbc" => (one(0)? | one(1)? | arithmetic, one(0)? | arithmetic),
        "and" | "or" | "eor" => (one(0)? | one(1)?, one(0)? | FLAGS),
        "cp" => (one(0)? | one(1)?, arithmetic),
        "cpc" => (one(0)? | one(1)? | arithmetic, arithmetic),
        "cpi" => (one(0)?, arithmetic),
        "cpse" => (one(0)? | one(1)?, 0),
        "subi" | "neg" | "com" | "lsl" | "lsr" | "asr" => (one(0)?, one(0)? | arithmetic),
        "sbci" | "rol" | "ror" => (one(0)? | arithmetic, one(0)? | arithmetic),
        "andi" | "ori" | "inc" | "dec" => (one(0)?, one(0)? | FLAGS),
        "tst" => (one(0)?, FLAGS),
        "swap" => (one(0)?, one(0)?),
        "adiw" | "sbiw" => (pair(0)?, pair(0)? | arithmetic),
        "bst" => (one(0)?, T),
        "bld" => (one(0)? | T, one(0)?),
        "set" | "clt" => (0, T),
        "sec" | "clc" => (0, CARRY),
        "sbrc" | "sbrs" => (one(0)?, 0),
        "sbi" | "cbi" | "sbic" | "sbis" | "cli" | "sei" | "wdr" | "nop" | "sleep" | "rjmp" => {
            (0, 0)
        }
        "in" => (
            if code.operand(1) == "63" {
                ALL ^ 0xffff_ffff
            } else {
                0
            },
            one(0)?,
        ),
        "out" => (
            one(1)?,
            if code.operand(0) == "63" {
                ALL ^ 0xffff_ffff
            } else {
                0
            },
        ),
        "push" => (one(0)?, 0),
        "pop" => (0, one(0)?),
        "lds" => (0, one(0)?),
        "sts" => (one(1)?, 0),
        "ld" | "ldd" | "lpm" if code.operands.len() == 2 => {
            let (pointer, moved) = pointer(code.operand(1))?;
            (pointer, one(0)? | moved)
        }
        "st" | "std" => {
            let (pointer, moved) = pointer(code.operand(0))?;
            (pointer | one(1)?, moved)
        }
        "call" | "rcall" => (ARGUMENTS, CLOBBERED),
        "icall" => (ARGUMENTS | 0xc000_0000, CLOBBERED),
        "jmp" => (ARGUMENTS | RETURNED, 0),
        "ret" => (RETURNED, 0),
        name if name.starts_with("br") && name != "break" => match name {
            "brts" | "brtc" => (T, 0),
            "brlo" | "brsh" | "brcs" | "brcc" => (CARRY, 0),
            "brie" | "brid" => (0, 0),
            _ => (FLAGS, 0),
        },
        _ => return None,
    };
    Some(Effects { reads, writes })
}

/// The registers of a pointer operand, as `Y+3` or `-X`, and those of them that it moves.
fn pointer(operand: &str) -> Option<(Set, Set)> {
    let low = match operand.trim_matches('-').chars().next()? {
        'X' => 26,
        'Y' => 28,
        'Z' => 30,
        _ => return None,
    };
    let set = 3_u64 << low;
    let moves = operand.starts_with('-') || operand.ends_with('+');
    Some((set, if moves { set } else { 0 }))
}
