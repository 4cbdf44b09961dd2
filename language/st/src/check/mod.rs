//! Names and types: from the syntax tree to the typed tree.
//!
//! - `types`, `derived`: types as they are declared, and what a variable begins with
//! - `units`: variables, and the order in which units are declared
//! - `pieces`: what stands in Instruction List as in Structured Text
//! - `condition`: an expression alone, over names that are given
//! - `chart`: steps, transitions, actions
//! - `expressions`, `statements`: the rest
//!
//! What a name means and which types go together is the builder's to say; this says what stands in the text.

mod chart;
pub(super) mod condition;
mod derived;
mod expressions;
mod initial;
mod pieces;
mod statements;
mod types;
mod units;

pub use units::Of;

use super::ast::File;
use std::collections::HashMap;
use unoclp_chart::{Cells, Net};
use unoclp_core::Board;
use unoclp_point::Maker;
use unoclp_text::diagnostics::{Code, Found, Span, Word};
use unoclp_text::moved::adapt_at;
use unoclp_tree::build::{Builder, Closed, Declaring, EdgeInput, Letters};
use unoclp_tree::{Tree, TypeId};

/// Types and blocks are made of others no deeper.
const MOST_WITHIN: u32 = 40;

/// How far a declaration has been made out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Not,
    Begun,
    Done(Option<TypeId>),
}

/// How far a unit has been made out.
#[derive(Debug)]
enum Stage {
    Not(Declaring),
    Begun,
    Done(Closed),
}

/// What is known of a text while its names and types are checked.
pub struct Checker<'a, 't, 'f> {
    /// What makes the tree.
    pub builder: Builder<'t, 'f>,
    file: &'a File,
    /// Types of the text by their names: which they are.
    types: HashMap<String, usize>,
    type_states: Vec<State>,
    /// The unit of each declaration, as far as it is made out.
    units: Vec<Stage>,
    /// Declarations of blocks by their names.
    blocks: HashMap<String, usize>,
    /// Units with code for another machine by their names, and whether something uses them.
    foreign: HashMap<String, bool>,
    /// The charts of the units that have one, whose steps and actions are declared.
    charts: HashMap<usize, (Net, Cells)>,
    /// The inputs of each unit that are edges.
    edges: HashMap<usize, Vec<EdgeInput>>,
    /// What is checked is the body of an action.
    in_action: bool,
    /// Whether the text reads ENO of an instance.
    reads_eno: bool,
    within: u32,
    /// Of a list: whose way of writing points it has.
    maker: Option<Maker>,
}

impl<'a, 't, 'f> Checker<'a, 't, 'f> {
    fn new(builder: Builder<'t, 'f>, file: &'a File) -> Checker<'a, 't, 'f> {
        Checker {
            builder,
            file,
            types: HashMap::new(),
            type_states: vec![State::Not; file.types.len()],
            units: Vec::new(),
            blocks: HashMap::new(),
            foreign: HashMap::new(),
            charts: HashMap::new(),
            edges: HashMap::new(),
            in_action: false,
            reads_eno: false,
            within: 0,
            maker: None,
        }
    }
}

pub(super) fn check(text: &str, file: &File, board: Board, found: &mut Found) -> Option<Tree> {
    if !is_program(text, file, found) {
        return None;
    }
    let mut builder = Builder::new(text, Letters::Alike, board, found);
    builder.keeps_inputs = true;
    if !board.has_firmware() {
        let moved = adapt_at(text, &file.points, board).moved.into_iter();
        builder.moved = moved.map(|(old, new)| (old, (new, false))).collect();
    }
    let mut checker = Checker::new(builder, file);
    checker.reads_eno = text.to_uppercase().contains(".ENO");
    checker.declare_all();
    checker.bodies();
    checker.unused_foreign();
    checker.builder.finish()
}

/// Whether there is something to run, or to check.
fn is_program(text: &str, file: &File, found: &mut Found) -> bool {
    use unoclp_tree::UnitKind::Program;
    if file.units.iter().any(|unit| unit.kind == Program) {
        return true;
    }
    if found.has_errors() {
        return false;
    }
    let end = text.trim_end().len() as u32;
    let end = Span { start: end, end };
    if !file.units.is_empty() {
        // Others keep each block in a file of its own.
        found.tell(Code::StLibrary, end, []);
        return true;
    }
    let why: Word = match file.globals.is_empty() && file.types.is_empty() {
        false => (
            "the text has only declarations",
            "o texto só tem declarações",
        )
            .into(),
        true => ("the text has no statements", "o texto não tem comandos").into(),
    };
    found.tell(Code::StNoProgram, end, [why]);
    false
}
