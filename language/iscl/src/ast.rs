//! What stands in an InterSCL text, before anything is known of its names.

pub(super) use unoclp_small::cursor::Name;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Binary, Compare, Value};

#[derive(Debug)]
pub(super) struct Node {
    pub kind: NodeKind,
    pub span: Span,
    /// How deep the deepest part of it is.
    pub height: u32,
}

#[derive(Debug)]
pub(super) enum NodeKind {
    Literal(Base, Value),
    Name(Name),
    Negate(Box<Node>),
    Not(Box<Node>),
    Binary(Op, Box<Node>, Box<Node>),
    Wrong,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Op {
    Arithmetic(Binary),
    Logic(Binary),
    Compare(Compare),
}

#[derive(Debug)]
pub(super) struct Statement {
    pub kind: StatementKind,
    pub span: Span,
}

#[derive(Debug)]
pub(super) enum StatementKind {
    Assign(Name, Node),
    Print(Name),
    If(Node, Vec<Statement>, Vec<Statement>),
    While(Node, Vec<Statement>),
    For(Box<Counting>),
}

/// FOR.
#[derive(Debug)]
pub(super) struct Counting {
    pub variable: Name,
    pub from: Node,
    pub to: Node,
    pub body: Vec<Statement>,
}

/// `INT x`, `BOOL start AT %IX1`
#[derive(Debug)]
pub(super) struct Decl {
    pub base: Base,
    pub name: Name,
    pub point: Option<Name>,
}

#[derive(Debug, Default)]
pub(super) struct Program {
    pub span: Span,
    pub decls: Vec<Decl>,
    pub body: Vec<Statement>,
}
