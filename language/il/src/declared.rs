//! What the declarations of a text in Instruction List say of the board's points, whatever stands after them.

use crate::ast::Var;
use crate::parser;
use unoclp_point::{Address, Kind, read};
use unoclp_text::comments::{Comments, words};
use unoclp_text::diagnostics::{Found, Lines, Span};

/// What a text declares.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Declared {
    /// The comments at its beginning, line by line.
    pub title: Vec<String>,
    /// Points that have a name, in the order of the text.
    pub points: Vec<DeclaredPoint>,
    /// Whether the text can be read, and no instruction stands in it.
    pub is_blank: bool,
}

/// A point that a text gives a name: `start AT %I1 : BOOL; (* green *)`.
#[derive(Debug, PartialEq, Eq)]
pub struct DeclaredPoint {
    /// An input, an output, a marker, a register or an analogue input.
    pub point: Address,
    /// As the text writes it.
    pub name: String,
    /// The comment after it in its line; empty without one.
    pub comment: String,
}

/// Reads the declarations of a text.
pub fn declared(text: &str) -> Declared {
    let mut found = Found::default();
    let parsed = parser::parse(text, &mut found);
    let dialect = parsed.signs.dialect();
    let program = parsed.units.first();
    let vars = program.map(|unit| &unit.vars[..]).unwrap_or_default();
    let points = vars.iter().filter_map(|var| {
        let written = read(var.at.as_ref()?.name()?, dialect.maker())?;
        let at = written.address?;
        let has_row = matches!(
            at.kind(),
            Kind::Input
                | Kind::Output
                | Kind::Marker
                | Kind::System
                | Kind::Register
                | Kind::Analogue
        );
        has_row.then_some(())?;
        Some(DeclaredPoint {
            point: at,
            name: text.get(var.name.span.range())?.to_owned(),
            comment: behind(text, var, &parsed.comments),
        })
    });
    let has_code = parsed.units.iter().any(|unit| !unit.body.is_empty());
    let is_alone = parsed.units.len() <= 1;
    Declared {
        points: points.collect(),
        is_blank: is_alone && !has_code && !parsed.wrong_declarations && !found.has_errors(),
        title: Comments::new(text, &Lines::new(text), &parsed.comments).title(),
    }
}

/// The comment after a declaration, in the same line.
fn behind(text: &str, var: &Var, comments: &[Span]) -> String {
    let from = var.name.span.range().start;
    let begins = |span: &&Span| {
        let between = text.get(from..span.range().start);
        between.is_some_and(|between| !between.contains('\n'))
    };
    let comment = comments.iter().find(begins);
    let said = comment.and_then(|span| text.get(span.range()));
    let line = words(said.unwrap_or_default()).lines().next();
    line.unwrap_or_default().trim().to_owned()
}
