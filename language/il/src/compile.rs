//! The way of a text in Instruction List to a checked program.

use crate::ast::{Instr, Stmt, Unit, UnitKind};
use crate::check;
use crate::operators::Op;
use std::sync::Arc;
use unoclp_checked::{Checked, SourceMap};
use unoclp_codegen::{
    CodeLine, CompiledText, List, Trace, Units, Variable, Written, compile_tree, file,
};
use unoclp_core::Board;
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::{Found, Severity, Told};
use unoclp_text::dialect::Dialect;

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
    /// Its variables, as the board keeps them; none where its points show all of them.
    pub variables: Vec<Variable>,
    /// What its lines show of a scan, likewise.
    pub traces: Vec<Trace>,
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
    let (dialect, has_types, made) = listed(text, options);
    let (variables, traces) = match has_types {
        true => (made.variables, made.traces),
        false => Default::default(),
    };
    Compiled {
        dialect,
        lines: made.lines,
        program: made.program,
        variables,
        traces,
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

/// The same, with its tree.
pub fn compile_list(text: &str, options: &Options) -> CompiledText {
    listed(text, options).2
}

fn listed(text: &str, options: &Options) -> (Dialect, bool, CompiledText) {
    let mut found = Found::default();
    let listed = check::read(text, options.dialect, options.board, &mut found);
    let (parsed, dialect) = (listed.parsed, listed.dialect);
    let has_types = parsed.pieces.declares();
    let bodies = || parsed.units.iter().flat_map(|unit| &unit.body);
    let instructions = bodies().filter_map(|stmt| match stmt {
        Stmt::Instr(instr) => Some(&**instr),
        _ => None,
    });
    let is_part = |instr: &&Instr| instr.op == Op::Part(Opcode::If);
    let parts = instructions.clone().filter(is_part);
    let parts = parts.map(|instr| instr.span.start).collect();
    let written = Written {
        units: Some(units(text, &parsed.units)),
        instructions: instructions.map(|instr| instr.whole.start).collect(),
        // What computes with types is written for its bytes, and not to be drawn.
        list: (!has_types).then_some(List { dialect, parts }),
        comments: parsed.comments,
    };
    let made = compile_tree(text, listed.tree, written, options.board, found);
    (dialect, has_types, made)
}
