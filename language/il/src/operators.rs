//! The operators and their spellings: those of the standard, of its common extensions, and of the makers.

use crate::lexer::SECTIONS;
use crate::words::operator;
use std::sync::LazyLock;
use unoclp_core::isa::{Class, Kind, Opcode};
use unoclp_text::Dialect;

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
    /// PUSH
    Push,
    /// TABLE_LD, TABLE_ST: a table of registers, the first and how many.
    Table(Opcode),
    /// IF, ELSE, END_IF
    Part(Opcode),
    /// EU, ED: made of the accumulator alone.
    Edge(Opcode),
    Jump,
    Call,
    Return,
    /// MPS, MRD, MPP, and LPS, LRD, LPP of the S7-200: the accumulator is kept for branches.
    Keep,
    Recall,
    Release,
    /// PLS, PLF, DIFU, DIFD: the operand is 1 for the scan of an edge.
    Differentiate(Opcode),
    /// TIM and CNT of OMRON.
    OmronTimer,
    OmronCounter,
    /// END: the program's end, whatever follows.
    End,
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
    /// PT, PV: the preset of the operand is stored.
    Preset,
    /// IN, CU, CD, CLK: an input of the block.
    Input(Opcode),
    /// Numeric codes as they are.
    Code,
    /// A function of the file, called by its name.
    Function,
}

/// Which modifiers an operator may have, as in the course's Table 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spelling {
    pub op: Op,
    pub negated: bool,
    pub conditional: bool,
    /// LDP, ANDF: the edge of the operand is what counts.
    pub edge: Option<Opcode>,
    /// The maker whose spelling it is.
    pub dialect: Option<Dialect>,
}

impl Op {
    /// Whether N may follow the operator.
    pub(crate) fn may_negate(self) -> bool {
        matches!(self, Op::Load | Op::Store | Op::And | Op::Or | Op::Xor)
    }

    /// Whether it works on an operand, and not on the accumulator alone.
    pub(crate) fn takes_operand(self) -> bool {
        !matches!(
            self,
            Op::Not
                | Op::Unary(_)
                | Op::Push
                | Op::Part(_)
                | Op::Edge(_)
                | Op::Keep
                | Op::Recall
                | Op::Release
                | Op::Return
                | Op::End
                | Op::AndBlock
                | Op::OrBlock
                | Op::OutBlock
                | Op::EndBlock
        )
    }

    /// Whether it may have more than one operand.
    pub(crate) fn may_have_more(self) -> bool {
        matches!(
            self,
            Op::Timer(_)
                | Op::CountUp
                | Op::CountDown
                | Op::CountUpDown
                | Op::OmronTimer
                | Op::OmronCounter
                | Op::Function
                | Op::Code
                | Op::Table(_)
        )
    }

    /// Whether a list of operands is worked through one by one: `ADD 2, 4, 7`.
    pub(crate) fn takes_list(self) -> bool {
        let number = |opcode| matches!(opcode, Opcode::Add | Opcode::Multiply);
        match self {
            Op::And | Op::Or | Op::Xor => true,
            Op::Number(opcode) => number(opcode),
            _ => false,
        }
    }

