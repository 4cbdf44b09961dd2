//! The instruction table: every instruction, once.
//!
//! Decoding, encoding, listings and the table in `docs/numeric-code.md` come from the rows below. To add an instruction, add its row, and its effect in `plc.rs`.

use crate::{Delay, Point, TimerBlock};
use core::{fmt, slice};

/// What stands in the last two digits of a code or on the lines that follow it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operand {
    /// Nothing: the code is complete.
    None,
    /// Input XX of the board.
    Input,
    /// Output XX of the board.
    Output,
    /// Branch point XX of the rung, 01–08.
    Branch,
    /// Two lines: a preset in ms and `79XX`, an output.
    Timer,
}

/// One row of the instruction table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The code; where the operand is a point, with XX = 00.
    pub code: i32,
    /// What each pair of digits spells in ASCII.
    pub letters: &'static str,
    /// What the instruction works on.
    pub operand: Operand,
    /// The byte that stores it; where the operand is a point, its index fills the low four bits.
    pub stored: u8,
    /// The effect in one line.
    pub effect: &'static str,
}

/// The branch points of a rung are 01 to this number (NC-8).
pub const BRANCH_POINTS: u8 = 8;

/// The deepest nesting of branches (NC-8).
pub const DEEPEST: u8 = 8;

/// Program start, the first code of a file. It is checked and not stored.
pub const START: i32 = 0;

/// The code of an output as an operand line: `79XX` with XX = 00.
pub const OUTPUT_OPERAND: i32 = 7900;

/// Bytes that a timer block takes in the stored form: its byte, the preset, the output.
pub const STORED_TIMER_BYTES: usize = 6;

/// Bytes that a timer block takes in run memory: its stored form and the timer's data.
pub const LINKED_TIMER_BYTES: usize = STORED_TIMER_BYTES + crate::timer::DATA_BYTES;

/// The last two digits of a code, where all before them are those of `base`.
///
/// By subtraction: a division of 32 bits would take 1.5 KB of the firmware.
#[inline(never)]
pub(crate) fn xx(code: i32, base: i32) -> Option<u8> {
    let xx = if base < 0 {
        base.wrapping_sub(code)
    } else {
        code.wrapping_sub(base)
    };
    (0..100).contains(&xx).then_some(xx as u8)
}

