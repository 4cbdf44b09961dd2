//! From the typed tree to the numeric code.
//!
//! Owns the one lowering and the one allocation of all typed languages. Must not know how a text is written, pins, nor
//! files. A tree that the board cannot do is told at its place; none makes this panic.
//!
//! The way of a tree:
//!
//! ```text
//! Tree ─inline─► Flat (no calls) ─merge─► Flat ─seats─► places ─coder─► instructions ─finish─► lines of a file
//! ```
//!
//! - `lacks`: types and functions that the board lacks, told before all else
//! - `flat`: steps without calls; `inline`, `calls`, `values`, `loops`, `pure`: the way there
//! - `turns`: loops that cost too much, written once for each turn
//! - `merge`: what is put aside and used once goes where it is used; inputs of timers and counters to their calls
//! - `again`: timers that are called more than once
//! - `counts`: numbers of counters, which are wider than their type
//! - `uses`: what is done with each cell; `allot`: its place; `allotter`: what is too little; `seats`: markers, registers, timers, counters
//! - `ranges`: which values an expression may have; `fails`: whether it may set S 04; `operand`: what an operation takes as
//!   it stands
//! - `prepare`: what no instruction does in one piece, by `keep`, `subscripts`, `conversions`, `selection`, `arithmetic`,
//!   `shifts`
//! - `logic`, `bits`, `compare`, `numbers`: what is left of an expression
//! - `coder`, `statements`, `assign`, `copy`, `choice`, `case`: statements; `blocks`: the blocks of the standard; `counters`:
//!   those of the board that count, and what is done to counters and timers beside their calls
//! - `codes`, `verbatim`: instructions that the text says by their codes
//! - `pen`: what acc and value hold; `variables`, `noting`, `traces`: what is shown of it while it runs
//! - `finish`: labels, first values, what is kept, the cost of loops; `emit`: lines of a program file, checked as the board
//!   checks them; `places`: where its steps stand in the text

#![forbid(unsafe_code)]

mod again;
mod allot;
mod allotter;
mod arithmetic;
mod assign;
mod bits;
mod blocks;
mod calls;
mod case;
mod choice;
mod coder;
mod codes;
mod compare;
mod conversions;
mod copy;
mod counters;
mod counts;
mod emit;
mod fails;
mod finish;
mod flat;
mod inline;
mod keep;
mod lacks;
mod logic;
mod loops;
mod merge;
mod noting;
mod numbers;
mod operand;
mod origin;
mod pen;
mod places;
mod prepare;
mod pure;
mod ranges;
mod seats;
mod selection;
mod shifts;
mod statements;
mod subscripts;
mod traces;
mod turns;
mod uses;
mod values;
mod variables;
mod verbatim;

pub use emit::{CodeLine, file};

use places::Places;
use std::collections::HashSet;
use std::sync::Arc;
pub use traces::{Shows, Trace};
use unoclp_checked::{Checked, SourceMap, Work};
use unoclp_core::Board;
use unoclp_text::Dialect;
use unoclp_text::comments::{self, Comments};
use unoclp_text::diagnostics::{Code, Found, Lines, Severity, Span, Told};
use unoclp_tree::{Read, Tree, UnitKind, Units, Written};
pub use variables::{Held, Holding, Variable, literal};

/// What has come of a text.
#[derive(Debug, Default)]
pub struct CompiledText {
    /// What it means; none where its names or types are wrong.
    pub tree: Option<Tree>,
    /// The lines of the program file.
    pub lines: Vec<CodeLine>,
    /// The program, as the board's own loader has checked it, and where its steps stand in the text.
    pub program: Option<(Checked, SourceMap)>,
    /// The tree's symbols in their order, as the board keeps them; none where the board cannot do the text.
    pub variables: Vec<Variable>,
    /// What its lines show of a scan.
    pub traces: Vec<Trace>,
    /// Whose words it was taken to be written in, where makers write its language in their own.
    pub dialect: Option<Dialect>,
    /// Whether it says what the board has, so that its points show all that its variables would.
    pub is_drawn: bool,
    /// What was found in the text.
    pub diagnostics: Told,
}

impl CompiledText {
    /// Whether there is no program.
    pub fn has_errors(&self) -> bool {
        self.diagnostics
            .iter()
            .any(|told| told.severity() == Severity::Error)
    }

    /// The codes and operands in order.
    pub fn codes(&self) -> Vec<i32> {
        self.lines.iter().map(|line| line.code).collect()
    }

    /// What is shown of it while it runs: its variables and its lines; nothing where its points show all of that.
    pub fn take_shown(&mut self) -> (Vec<Variable>, Vec<Trace>) {
        let shown = (
            std::mem::take(&mut self.variables),
            std::mem::take(&mut self.traces),
        );
        match self.is_drawn {
            true => Default::default(),
            false => shown,
        }
    }

    /// The program file with its comments; none where there are errors.
    pub fn file(&self) -> Option<String> {
        self.program.as_ref().map(|_| emit::file(&self.lines))
    }

    /// Where the board keeps each symbol of the tree, in their order: `D 01`, `M 03`; none where it does not, or in one of
    /// two places.
    pub fn places(&self) -> Vec<Option<String>> {
        let place = |variable: &Variable| match variable.holding {
            Holding::One((point, _)) => Some(format!("{point:#}")),
            _ => None,
        };
        self.variables.iter().map(place).collect()
    }
}

