//! The syntax tree: what a text says, each part with its place, before anything is known of its names.

use crate::operators::Op;
use unoclp_core::isa::Opcode;
use unoclp_point::is_block;
use unoclp_text::diagnostics::Span;
use unoclp_tree::build::Edge;

/// A name as it is written, in upper case and without blanks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Word {
    pub text: String,
    pub span: Span,
}

/// A program, function or function block.
#[derive(Debug)]
pub(crate) struct Unit {
    pub kind: UnitKind,
    pub name: Option<Word>,
    /// The type of a function's result.
    pub result: Option<Word>,
    pub vars: Vec<Var>,
    pub body: Vec<Stmt>,
    /// The word that it begins with.
    pub span: Span,
    /// The byte of the text after its last line.
    pub end: u32,
}

/// What a unit is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum UnitKind {
    Program,
    Function,
    FunctionBlock,
}

/// The part of the declarations that a variable stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Section {
    Local,
    /// New at each call.
    Temp,
    Input,
    Output,
    /// The caller's own variable, under another name.
    InOut,
    /// Of the whole file, and its mention in a unit.
    Global,
    External,
}

/// A declared variable.
#[derive(Debug)]
pub(crate) struct Var {
    pub section: Section,
    /// Whether it outlasts a power cut.
    pub retain: bool,
    /// Whether nothing changes it.
    pub constant: bool,
    pub name: Word,
    pub at: Option<Operand>,
    pub ty: Word,
    /// `R_EDGE` or `F_EDGE` after its type.
    pub edge: Option<Edge>,
    /// `TRUE`, or `(PT := T#5s)`.
    pub init: Vec<Init>,
    /// The number of its declaration, where its type is none of bits, whole numbers of the board, or blocks.
    pub typed: Option<usize>,
}

/// A first value, with the name of what it is for where it says so.
#[derive(Clone, Debug)]
pub(crate) struct Init {
    pub name: Option<Word>,
    pub value: Operand,
}

/// An operand: a constant, or a name that is yet to be looked up.
#[derive(Clone, Debug)]
pub(crate) struct Operand {
    pub kind: OperandKind,
    pub span: Span,
}

/// See [`Operand`].
#[derive(Clone, Debug)]
pub(crate) enum OperandKind {
    /// In upper case and without blanks, members and all: `%IX1`, `T1.Q`.
    Name(String),
    Number(i32),
    /// A number of the type UDINT, by its bits, which are those of a negative one: `UDINT#3000000000`.
    Unsigned(i32),
    /// A time in ms.
    Time(i32),
    /// A REAL, by its bits.
    Real(i32),
    Bool(bool),
    /// What is written as in Structured Text, `a[i]`, `D#2026-11-23`, `n + 1`, by its number.
    Piece(usize),
    /// Something was wrong, and has been told.
    Unknown,
}

/// `IN := %IX1`, or `Q => %QX1`, or an operand alone.
#[derive(Clone, Debug)]
pub(crate) struct Param {
    pub name: Option<Word>,
    /// `=>`: the block gives it.
    pub out: bool,
    /// `NOT` before the operand.
    pub negated: bool,
    pub value: Operand,
}

/// A deferral: `(`, or `(N`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Open {
    pub span: Span,
    /// N after the parenthesis: the first operand is inverted.
    pub negated: bool,
}

/// An instruction.
#[derive(Debug)]
pub(crate) struct Instr {
    pub op: Op,
    /// The name of a function that is called as an operator.
    pub function: Option<String>,
    /// The modifier N, before any parenthesis.
    pub negated: bool,
    /// The modifier C.
    pub conditional: bool,
    /// The edge of the operand is meant, and not its state.
    pub edge: Option<Opcode>,
    pub open: Option<Open>,
    pub operands: Vec<Operand>,
    /// What stands in the parentheses of a call.
    pub params: Vec<Param>,
    /// The operator and its modifiers.
    pub span: Span,
    /// The whole instruction.
    pub whole: Span,
}

/// A part of a body.
#[derive(Debug)]
pub(crate) enum Stmt {
    Label(Word),
    Instr(Box<Instr>),
    /// `)`
    Close(Span),
    /// A line that could not be read, and has been told; so many parentheses stay open after it.
    Wrong {
        open: usize,
    },
}

impl Instr {
    /// Whether it is a store that starts a timer or counter: `OUT T0 K50`.
    pub(crate) fn starts_block(&self) -> bool {
        let block = self.operands.first().and_then(Operand::name);
        self.op == Op::Store && self.operands.len() == 2 && block.is_some_and(is_block)
    }
}

impl Operand {
    /// The name; none of a constant.
    pub(crate) fn name(&self) -> Option<&str> {
        match &self.kind {
            OperandKind::Name(name) => Some(name),
            _ => None,
        }
    }

    /// Makes the name of a block that of its part: `T1` becomes `T1.PT`.
    pub(crate) fn add_member(&mut self, member: &str) {
        if let OperandKind::Name(name) = &mut self.kind {
            name.push('.');
            name.push_str(member);
        }
    }

    /// Whether something was wrong with it, which has been told.
    pub(crate) fn is_wrong(&self) -> bool {
        matches!(self.kind, OperandKind::Unknown)
    }

    /// The number; none of a name.
    pub(crate) fn number(&self) -> Option<i32> {
        match self.kind {
            OperandKind::Number(number)
            | OperandKind::Unsigned(number)
            | OperandKind::Time(number)
            | OperandKind::Real(number) => Some(number),
            OperandKind::Bool(state) => Some(state.into()),
            OperandKind::Name(_) | OperandKind::Piece(_) | OperandKind::Unknown => None,
        }
    }
}
