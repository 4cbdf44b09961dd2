//! The operators and their spellings: those of the norm, of its common extensions, and of the makers.

use crate::Dialect;
use unoclp_core::isa::Opcode;

/// What an instruction does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Op {
    Load,
    Store,
    Set,
    Reset,
    And,
    Or,
    Xor,
    Not,
    /// Arithmetic: the numeric code's own operation.
    Number(Opcode),
    /// A comparison.
    Compare(Opcode),
    /// Shift by a constant.
    Shift(Opcode),
    /// NEG, SQRT
    Unary(Opcode),
    /// EU, ED
    Edge(Opcode),
    Jump,
    Call,
    Return,
    /// TON, TOF, TP, TONR with a timer and its preset.
    Timer(Opcode),
    CountUp,
    CountDown,
    CountUpDown,
    /// ALD, ANB, AND LD; OLD, ORB, OR LD.
    AndBlock,
    OrBlock,
    /// BLK, OUT_BLK, END_BLK of the Twido.
    Block,
    OutBlock,
    EndBlock,
    /// IN, CU, CD: an input of the block.
    Input(Opcode),
    /// Numeric codes as they are.
    Code,
    /// A function of the file, called by its name.
    Function,
}

/// Which modifiers an operator may have, as in the course's Table 1.
pub(crate) struct Spelling {
    pub op: Op,
    pub negated: bool,
    pub conditional: bool,
    /// The maker whose spelling it is.
    pub dialect: Option<Dialect>,
}

impl Op {
    /// Whether N may follow the operator.
    pub(crate) fn may_negate(self) -> bool {
        matches!(self, Op::Load | Op::Store | Op::And | Op::Or | Op::Xor)
    }

    /// Whether it may have more than one operand.
    pub(crate) fn may_have_more(self) -> bool {
        matches!(
            self,
            Op::Timer(_) | Op::CountUp | Op::CountDown | Op::CountUpDown | Op::Function | Op::Code
        )
    }

    /// Whether a parenthesis may follow.
    pub(crate) fn may_defer(self) -> bool {
        matches!(
            self,
            Op::And | Op::Or | Op::Xor | Op::Number(_) | Op::Compare(_)
        )
    }
}

