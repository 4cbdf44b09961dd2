//! The way of a text in Instruction List to a checked program.

use crate::ast::{Stmt, Unit, UnitKind};
use crate::diagnostics::{Found, Severity, Told};
use crate::dialect::Dialect;
use crate::languages::{TextLanguage, compile_text};
use crate::operators::Op;
use crate::st::has_types;
use crate::{il, parser, whole};
use std::sync::Arc;
use unoclp_checked::{Checked, SourceMap};
use unoclp_codegen::{CodeLine, List, Units, Written, compile_tree, file};
use unoclp_core::Board;
use unoclp_core::isa::Opcode;

/// How to compile.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Whose Instruction List it is; none: what the text looks like.
    pub dialect: Option<Dialect>,
    /// What the program must fit.
    pub board: Board,
}

impl Options {
    /// For this board, in what its words look like.
    pub fn on(board: Board) -> Options {
        Options {
            dialect: None,
            board,
        }
    }
}

/// What has come of a text.
#[derive(Debug)]
pub struct Compiled {
    /// Whose Instruction List it was taken to be.
    pub dialect: Dialect,
    /// The lines of the program file; what could be compiled, where there are errors.
    pub lines: Vec<CodeLine>,
    /// The program, as the board's own loader has checked it, and where its steps stand in the text; none
    /// where there are errors.
    pub program: Option<(Checked, SourceMap)>,
    /// What was found in the text.
    pub diagnostics: Told,
}

impl Compiled {
    /// Whether there is no program.
    pub fn has_errors(&self) -> bool {
        self.diagnostics
            .iter()
            .any(|d| d.severity() == Severity::Error)
    }

    /// The program file with its comments, for `PROGRAM.TXT`; none where there are errors.
    pub fn file(&self) -> Option<String> {
        (!self.has_errors()).then(|| file(&self.lines))
    }

    /// The codes and operands in order.
    pub fn codes(&self) -> Vec<i32> {
        self.lines.iter().map(|line| line.code).collect()
    }
}

/// Compiles a text. It takes a time in proportion to the text's size, whatever the text is.
pub fn compile(text: &str, options: &Options) -> Compiled {
    match has_types(text) {
        true => of_types(text, options.board),
        false => compile_untyped(text, options),
    }
}

/// The same of a text that [has no types](has_types).
pub fn compile_untyped(text: &str, options: &Options) -> Compiled {
    let mut found = Found::default();
    let parsed = parser::parse(text, &mut found);
    let dialect = options.dialect.unwrap_or_else(|| parsed.signs.dialect());
    let readable = whole::is_readable(&mut found) && !parsed.wrong_declarations;
    let board = options.board;
    let tree = match readable {
        true => il::tree(text, dialect, board, &parsed.units, &mut found),
        false => None,
    };
    let bodies = parsed.units.iter().flat_map(|unit| &unit.body);
    let parts = parsed.units.iter().flat_map(|unit| &unit.body);
    let parts = parts.filter_map(|stmt| match stmt {
        Stmt::Instr(instr) if instr.op == Op::Part(Opcode::If) => Some(instr.span.start),
        _ => None,
    });
    let parts = parts.collect();
    let written = Written {
        comments: parsed.comments,
        units: Some(units(text, &parsed.units)),
        instructions: bodies
            .filter_map(|stmt| match stmt {
                Stmt::Instr(instr) => Some(instr.whole.start),
                _ => None,
            })
            .collect(),
        list: Some(List { dialect, parts }),
    };
    let made = compile_tree(text, tree, written, board, found);
    Compiled {
        dialect,
        lines: made.lines,
        program: made.program,
        diagnostics: made.diagnostics,
    }
}

/// Where the functions and function blocks stand, in that order, and what they are called.
fn units(text: &str, units: &[Unit]) -> Units {
    let named = |unit: &Unit| {
        let name = text.get(unit.name.as_ref()?.span.range())?;
        Some((unit.span.start..unit.end, Arc::from(name)))
    };
    let units = units.iter().filter(|unit| unit.kind != UnitKind::Program);
    let mut units: Units = units.filter_map(named).collect();
    units.sort_by_key(|(bytes, _)| bytes.start);
    units
}

/// A text with types or functions of the norm, which the typed tree has.
fn of_types(text: &str, board: Board) -> Compiled {
    let made = compile_text(text, TextLanguage::Il, board);
    Compiled {
        dialect: Dialect::Iec,
        lines: made.lines,
        program: made.program,
        diagnostics: made.diagnostics,
    }
}
