//! Inputs that are edges of what a call gives them: `x : BOOL R_EDGE` (IEC 61131-3, 2.5.2.2).

use super::arguments::{Argument, Given};
use super::builder::Builder;
use super::named::{Named, Section, Traits, Variable};
use super::places::Target;
use crate::standard::Standard;
use crate::{Kind, Stmt, TypeId};
use unoclp_text::diagnostics::Span;

/// An input, and the instance that sees its edges.
pub struct EdgeInput {
    input: Variable,
    instance: Variable,
}

impl Builder<'_, '_> {
    /// Declares what sees the edges of this input of the unit that the builder is in; none of what is no input.
    pub fn edge_input(&mut self, name: &str, is_rising: bool, at: Span) -> Option<EdgeInput> {
        let block = match is_rising {
            true => Standard::RTrig,
            false => Standard::FTrig,
        };
        let Some(Named::Variable(input)) = self.find(name).cloned() else {
            return None;
        };
        let ty = self
            .tree
            .types
            .add_kind(Kind::Standard(block), block.cells());
        let traits = Traits {
            unseen: true,
            ..Traits::default()
        };
        let instance = self.declare(&format!("#{name}"), at, ty, Section::Var, traits)?;
        Some(EdgeInput { input, instance })
    }

    /// From here on the name of the input is its edge; gives what the unit does before all else.
    pub fn see_edge(&mut self, edge: EdgeInput) -> Vec<Stmt> {
        let EdgeInput { input, instance } = edge;
        let at = input.at;
        let target = |variable: &Variable| Target {
            place: variable.place(at),
            ty: variable.ty,
            locked: None,
            value: None,
            result: false,
            input: false,
            at,
        };
        let given = Argument {
            name: None,
            out: false,
            given: Given::Place(target(&input)),
            at,
        };
        let statements = self.block(target(&instance), vec![given], at);
        let key = self.key(&input.name);
        let q = Standard::RTrig.part("Q").map_or(0, |(q, _)| q);
        let edge = Variable {
            ty: TypeId::BOOL,
            root: instance.root,
            offset: instance.offset + q,
            ..input
        };
        if let Some(draft) = self.here() {
            draft.names.insert(key, Named::Variable(edge));
        }
        statements
    }
}
