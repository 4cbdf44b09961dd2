//! Decodes AVR instructions, as far as r0 and the flow of control are concerned.

use std::fmt;
use std::sync::LazyLock;

use super::opcodes::{Control, TABLE, Use};

/// I/O address of the status register, SREG.
const SREG_IO: u32 = 0x3f;
/// The same register's address in the data space.
const SREG_DATA: u32 = 0x5f;

/// An instruction, with what it means for r0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Instruction {
    /// Its length in bytes: 2 or 4.
    pub length: u32,
    /// How it reads r0, where it does.
    pub read: Option<Read>,
    /// What it leaves in r0, where it writes it.
    pub write: Option<Write>,
    /// Where control goes next.
    pub flow: Flow,
    text: String,
}

/// How an instruction reads r0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Read {
    /// As a value to work with.
    Value,
    /// To put it back into the status register: `out SREG, r0`.
    RestoresStatus,
    /// To save it, whatever it is: `push r0`.
    Saves,
}

/// What an instruction leaves in r0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Write {
    /// The low byte of a product.
    Product,
    /// The status register: `in r0, SREG`.
    Status,
    /// Anything else.
    Other,
}

/// Where control goes after an instruction. Targets are byte addresses in flash.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flow {
    /// To the next instruction.
    Next,
    /// To the next instruction or over it.
    Skip,
    /// To the next instruction or to the target.
    Branch(u32),
    /// To the target.
    Jump(u32),
    /// To the target, and back behind this instruction.
    Call(u32),
    /// To the address in Z.
    JumpIndirect,
    /// To the address in Z, and back behind this instruction.
    CallIndirect,
    /// Back to the caller.
    Return,
}

impl fmt::Display for Instruction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// A row of the table, ready to match: 16-bit patterns stand in the upper half.
struct Row {
    fixed: u32,
    value: u32,
    pattern: String,
    name: &'static str,
    uses: Use,
    control: Control,
}

static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| {
    let row = |&(pattern, name, uses, control): &(&str, &'static str, Use, Control)| {
        let pattern = format!("{:_<32}", pattern.replace(' ', ""));
        let bits = |one: fn(char) -> bool| {
            pattern
                .chars()
                .fold(0, |bits, c| bits << 1 | u32::from(one(c)))
        };
        Row {
            fixed: bits(|c| c.is_ascii_digit()),
            value: bits(|c| c == '1'),
            pattern,
            name,
            uses,
            control,
        }
    };
    TABLE.iter().map(row).collect()
});

/// Decodes the instruction that `code` begins with and that stands at byte `address` of flash.
/// `None` if there is none that an ATmega328P knows.
pub fn decode(address: u32, code: &[u8]) -> Option<Instruction> {
    let word = |at: usize| {
        Some(u32::from(u16::from_le_bytes(
            code.get(at..at + 2)?.try_into().ok()?,
        )))
    };
    let bits = word(0)? << 16 | word(2).unwrap_or(0);
    let row = ROWS.iter().find(|row| bits & row.fixed == row.value)?;
    if row.length() == 4 {
        word(2)?;
    }
    Some(row.instruction(address, bits))
}

impl Row {
    fn length(&self) -> u32 {
        if self.pattern.ends_with('_') { 2 } else { 4 }
    }

    /// The operand made of the bits marked with `letter`, and how many they are.
    fn operand(&self, letter: char, bits: u32) -> Option<(u32, u32)> {
        let marked = self.pattern.chars().zip((0..32).rev());
        marked
            .filter(|&(c, _)| c == letter)
            .map(|(_, shift)| bits >> shift & 1)
            .fold(None, |sum, bit| {
                let (value, count) = sum.unwrap_or((0, 0));
                Some((value << 1 | bit, count + 1))
            })
    }

    /// The number of the register in field `letter`: shorter fields can name fewer registers.
    fn register(&self, letter: char, bits: u32) -> Option<u32> {
        let (value, count) = self.operand(letter, bits)?;
        Some(match count {
            5 => value,
            4 if self.name == "movw" => 2 * value,
            2 => 24 + 2 * value,
            _ => 16 + value,
        })
    }

    fn instruction(&self, address: u32, bits: u32) -> Instruction {
        let (d, r) = (self.register('d', bits), self.register('r', bits));
        let io = self.operand('A', bits).map(|(io, _)| io);
        let memory = self.operand('k', bits).map(|(address, _)| address);
        let status =
            io == Some(SREG_IO) || matches!(self.name, "lds" | "sts") && memory == Some(SREG_DATA);

        // `eor r0, r0` and its like give a result that does not depend on r0.
        let clears = matches!(self.name, "eor" | "sub" | "sbc") && d == r;
        let reads_d =
            matches!(self.uses, Use::Reads | Use::Changes | Use::Multiplies) && d == Some(0);
        let reads = (reads_d || r == Some(0)) && !clears || self.uses == Use::StoresR0;
        let writes_d = matches!(self.uses, Use::Writes | Use::Changes) && d == Some(0);

        Instruction {
            length: self.length(),
            read: reads.then_some(match self.name {
                "push" => Read::Saves,
                _ if status => Read::RestoresStatus,
                _ => Read::Value,
            }),
            write: match self.uses {
                Use::Multiplies => Some(Write::Product),
                Use::LoadsR0 => Some(Write::Other),
                _ if writes_d && status => Some(Write::Status),
                _ if writes_d => Some(Write::Other),
                _ => None,
            },
            flow: self.flow(address, bits),
            text: self.text(d, r, status),
        }
    }

    fn flow(&self, address: u32, bits: u32) -> Flow {
        let next = address + self.length();
        let target = || {
            let (words, count) = self.operand('k', bits).unwrap_or((0, 1));
            match count {
                22 => words << 1,
                // A signed offset in words: its sign is the field's uppermost bit.
                _ => {
                    let unused = 32 - count;
                    let offset = (words << unused).cast_signed() >> unused;
                    next.wrapping_add_signed(2 * offset)
                }
            }
        };
        match self.control {
            Control::Proceeds => Flow::Next,
            Control::Skips => Flow::Skip,
            Control::Branches => Flow::Branch(target()),
            Control::Jumps => Flow::Jump(target()),
            // `rcall .+0` only makes room on the stack.
            Control::Calls if target() == next => Flow::Next,
            Control::Calls => Flow::Call(target()),
            Control::JumpsZ => Flow::JumpIndirect,
            Control::CallsZ => Flow::CallIndirect,
            Control::Returns => Flow::Return,
        }
    }

    /// The mnemonic and its registers; other operands are left out.
    fn text(&self, d: Option<u32>, r: Option<u32>, status: bool) -> String {
        let name = |number| format!("r{number}");
        let status = status.then(|| "SREG".to_owned());
        let operands = match self.name {
            "out" | "sts" => [status, r.map(name)],
            _ => [d.map(name), r.map(name).or(status)],
        };
        let operands: Vec<_> = operands.into_iter().flatten().collect();
        format!("{} {}", self.name, operands.join(", "))
            .trim_end()
            .to_owned()
    }
}
