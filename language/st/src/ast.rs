//! What stands in a text, before anything is known of its names.

use unoclp_text::diagnostics::Span;
use unoclp_tree::build::Edge;
use unoclp_tree::{Base, Binary, Compare, UnitKind, Value};

/// A name and its place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Name {
    pub text: String,
    pub span: Span,
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
    Literal(Base, Value),
    /// `Color#Red`
    Member(Name, Name),
    Path(Path),
    Call(Path, Vec<Arg>),
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
    Power,
}

/// A variable with its members and subscripts.
#[derive(Debug)]
pub(super) struct Path {
    pub name: Name,
    pub parts: Vec<Part>,
    pub span: Span,
}

#[derive(Debug)]
pub(super) enum Part {
    Member(Name),
    /// `.3`: a bit of a number, by its place.
    Bit(Name),
    Subscripts(Vec<Node>, Span),
}

impl Path {
    /// Of `word.3`, what stands before the bit, and the bit.
    pub(super) fn bit(&self) -> Option<(&[Part], &Name)> {
        match self.parts.split_last() {
            Some((Part::Bit(bit), parts)) => Some((parts, bit)),
            _ => None,
        }
    }
}

/// What stands in the parentheses of a call.
#[derive(Debug)]
pub(super) struct Arg {
    pub name: Option<Name>,
    pub out: bool,
    pub node: Node,
}

#[derive(Debug)]
pub(super) struct Statement {
    pub kind: StatementKind,
    pub span: Span,
}

#[derive(Debug)]
pub(super) enum StatementKind {
    Assign(Path, Node),
    Call(Path, Vec<Arg>),
    If(Vec<(Node, Vec<Statement>)>, Vec<Statement>),
    Case(Node, Vec<Arm>, Vec<Statement>),
    For(Box<Counting>),
    While(Node, Vec<Statement>),
    Repeat(Vec<Statement>, Node),
    Exit,
    Continue,
    Return,
    /// A statement that is done where EN is TRUE, and the variable that takes ENO.
    Enabled(Option<Node>, Option<Path>, Box<Statement>),
}

/// FOR.
#[derive(Debug)]
pub(super) struct Counting {
    pub variable: Path,
    pub from: Node,
    pub to: Node,
    pub by: Option<Node>,
    pub body: Vec<Statement>,
}

/// An arm of CASE.
#[derive(Debug)]
pub(super) struct Arm {
    pub labels: Vec<(Node, Option<Node>)>,
    pub body: Vec<Statement>,
}

#[derive(Debug)]
pub(super) struct TypeSpec {
    pub kind: SpecKind,
    pub span: Span,
}

#[derive(Debug)]
pub(super) enum SpecKind {
    Named(Name),
    /// `STRING[20]`
    Text(Base, Option<Box<Node>>),
    /// Values, some with their numbers.
    Enum(Vec<(Name, Option<Node>)>),
    Range(Name, Box<(Node, Node)>),
    Array(Vec<(Node, Node)>, Box<TypeSpec>),
    Struct(Vec<Decl>),
}

/// What a variable begins with.
#[derive(Debug)]
pub(super) enum Init {
    Value(Node),
    /// Each so often; none: as its type says.
    Elements(Vec<(Option<Node>, Option<Init>)>, Span),
    Members(Vec<(Name, Init)>, Span),
}

/// Variables of one declaration.
#[derive(Debug)]
pub(super) struct Decl {
    pub names: Vec<Name>,
    pub at: Option<Name>,
    pub spec: TypeSpec,
    pub initial: Option<Init>,
    /// `R_EDGE`, which is rising, or `F_EDGE`.
    pub edge: Option<Edge>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Section {
    Var,
    Input,
    Output,
    InOut,
    Temp,
    Global,
    External,
}

#[derive(Debug)]
pub(super) struct Vars {
    pub section: Section,
    pub constant: bool,
    pub retain: bool,
    pub decls: Vec<Decl>,
}

#[derive(Debug)]
pub(super) struct TypeDecl {
    pub name: Name,
    pub spec: TypeSpec,
    pub initial: Option<Init>,
}

/// A chart, with its conditions, times and bodies as they are written.
pub(super) type Chart = unoclp_chart::Chart<Node, Vec<Statement>>;

#[derive(Debug)]
pub(super) struct UnitDecl {
    pub kind: UnitKind,
    pub name: Name,
    /// Of a function.
    pub result: Option<TypeSpec>,
    pub vars: Vec<Vars>,
    pub body: Vec<Statement>,
    /// What it does, where that is a chart and not statements.
    pub chart: Option<Chart>,
}

#[derive(Debug, Default)]
pub(super) struct File {
    pub types: Vec<TypeDecl>,
    pub globals: Vec<Vars>,
    pub units: Vec<UnitDecl>,
    /// The programs that a configuration names, in capitals, in its order.
    pub order: Vec<String>,
    /// Functions and blocks that contain code for another machine; nothing else of them is read.
    pub foreign: Vec<Name>,
    /// Where it names points.
    pub points: Vec<std::ops::Range<usize>>,
}

impl File {
    /// Puts the programs in the order in which they run: first those that a configuration names, in its order (2.7.1).
    pub(super) fn put_in_order(&mut self) {
        let place = |unit: &UnitDecl| {
            let name = unit.name.text.to_uppercase();
            let mut order = self.order.iter();
            order.position(|one| *one == name).unwrap_or(usize::MAX)
        };
        let is_program = |unit: &UnitDecl| unit.kind == UnitKind::Program;
        let units = std::mem::take(&mut self.units);
        let (mut programs, others): (Vec<_>, Vec<_>) = units.into_iter().partition(is_program);
        programs.sort_by_key(place);
        self.units = others;
        self.units.extend(programs);
    }
}