/// Compiles what has been read of a text for a board; no program where something is wrong with it, which has been told.
pub fn compile(text: &str, read: Read, board: Board, mut found: Found) -> CompiledText {
    Work::note(|work| work.compiles += 1);
    let tree = read.tree.filter(|_| !found.has_errors());
    let mut made = CompiledText::default();
    if let Some(written) = &read.written {
        made.dialect = written.dialect;
        made.is_drawn = written.drawn.is_some();
    }
    if let Some(tree) = &tree {
        let written = read.written.unwrap_or_else(|| Written {
            comments: comments::of_any(text),
            units: None,
            instructions: Vec::new(),
            dialect: None,
            drawn: None,
        });
        lower_cheaply(text, tree, &written, board, &mut found, &mut made);
    }
    made.tree = tree;
    found.within(text.len());
    made.diagnostics = found.finish();
    made
}

/// So many times loops are written out, each time those that have been found too dear.
const MOST_TRIES: usize = 4;

/// Lowers a tree; where a loop in it would cost more than a scan can spend, and that alone is wrong, with it written out.
fn lower_cheaply(
    text: &str,
    tree: &Tree,
    written: &Written,
    board: Board,
    found: &mut Found,
    made: &mut CompiledText,
) {
    let before = found.clone();
    lower(text, tree, written, board, found, made);
    let mut dear = HashSet::new();
    let mut loops = found.place_of(Code::BoardLoop);
    for _ in 0..MOST_TRIES {
        if loops.is_none_or(|at| !dear.insert(at)) {
            return;
        }
        let Some(tree) = turns::written_out(tree, &dear) else {
            return;
        };
        let mut own = before.clone();
        let mut other = CompiledText {
            dialect: made.dialect,
            is_drawn: made.is_drawn,
            ..CompiledText::default()
        };
        lower(text, &tree, written, board, &mut own, &mut other);
        if !own.has_errors() {
            (*found, *made) = (own, other);
            return;
        }
        loops = own.place_of(Code::BoardLoop);
    }
}

fn lower(
    text: &str,
    tree: &Tree,
    written: &Written,
    board: Board,
    found: &mut Found,
    made: &mut CompiledText,
) {
    if lacks::told(tree, found) {
        return;
    }
    let own = tree.cells.len() as u32;
    let mut flat = inline::inline(tree, found);
    if found.has_errors() {
        return;
    }
    merge::merge(&mut flat, own);
    again::reset(&mut flat);
    merge::gather(&mut flat);
    counts::mark(&mut flat);
    let uses = uses::Uses::of(&flat);
    let uses = again::keep(&mut flat, uses);
    let seats = allot::allot(tree, &flat, &uses, board, found);
    if found.has_errors() {
        return;
    }
    let mut apart = Found::default();
    let mut coder = coder::Coder {
        flat: &flat,
        uses: &uses,
        seats,
        pen: pen::Pen::new(),
        found: &mut apart,
        labels: flat.labels,
        deep: 0,
        unused: None,
        shown: false,
        noted: Vec::new(),
        named: allotter::named(tree),
        drawn: written.drawn.as_ref(),
    };
    coder.first_values(tree);
    coder.steps(&flat.body);
    coder.leave();
    coder.spare_coils();
    let finished = finish::finish(&coder, tree, text, (&flat.loops, board), found);
    let mut finished = finished;
    if let (Some(dialect), true) = (written.dialect, made.is_drawn) {
        finished.named_as_written(text, dialect);
    }
    let seats = std::mem::take(&mut coder.seats);
    let noted = std::mem::take(&mut coder.noted);
    found.join(apart);
    made.lines = finished.lines;
    if found.has_errors() {
        return;
    }
    let starts = Lines::new(text);
    let comments = Comments::new(text, &starts, &written.comments);
    let own = written.units.clone();
    let units = own.unwrap_or_else(|| units(tree, text));
    let mut places = Places::new(text, &starts, units, comments);
    places.instructions.clone_from(&written.instructions);
    made.program = emit::check(text, &made.lines, &finished.origins, board, places, found);
    if made.program.is_some() {
        made.variables = variables::variables(tree, &seats, &finished.timers);
        made.traces = traces::traces(&noted, seats.kept(), tree, text);
    }
}

/// Where the functions and function blocks of a tree stand: each as far as the next unit. Programs are told apart where
/// there are more than one.
fn units(tree: &Tree, text: &str) -> Units {
    let mut starts: Vec<(u32, Option<Arc<str>>)> = tree
        .units
        .iter()
        .filter(|unit| unit.at != Span::default())
        .map(|unit| {
            let is_named = unit.kind != UnitKind::Program || tree.programs.len() > 1;
            (unit.at.start, is_named.then(|| Arc::from(&*unit.name)))
        })
        .collect();
    starts.sort_by_key(|(start, _)| *start);
    let ends = starts.iter().skip(1).map(|(start, _)| *start);
    let ends: Vec<u32> = ends.chain([text.len() as u32 + 1]).collect();
    let units = starts.into_iter().zip(ends);
    units
        .filter_map(|((start, name), end)| Some((start..end, name?)))
        .collect()
}
