//! Pieces of Instruction List that are written as in Structured Text: types, typed variables, operands with members and
//! subscripts, literals, expressions in calls.
//!
//! Owns where such a piece ends. Must not know lines and operators: the parser of Instruction List says where one begins.

use super::ast::{Decl, File, Name, Node, NodeKind, Part, Path, SpecKind, TypeSpec};
use super::parser::{Parsed, Parser};
use unoclp_text::diagnostics::{Found, Span};
use unoclp_tree::build::Edge;

/// A value, or a variable with its members and subscripts.
#[derive(Debug)]
pub struct Piece(pub(super) Node);

/// Variables of one declaration.
#[derive(Debug)]
pub struct Declared(pub(super) Decl);

/// The types that a text declares.
#[derive(Debug, Default)]
pub struct Types(pub(super) File);

/// All pieces of a text.
#[derive(Debug, Default)]
pub struct Pieces {
    /// Those that it derives.
    pub types: Types,
    values: Vec<Piece>,
    declared: Vec<Declared>,
}

impl Pieces {
    /// Takes a value, and gives it its number.
    pub fn add(&mut self, piece: Piece) -> usize {
        self.values.push(piece);
        self.values.len() - 1
    }

    /// Takes a declaration, and gives it its number.
    pub fn declare(&mut self, declared: Declared) -> usize {
        self.declared.push(declared);
        self.declared.len() - 1
    }

    /// The value of this number.
    pub fn value(&self, number: usize) -> Option<&Piece> {
        self.values.get(number)
    }

    /// The declaration of this number.
    pub fn declared(&self, number: usize) -> Option<&Declared> {
        self.declared.get(number)
    }

    /// Whether it declares anything.
    pub fn declares(&self) -> bool {
        !self.declared.is_empty() || !self.types.0.types.is_empty()
    }
}

/// What a piece of a text is read as, and where it ends; none of one that is wrong, which is told.
type Read<T> = Option<(T, u32)>;

fn read<T>(
    text: &str,
    piece: Span,
    found: &mut Found,
    what: impl FnOnce(&mut Parser) -> Parsed<T>,
) -> Read<T> {
    let mut parser = Parser::of_piece(text, piece, found);
    let made = what(&mut parser).ok()?;
    parser.is_right().then(|| (made, parser.end()))
}

impl Piece {
    /// A variable with its members and subscripts.
    pub fn place(text: &str, piece: Span, found: &mut Found) -> Read<Piece> {
        read(text, piece, found, |parser| {
            let path = parser.path()?;
            Ok(Piece(Node {
                span: path.span,
                height: path.height() + 1,
                kind: NodeKind::Path(path),
            }))
        })
    }

    /// An operand.
    pub fn operand(text: &str, piece: Span, found: &mut Found) -> Read<Piece> {
        read(text, piece, found, |parser| Ok(Piece(parser.operand()?)))
    }

    /// An expression.
    pub fn expression(text: &str, piece: Span, found: &mut Found) -> Read<Piece> {
        read(text, piece, found, |parser| Ok(Piece(parser.expression()?)))
    }

    /// A variable by its name and those of its members, `tank.level`, as they stand here.
    pub fn named(name: &str, at: Span) -> Piece {
        let mut start = at.start;
        let mut names = name.split('.').map(|text| {
            let end = (start + text.len() as u32).min(at.end);
            let span = Span { start, end };
            start = (end + 1).min(at.end);
            Name {
                text: text.to_owned(),
                span,
            }
        });
        let path = Path {
            name: names.next().unwrap_or(Name {
                text: String::new(),
                span: at,
            }),
            parts: names.map(Part::Member).collect(),
            span: at,
        };
        Piece(Node {
            kind: NodeKind::Path(path),
            span: at,
            height: 1,
        })
    }

    /// Where it stands.
    pub fn span(&self) -> Span {
        self.0.span
    }
}

impl Declared {
    /// A declaration, from its first name on.
    pub fn read(text: &str, piece: Span, found: &mut Found) -> Read<Declared> {
        read(text, piece, found, |parser| {
            Ok(Declared(parser.declaration()?))
        })
    }

    /// `R_EDGE` or `F_EDGE` after its type.
    pub fn edge(&self) -> Option<Edge> {
        self.0.edge
    }

    /// The names of its variables, and where they stand.
    pub fn names(&self) -> impl Iterator<Item = (&str, Span)> {
        self.0
            .names
            .iter()
            .map(|name| (name.text.as_str(), name.span))
    }

    /// Where its type stands.
    pub fn spec(&self) -> Span {
        self.0.spec.span
    }

    /// The names of the types that it is made of.
    pub fn types(&self) -> Vec<&str> {
        let mut all = Vec::new();
        note(&self.0.spec, &mut all);
        all
    }
}

fn note<'s>(spec: &'s TypeSpec, all: &mut Vec<&'s str>) {
    match &spec.kind {
        SpecKind::Named(name) => all.push(&name.text),
        SpecKind::Array(_, of) => note(of, all),
        SpecKind::Struct(decls) => decls.iter().for_each(|decl| note(&decl.spec, all)),
        SpecKind::Text(..) | SpecKind::Enum(_) | SpecKind::Range(..) => {}
    }
}

impl Types {
    /// Reads TYPE … END_TYPE; false where something is wrong, which is told.
    pub fn read(&mut self, text: &str, piece: Span, found: &mut Found) -> bool {
        let all = &mut self.0.types;
        let read = read(text, piece, found, |parser| {
            parser.types(all);
            Ok(())
        });
        read.is_some()
    }

    /// The names of the types that a type of the text is made of.
    pub fn made_of(&self, name: &str) -> Vec<&str> {
        let mut types = self.0.types.iter();
        let mut all = Vec::new();
        if let Some(ty) = types.find(|ty| ty.name.text.eq_ignore_ascii_case(name)) {
            note(&ty.spec, &mut all);
        }
        all
    }
}
