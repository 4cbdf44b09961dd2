//! What a text declares, and where: for who looks for a name in it.
//!
//! Found by the words alone, so that a text with mistakes has one too. Owns what there is to tell apart. Must not know
//! types, places on a board, or whether a name is right: the typed tree does.

mod norm;

pub use norm::{Labels, norm};

use crate::diagnostics::Span;

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum What {
    /// A program.
    Program,
    /// A function block.
    Block,
    /// A function.
    Function,
    /// A type.
    Type,
    /// A variable, or a name of a point.
    Variable,
    /// A member of a structure.
    Member,
    /// A value of an enumeration.
    Value,
    /// A step of a chart.
    Step,
    /// A transition with a name.
    Transition,
    /// An action of a chart.
    Action,
    /// A label that jumps name.
    Label,
}

impl What {
    /// Whether it is a program, a function block or a function.
    pub fn is_unit(self) -> bool {
        matches!(self, What::Program | What::Block | What::Function)
    }
}

/// A declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Named {
    /// What it stands for.
    pub what: What,
    /// The name itself.
    pub name: Span,
    /// The unit or the type that it belongs to, by its place among all.
    pub within: Option<usize>,
    /// Its type as it is written; of a function that of its result.
    pub ty: Option<Span>,
    /// The point that it is at.
    pub point: Option<Span>,
    /// The word that begins its section: `VAR_INPUT`.
    pub section: Option<Span>,
    /// With what it begins.
    pub first: Option<Span>,
    /// All that belongs to it, from its first word to its last; of a variable its declaration.
    pub whole: Span,
}

impl Named {
    /// One of which nothing else is known yet.
    pub fn new(what: What, name: Span, within: Option<usize>) -> Named {
        Named {
            what,
            name,
            within,
            ty: None,
            point: None,
            section: None,
            first: None,
            whole: name,
        }
    }
}

/// Whether a word begins like a name.
pub fn begins_name(word: &str) -> bool {
    word.starts_with(|first: char| first.is_alphabetic() || first == '_')
}

/// All declarations of a text, in the order of their places.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outline {
    /// The declarations.
    pub named: Vec<Named>,
    /// Whether `Motor` and `MOTOR` are two names.
    pub letters_apart: bool,
}
