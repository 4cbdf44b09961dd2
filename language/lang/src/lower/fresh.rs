//! What is new at each call: all that a function has, VAR_TEMP of a program or function block.

use super::Lower;
use crate::ast::{Section, Stmt, Unit, UnitKind, Var};
use crate::diagnostics::Span;
use crate::names::declare::is_new;
use crate::names::{Place, kept, narrow_type};
use crate::operators::Op;
use crate::tree::{Bit, Num, Number};
use std::collections::HashSet;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

impl Lower<'_, '_> {
    /// Gives first values to what is new at this call of a unit; `given` are the inputs that the call gives.
    pub(super) fn renew(
        &mut self,
        unit: usize,
        instance: usize,
        given: &HashSet<String>,
        span: Span,
    ) {
        let unit = &self.units[unit];
        let stored = stored_first(unit);
        let renewed = |var: &&Var| {
            let given = var.section == Section::Input && given.contains(&var.name.text);
            is_new(var, unit.kind) && !given && !stored.contains(var.name.text.as_str())
        };
        let value = |var: &Var| {
            let number = var.init.first().and_then(|init| init.value.number())?;
            Some(kept(narrow_type(&var.ty.text), number))
        };
        let vars = unit.vars.iter().filter(renewed);
        let mut names: Vec<(&str, i32, Span)> = vars
            .map(|var| (&*var.name.text, value(var).unwrap_or(0), var.name.span))
            .collect();
        // The result has the function's name.
        if let (UnitKind::Function, Some(name)) = (unit.kind, &unit.name)
            && !stored.contains(name.text.as_str())
        {
            names.push((&name.text, 0, name.span));
        }
        if names.is_empty() {
            return;
        }
        self.freeze(span);
        self.rungs.fresh(span);
        let mut loaded = None;
        for (name, value, at) in names {
            match self.names.instances[instance].names.get(name).copied() {
                Some(Place::Bit(Bit::At(Address::Marker(n)))) if value == 0 => {
                    self.write(Opcode::ResetMarker, n, at);
                }
                Some(Place::Bit(Bit::At(Address::Marker(n)))) => {
                    self.write(Opcode::SetMarker, n, at)
                }
                Some(Place::Number(Num::At(Address::Register(n)))) => {
                    if loaded.replace(value) != Some(value) {
                        self.rungs.number(&Number::Leaf(Num::Const(value), at));
                    }
                    self.write(Opcode::Store, n, at);
                }
                _ => {}
            }
        }
    }
}

/// The variables that a body stores to in any case, and before it can read them: they need no first value.
fn stored_first(unit: &Unit) -> HashSet<&str> {
    let mut stored = HashSet::new();
    let mut read = HashSet::new();
    for stmt in &unit.body {
        let Stmt::Instr(instr) = stmt else { continue };
        if instr.conditional || matches!(instr.op, Op::Jump | Op::Return | Op::End | Op::Code) {
            break;
        }
        let stores = instr.op == Op::Store && !instr.starts_block();
        let operands = instr.operands.iter().map(|operand| (operand, stores));
        let params = instr.params.iter().map(|param| (&param.value, param.out));
        for (operand, stores) in operands.chain(params) {
            let Some(name) = operand.name() else { continue };
            if !stores {
                read.insert(name);
            } else if !read.contains(name) {
                stored.insert(name);
            }
        }
    }
    stored
}
