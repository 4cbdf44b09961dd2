//! What is in an LCE text, before anything is known of its names.

pub(super) use unoclp_small::cursor::Name;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Binary, Compare, Value};

/// The type of both sides of an operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A number with a fraction.
    R,
    /// 32 bits with a sign.
    D,
    /// 16 bits without a sign.
    W,
    /// 8 bits without a sign.
    B,
}

impl Kind {
    /// The letter before an operator.
    pub fn of(letter: &str) -> Option<Kind> {
        Some(match letter {
            "R" => Kind::R,
            "D" => Kind::D,
            "W" => Kind::W,
            "B" => Kind::B,
            _ => return None,
        })
    }
}

#[derive(Debug)]
pub(super) struct Node {
    pub kind: NodeKind,
    pub span: Span,
    /// How deep the deepest part of it is.
    pub height: u32,
}

#[derive(Debug)]
pub(super) enum NodeKind {
    /// A number, and whether it is written with 2# or 16#.
    Number(Value, bool),
    Name(Name),
    Not(Box<Node>),
    /// The operator with its type, where it says one, and where it stands.
    Binary(Op, Option<Kind>, Span, Box<(Node, Node)>),
    Wrong,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Op {
    Arithmetic(Binary),
    Logic(Binary),
    Compare(Compare),
}

/// What is done with a bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bit {
    /// `aciona`
    Coil,
    /// `liga`
    On,
    /// `desliga`
    Off,
}

#[derive(Debug)]
pub(super) struct Statement {
    pub kind: StatementKind,
    pub span: Span,
}

#[derive(Debug)]
pub(super) enum StatementKind {
    /// The sign with its type is at the span.
    Assign(Name, Option<Kind>, Span, Node),
    Bit(Bit, Name),
    If(Node, Vec<Statement>, Vec<Statement>),
}

/// `V0 = nivel`
#[derive(Debug)]
pub(super) struct Alias {
    pub place: Name,
    pub name: Name,
}

#[derive(Debug, Default)]
pub(super) struct Program {
    pub name: Option<Name>,
    pub span: Span,
    pub aliases: Vec<Alias>,
    pub body: Vec<Statement>,
}
