//! Edges that have no instance of their own: EU, ED, LDP, PLS.

use super::used::edge_name;
use super::walk::Walk;
use crate::ast::{Instr, UnitKind};
use crate::diagnostics::Code;
use crate::list::{Accumulator, Machine};
use crate::typed::build::{Argument, Given};
use crate::typed::{Expr, Standard};
use unoclp_core::isa::Opcode;

impl Walk<'_, '_, '_> {
    /// Whether a bit has risen or fallen since this instruction asked last.
    pub(super) fn edge_of(&mut self, bit: Expr, instr: &Instr) -> Option<Expr> {
        let span = instr.span;
        if self.front.kind_of(self.unit) == UnitKind::Function {
            let name = self.front.names.written(span);
            self.tell(Code::Stateless, span, [name.into()]);
            return None;
        }
        let name = edge_name(span);
        let target = self.front.builder.name(&name, span)?;
        let given = vec![given("CLK", bit)];
        let body = self.front.builder.block(target.clone(), given, span);
        // It changes nothing that a text can name.
        body.into_iter().for_each(|one| self.push(one));
        let block = match instr.edge {
            Some(Opcode::FallingEdge) => Standard::FTrig,
            _ => Standard::RTrig,
        };
        let q = self.part_of(target, block, "Q")?;
        Some(self.read(q, span))
    }
}

/// What a call gives to the parameter of this name.
pub(super) fn given(name: &str, expr: Expr) -> Argument {
    Argument {
        name: Some((name.to_owned(), expr.at)),
        out: false,
        at: expr.at,
        given: Given::Value(expr),
    }
}