    /// Whether its operand is a REAL number.
    pub(crate) fn is_real(self) -> bool {
        matches!(self, Op::Number(opcode) if opcode.row().kind == Kind::Real)
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
    let edge = |op, edge| Spelling {
        edge: Some(edge),
        ..maker(op, false, Dialect::Mitsubishi)
    };
    let rise = Op::Differentiate(Opcode::RisingEdge);
    let fall = Op::Differentiate(Opcode::FallingEdge);
    Some(match word {
        "LD" => plain(Op::Load),
        "ST" => plain(Op::Store),
        "S" | "S1" => plain(Op::Set),
        "R" | "R1" => plain(Op::Reset),
        "AND" => plain(Op::And),
        "OR" => plain(Op::Or),
        "XOR" => plain(Op::Xor),
        "NOT" => plain(Op::Not),
        "LDN" => spelling(Op::Load, true, false, None),
        "STN" => spelling(Op::Store, true, false, None),
        "ANDN" => spelling(Op::And, true, false, None),
        "ORN" => spelling(Op::Or, true, false, None),
        "XORN" => spelling(Op::Xor, true, false, None),
        "JMP" => plain(Op::Jump),
        "JMPC" => spelling(Op::Jump, false, true, None),
        "JMPCN" | "JMPNC" | "JMPN" => spelling(Op::Jump, true, true, None),
        "CAL" => plain(Op::Call),
        "CALC" => spelling(Op::Call, false, true, None),
        "CALCN" | "CALNC" | "CALN" => spelling(Op::Call, true, true, None),
        "RET" => plain(Op::Return),
        "RETC" => spelling(Op::Return, false, true, None),
        "RETCN" | "RETNC" | "RETN" => spelling(Op::Return, true, true, None),
        "TOR" => plain(Op::Timer(Opcode::RetentiveOnDelay)),
        "CTU" => plain(Op::CountUp),
        "CTD" => plain(Op::CountDown),
        "CTUD" => plain(Op::CountUpDown),
        "IN" => plain(Op::Input(Opcode::OnDelay)),
        "CU" => plain(Op::Input(Opcode::CountUp)),
        "CD" => plain(Op::Input(Opcode::CountDown)),
        "CLK" => plain(Op::Input(Opcode::RisingEdge)),
        "PT" | "PV" => plain(Op::Preset),
        "CODE" => plain(Op::Code),
        "END" | "MEND" | "FEND" => plain(Op::End),
        "LDI" => maker(Op::Load, true, Dialect::Mitsubishi),
        "ANI" => maker(Op::And, true, Dialect::Mitsubishi),
        "ORI" => maker(Op::Or, true, Dialect::Mitsubishi),
        "OUT" => plain(Op::Store),
        "ANB" => maker(Op::AndBlock, false, Dialect::Mitsubishi),
        "ORB" => maker(Op::OrBlock, false, Dialect::Mitsubishi),
        "SET" => plain(Op::Set),
        "RST" => plain(Op::Reset),
        "MPS" => maker(Op::Keep, false, Dialect::Mitsubishi),
        "MRD" => maker(Op::Recall, false, Dialect::Mitsubishi),
        "MPP" => maker(Op::Release, false, Dialect::Mitsubishi),
        "LPS" => maker(Op::Keep, false, Dialect::S7200),
        "LRD" => maker(Op::Recall, false, Dialect::S7200),
        "LPP" => maker(Op::Release, false, Dialect::S7200),
        "LDP" => edge(Op::Load, Opcode::RisingEdge),
        "LDF" => edge(Op::Load, Opcode::FallingEdge),
        "ANDP" | "ANP" => edge(Op::And, Opcode::RisingEdge),
        "ANDF" | "ANF" => edge(Op::And, Opcode::FallingEdge),
        "ORP" => edge(Op::Or, Opcode::RisingEdge),
        "ORF" => edge(Op::Or, Opcode::FallingEdge),
        "PLS" => maker(rise, false, Dialect::Mitsubishi),
        "PLF" => maker(fall, false, Dialect::Mitsubishi),
        "DIFU" => maker(rise, false, Dialect::Omron),
        "DIFD" => maker(fall, false, Dialect::Omron),
        "RSET" => maker(Op::Reset, false, Dialect::Omron),
        "TIM" => maker(Op::OmronTimer, false, Dialect::Omron),
        "CNT" => maker(Op::OmronCounter, false, Dialect::Omron),
        "A" => maker(Op::And, false, Dialect::S7200),
        "AN" => maker(Op::And, true, Dialect::S7200),
        "O" => maker(Op::Or, false, Dialect::S7200),
        "ON" => maker(Op::Or, true, Dialect::S7200),
        "ALD" => maker(Op::AndBlock, false, Dialect::S7200),
        "OLD" => maker(Op::OrBlock, false, Dialect::S7200),
        "BLK" => maker(Op::Block, false, Dialect::Twido),
        "OUT_BLK" => maker(Op::OutBlock, false, Dialect::Twido),
        "END_BLK" => maker(Op::EndBlock, false, Dialect::Twido),
        word => plain(of_table(word)?),
    })
}

/// Whether Instruction List has this operator, in upper case: by whatever maker, in another language, or, where it is long
/// enough to tell, one slip of the hand away.
pub fn is_operator(word: &str) -> bool {
    let slip = || word.len() > 2 && nearest(word).is_some();
    find(word).is_some() || of_other_language(word).is_some() || slip()
}

/// What the instruction table itself says by this word.
fn of_table(word: &str) -> Option<Op> {
    let (_, opcode) = *OWN_WORDS.iter().find(|own| own.0 == word)?;
    let kind = opcode.row().kind;
    Some(if opcode.class() == Class::Comparison {
        Op::Compare(opcode)
    } else if opcode.class() == Class::Timer {
        Op::Timer(opcode)
    } else if opcode.class() == Class::Logic {
        Op::Edge(opcode)
    } else if matches!(opcode.class(), Class::If | Class::Part) {
        Op::Part(opcode)
    } else if opcode == Opcode::Push {
        Op::Push
    } else if kind == Kind::Table {
        Op::Table(opcode)
    } else if matches!(kind, Kind::Value | Kind::Real) {
        Op::Number(opcode)
    } else if kind == Kind::Bit {
        Op::Shift(opcode)
    } else {
        Op::Unary(opcode)
    })
}

/// The instructions that have a word of their own. What the others do, operators of several instructions say.
static OWN_WORDS: LazyLock<Vec<(&str, Opcode)>> = LazyLock::new(|| {
    let own = [
        Class::Comparison,
        Class::Timer,
        Class::Logic,
        Class::Operation,
        Class::If,
        Class::Part,
    ];
    let all = Opcode::ALL.iter().copied();
    let own = all.filter(|opcode| own.contains(&opcode.class()) || *opcode == Opcode::StoreTable);
    let words = own.map(|opcode| (operator(opcode), opcode));
    words.filter(|(word, _)| !word.is_empty()).collect()
});

fn spelling(op: Op, negated: bool, conditional: bool, dialect: Option<Dialect>) -> Spelling {
    Spelling {
        op,
        negated,
        conditional,
        edge: None,
        dialect,
    }
}

/// The spellings that may have been meant by a wrong one, the likelier first.
const SPELLINGS: &[&str] = &[
    "LD", "LDN", "ST", "STN", "S", "R", "AND", "ANDN", "OR", "ORN", "XOR", "XORN", "NOT", "ADD",
    "SUB", "MUL", "DIV", "MOD", "GT", "GE", "EQ", "NE", "LE", "LT", "JMP", "JMPC", "JMPCN", "CAL",
    "CALC", "CALCN", "RET", "RETC", "RETCN", "TON", "TOF", "TP", "TONR", "CTU", "CTD", "CTUD",
    "LDI", "ANI", "ORI", "OUT", "SET", "RST", "ALD", "OLD", "BLK", "OUT_BLK", "END_BLK", "SHL",
    "SHR", "NEG", "SQRT",
];

/// The operators that one is offered, and the words that declare.
pub fn vocabulary() -> Vec<&'static str> {
    let own = OWN_WORDS.iter().map(|own| own.0);
    let mut all: Vec<&str> = SPELLINGS.iter().copied().chain(own).collect();
    all.extend(SECTIONS);
    all.extend(["END_VAR", "AT", "RETAIN", "CODE"]);
    all.sort_unstable();
    all.dedup();
    all
}

