//! How a text in Instruction List is written, beside what it means.

use crate::ast::{Instr, Stmt, Unit, UnitKind};
use crate::operators::Op;
use crate::parser::Parsed;
use std::sync::Arc;
use unoclp_core::isa::Opcode;
use unoclp_text::Dialect;
use unoclp_tree::{Units, Written};

/// How this text is written.
pub(crate) fn written(text: &str, parsed: Parsed, dialect: Dialect) -> Written {
    let bodies = || parsed.units.iter().flat_map(|unit| &unit.body);
    let instructions = bodies().filter_map(|stmt| match stmt {
        Stmt::Instr(instr) => Some(&**instr),
        _ => None,
    });
    let is_part = |instr: &&Instr| instr.op == Op::Part(Opcode::If);
    let parts = instructions.clone().filter(is_part);
    let parts = parts.map(|instr| instr.span.start).collect();
    Written {
        units: Some(units(text, &parsed.units)),
        instructions: instructions.map(|instr| instr.whole.start).collect(),
        dialect: Some(dialect),
        // What computes with types is written for its bytes, and not to be drawn.
        drawn: (!parsed.pieces.declares()).then_some(parts),
        comments: parsed.comments,
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