/// The operator with this spelling, in upper case.
pub(crate) fn find(word: &str) -> Option<Spelling> {
    let plain = |op| spelling(op, false, false, None);
    let maker = |op, negated, dialect| spelling(op, negated, false, Some(dialect));
    Some(match word {
        "LD" => plain(Op::Load),
        "ST" => plain(Op::Store),
        "S" => plain(Op::Set),
        "R" => plain(Op::Reset),
        "AND" => plain(Op::And),
        "OR" => plain(Op::Or),
        "XOR" => plain(Op::Xor),
        "NOT" => plain(Op::Not),
        "LDN" => spelling(Op::Load, true, false, None),
        "STN" => spelling(Op::Store, true, false, None),
        "ANDN" => spelling(Op::And, true, false, None),
        "ORN" => spelling(Op::Or, true, false, None),
        "XORN" => spelling(Op::Xor, true, false, None),
        "ADD" => plain(Op::Number(Opcode::Add)),
        "SUB" => plain(Op::Number(Opcode::Subtract)),
        "MUL" => plain(Op::Number(Opcode::Multiply)),
        "DIV" => plain(Op::Number(Opcode::Divide)),
        "MOD" => plain(Op::Number(Opcode::Modulo)),
        "GT" => plain(Op::Compare(Opcode::Greater)),
        "GE" => plain(Op::Compare(Opcode::GreaterOrEqual)),
        "EQ" => plain(Op::Compare(Opcode::Equal)),
        "NE" => plain(Op::Compare(Opcode::NotEqual)),
        "LE" => plain(Op::Compare(Opcode::LessOrEqual)),
        "LT" => plain(Op::Compare(Opcode::Less)),
        "SHL" => plain(Op::Shift(Opcode::ShiftLeft)),
        "SHR" => plain(Op::Shift(Opcode::ShiftRight)),
        "NEG" => plain(Op::Unary(Opcode::Negate)),
        "SQRT" => plain(Op::Unary(Opcode::SquareRoot)),
        "EU" => plain(Op::Edge(Opcode::RisingEdge)),
        "ED" => plain(Op::Edge(Opcode::FallingEdge)),
        "JMP" => plain(Op::Jump),
        "JMPC" => spelling(Op::Jump, false, true, None),
        "JMPCN" | "JMPNC" | "JMPN" => spelling(Op::Jump, true, true, None),
        "CAL" => plain(Op::Call),
        "CALC" => spelling(Op::Call, false, true, None),
        "CALCN" | "CALNC" | "CALN" => spelling(Op::Call, true, true, None),
        "RET" => plain(Op::Return),
        "RETC" => spelling(Op::Return, false, true, None),
        "RETCN" | "RETNC" | "RETN" => spelling(Op::Return, true, true, None),
        "TON" => plain(Op::Timer(Opcode::OnDelay)),
        "TOF" => plain(Op::Timer(Opcode::OffDelay)),
        "TP" => plain(Op::Timer(Opcode::Pulse)),
        "TONR" | "TOR" => plain(Op::Timer(Opcode::RetentiveOnDelay)),
        "CTU" => plain(Op::CountUp),
        "CTD" => plain(Op::CountDown),
        "CTUD" => plain(Op::CountUpDown),
        "IN" => plain(Op::Input(Opcode::OnDelay)),
        "CU" => plain(Op::Input(Opcode::CountUp)),
        "CD" => plain(Op::Input(Opcode::CountDown)),
        "CODE" => plain(Op::Code),
        "LDI" => maker(Op::Load, true, Dialect::Mitsubishi),
        "ANI" => maker(Op::And, true, Dialect::Mitsubishi),
        "ORI" => maker(Op::Or, true, Dialect::Mitsubishi),
        "OUT" => plain(Op::Store),
        "ANB" => maker(Op::AndBlock, false, Dialect::Mitsubishi),
        "ORB" => maker(Op::OrBlock, false, Dialect::Mitsubishi),
        "SET" => plain(Op::Set),
        "RST" => plain(Op::Reset),
        "A" => maker(Op::And, false, Dialect::S7200),
        "AN" => maker(Op::And, true, Dialect::S7200),
        "O" => maker(Op::Or, false, Dialect::S7200),
        "ON" => maker(Op::Or, true, Dialect::S7200),
        "ALD" => maker(Op::AndBlock, false, Dialect::S7200),
        "OLD" => maker(Op::OrBlock, false, Dialect::S7200),
        "BLK" => maker(Op::Block, false, Dialect::Twido),
        "OUT_BLK" => maker(Op::OutBlock, false, Dialect::Twido),
        "END_BLK" => maker(Op::EndBlock, false, Dialect::Twido),
        _ => return None,
    })
}

fn spelling(op: Op, negated: bool, conditional: bool, dialect: Option<Dialect>) -> Spelling {
    Spelling {
        op,
        negated,
        conditional,
        dialect,
    }
}

/// Every spelling that may have been meant by a wrong one.
pub(crate) const SPELLINGS: &[&str] = &[
    "LD", "LDN", "ST", "STN", "S", "R", "AND", "ANDN", "OR", "ORN", "XOR", "XORN", "NOT", "ADD",
    "SUB", "MUL", "DIV", "MOD", "GT", "GE", "EQ", "NE", "LE", "LT", "JMP", "JMPC", "JMPCN", "CAL",
    "CALC", "CALCN", "RET", "RETC", "RETCN", "TON", "TOF", "TP", "TONR", "CTU", "CTD", "CTUD",
    "LDI", "ANI", "ORI", "OUT", "SET", "RST", "ALD", "OLD", "BLK", "OUT_BLK", "END_BLK", "SHL",
    "SHR", "NEG", "SQRT",
];

/// The spelling that is one slip of the hand away: a letter wrong, missing or too many.
pub(crate) fn nearest(word: &str) -> Option<&'static str> {
    let known = |known: &&&str| one_slip(known.as_bytes(), word.as_bytes());
    SPELLINGS.iter().find(known).copied()
}

fn one_slip(a: &[u8], b: &[u8]) -> bool {
    let start = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[start..], &b[start..]);
    let end = a
        .iter()
        .rev()
        .zip(b.iter().rev())
        .take_while(|(a, b)| a == b)
        .count();
    let (a, b) = (&a[..a.len() - end], &b[..b.len() - end]);
    match (a, b) {
        ([w, x], [y, z]) => (w, x) == (z, y),
        _ => a.len().max(b.len()) == 1,
    }
}