/// Operands as the stored form holds them: in the low bits of the instruction's own byte, or in
/// the bytes after it.
trait StoredOperand: Sized {
    /// Reads the operand; none where the bytes end too soon.
    fn take(byte: u8, rest: &mut slice::Iter<'_, u8>) -> Option<Self>;
}

impl StoredOperand for Point {
    fn take(byte: u8, _: &mut slice::Iter<'_, u8>) -> Option<Point> {
        Some(Point::from_low_bits(byte))
    }
}

impl StoredOperand for TimerBlock {
    fn take(_: u8, rest: &mut slice::Iter<'_, u8>) -> Option<TimerBlock> {
        let mut next = || rest.next().copied();
        Some(TimerBlock {
            preset: u32::from_le_bytes([next()?, next()?, next()?, next()?]),
            output: Point::from_low_bits(next()?),
        })
    }
}

macro_rules! instructions {
    ($($name:ident $(($payload:ty))? $operand:ident $code:literal $letters:literal $stored:literal $effect:literal;)*) => {
        /// An instruction of a checked program: its operands exist.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Instruction {
            $(#[doc = $effect] $name $(($payload))?,)*
        }

        /// The instruction table, in the order of the stored bytes.
        pub const TABLE: &[Row] = &[$(Row {
            code: $code,
            letters: $letters,
            operand: Operand::$operand,
            stored: $stored,
            effect: $effect,
        },)*];

        /// An instruction without its operand.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(u8)]
        pub enum Opcode {
            $(#[doc = $effect] $name = $stored,)*
        }

        impl Opcode {
            /// The operand that this code takes.
            pub(crate) const fn operand(self) -> Operand {
                match self {
                    $(Opcode::$name => Operand::$operand,)*
                }
            }

            /// The opcode of an instruction's first stored byte. Where it takes a point, the low
            /// four bits hold its index; a timer block goes on with its preset, 4 bytes with the
            /// low one first, and the index of its output.
            pub const fn of_stored(byte: u8) -> Option<Opcode> {
                match if byte < 0x10 { byte } else { byte & 0xF0 } {
                    $($stored => Some(Opcode::$name),)*
                    _ => None,
                }
            }

            /// The opcode that a code spells, and its XX (0 where it takes no point).
            ///
            /// Rows are tried in order: a recall has the code of a store, and comes after it; the
            /// loader tells them apart by what stands before.
            pub(crate) fn decode(code: i32) -> Option<(Opcode, u8)> {
                $(
                    if const { Operand::$operand.is_point() } {
                        if let Some(xx) = xx(code, $code) {
                            return Some((Opcode::$name, xx));
                        }
                    } else if code == $code {
                        return Some((Opcode::$name, 0));
                    }
                )*
                None
            }
        }

        impl Instruction {
            /// The instruction that begins with this stored byte and takes its operand from the
            /// rest; none where no loader writes such bytes.
            pub(crate) fn from_stored(byte: u8, rest: &mut slice::Iter<'_, u8>) -> Option<Instruction> {
                let opcode = if byte < 0x10 { byte } else { byte & 0xF0 };
                match opcode {
                    $($stored => Some(Instruction::$name $((<$payload>::take(byte, rest)?))?),)*
                    _ => None,
                }
            }

            /// The row of the table that this instruction comes from.
            pub const fn row(self) -> &'static Row {
                match self {
                    $(Instruction::$name { .. } => const {
                        &Row {
                            code: $code,
                            letters: $letters,
                            operand: Operand::$operand,
                            stored: $stored,
                            effect: $effect,
                        }
                    },)*
                }
            }
        }
    };
}

instructions! {
    NewRung                    None   787600   "NL"  0x01 "new rung: acc := 1; the branch points of the rung before are forgotten";
    OpenBranch                 None   40       "("   0x02 "open an OR branch: push acc; acc := 1";
    CloseBranch                None   41       ")"   0x03 "close it: acc := popped value OR acc";
    OnDelay(TimerBlock)        Timer  847978   "TON" 0x04 "on-delay timer: IN = acc; acc := Q; output := Q";
    OffDelay(TimerBlock)       Timer  847970   "TOF" 0x05 "off-delay timer: IN = acc; acc := Q; output := Q";
    InputContact(Point)        Input  827300   "RI"  0x10 "contact, normally open: acc := acc AND input XX";
    InputContactNot(Point)     Input  -827300  "-RI" 0x20 "contact, normally closed: acc := acc AND NOT input XX";
    OutputContact(Point)       Output 827900   "RO"  0x30 "contact: acc := acc AND output XX, as the image stands now";
    OutputContactNot(Point)    Output -827900  "-RO" 0x40 "contact: acc := acc AND NOT output XX, as the image stands now";
    Coil(Point)                Output 877900   "WO"  0x50 "coil: output XX := acc";
    SetCoil(Point)             Output 83877900 "SWO" 0x60 "set coil: if acc = 1, output XX := 1";
    ResetCoil(Point)           Output 82877900 "RWO" 0x70 "reset coil: if acc = 1, output XX := 0";
    StoreBranch(Point)         Branch 404100   "()"  0x80 "OR store: remember acc as branch point XX";
    RecallBranch(Point)        Branch 404100   "()"  0x90 "as the very next code after 40: acc := what branch point XX remembers";
}

impl Operand {
    /// Whether the operand is a point, in the code's last two digits.
    pub const fn is_point(self) -> bool {
        matches!(self, Operand::Input | Operand::Output | Operand::Branch)
    }
}

impl Instruction {
    /// The point that the code names; none for a timer, whose output stands on a line of its own.
    pub const fn point(self) -> Option<Point> {
        use Instruction::*;
        match self {
            InputContact(p) | InputContactNot(p) | OutputContact(p) | OutputContactNot(p)
            | Coil(p) | SetCoil(p) | ResetCoil(p) | StoreBranch(p) | RecallBranch(p) => Some(p),
            NewRung | OpenBranch | CloseBranch | OnDelay(_) | OffDelay(_) => None,
        }
    }

    /// The operands of a timer block and which way it delays.
    pub const fn timer(self) -> Option<(Delay, TimerBlock)> {
        match self {
            Instruction::OnDelay(block) => Some((Delay::On, block)),
            Instruction::OffDelay(block) => Some((Delay::Off, block)),
            _ => None,
        }
    }

    /// The lines of a program file that say this instruction: its code, then its operands.
    pub fn codes(self) -> impl Iterator<Item = i32> {
        let row = self.row();
        let xx = self.point().map_or(0, |point| i32::from(point.number()));
        let operands = self.timer().map(|(_, block)| {
            // A preset fits 31 bits (NC-9).
            let preset = block.preset.cast_signed();
            [preset, OUTPUT_OPERAND + i32::from(block.output.number())]
        });
        core::iter::once(row.code + row.code.signum() * xx).chain(operands.into_iter().flatten())
    }
}

impl fmt::Display for Instruction {
    /// The letters: `RI 01`, `-RO 02`, `( )`, `TON 500 ms WO 01`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.row().letters)?;
        if let Some(point) = self.point() {
            write!(f, " {:02}", point.number())?;
        }
        if let Some((_, block)) = self.timer() {
            write!(f, " {} ms O {:02}", block.preset, block.output.number())?;
        }
        Ok(())
    }
}