/// The spelling that is one slip of the hand away: a letter wrong, missing or too many.
pub(crate) fn nearest(word: &str) -> Option<&'static str> {
    // EU, ED and IF are one slip away from too much.
    let short = |opcode: Opcode| matches!(opcode.class(), Class::Logic | Class::If | Class::Part);
    let more = OWN_WORDS.iter().filter(|own| !short(own.1));
    let mut spellings = SPELLINGS.iter().copied().chain(more.map(|own| own.0));
    spellings.find(|known| one_slip(known.as_bytes(), word.as_bytes()))
}

/// The operator that a word of another language means: Portuguese, Spanish, and German as Siemens has it.
pub(crate) fn of_other_language(word: &str) -> Option<&'static str> {
    Some(match word {
        "E" | "U" | "Y" | "UND" => "AND",
        "EN" | "UN" => "ANDN",
        "OU" | "ODER" => "OR",
        "OUN" => "ORN",
        "XOU" | "OUX" => "XOR",
        "NAO" | "NÃO" => "NOT",
        "L" => "LD",
        "T" => "ST",
        "SPB" => "JMPC",
        "SPA" => "JMP",
        _ => return None,
    })
}

/// Whether a line of Structured Text begins with this word.
pub(crate) fn is_structured_text(word: &str) -> bool {
    matches!(
        word,
        "IF" | "ELSIF"
            | "ELSE"
            | "END_IF"
            | "FOR"
            | "END_FOR"
            | "WHILE"
            | "END_WHILE"
            | "REPEAT"
            | "UNTIL"
            | "END_REPEAT"
            | "CASE"
            | "END_CASE"
    )
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
