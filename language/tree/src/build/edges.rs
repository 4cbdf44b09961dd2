//! Inputs that are edges of what a call gives them: `x : BOOL R_EDGE` (IEC 61131-3, 2.5.2.2).

use super::arguments::{Argument, Given};
use super::builder::Builder;
use super::named::{Named, Section, Traits, Variable};
use super::places::Target;
use crate::standard::Standard;
use crate::{Kind, Stmt, TypeId, UnitKind};
use unoclp_text::diagnostics::{Code, Span};

/// `R_EDGE` or `F_EDGE`, after the type of an input.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    /// Whether it is `R_EDGE`.
    pub is_rising: bool,
    /// Where it stands.
    pub span: Span,
}

impl Edge {
    /// The one that this word means.
    pub fn named(word: &str, span: Span) -> Option<Edge> {
        let is_rising = word.eq_ignore_ascii_case("R_EDGE");
        (is_rising || word.eq_ignore_ascii_case("F_EDGE")).then_some(Edge { is_rising, span })
    }
}

/// An input, and the instance that sees its edges.
pub struct EdgeInput {
    input: Variable,
    instance: Variable,
}

impl Builder<'_, '_> {
    fn told_no_edge(&mut self, edge: Edge) {
        let help = (
            "declare an R_TRIG or F_TRIG, call it with the variable, and read its Q",
            "declare um R_TRIG ou F_TRIG, chame-o com a variável e leia o seu Q",
        );
        let written = self.written(edge.span);
        let words = [written.into(), help.into()];
        self.tell(Code::StUnsupported, edge.span, words);
    }

    /// Declares what sees the edges of this input of the unit that the builder is in. An edge belongs to a BOOL among the inputs
    /// of a block or program; elsewhere there is none, which is told.
    pub fn edge_input(&mut self, name: &str, edge: Edge, at: Span) -> Option<EdgeInput> {
        let block = match edge.is_rising {
            true => Standard::RTrig,
            false => Standard::FTrig,
        };
        let Some(Named::Variable(input)) = self.find(name).cloned() else {
            return None;
        };
        let is_input = input.section == Section::Input && input.ty == TypeId::BOOL;
        if !is_input || self.kind_here() == Some(UnitKind::Function) {
            self.told_no_edge(edge);
            return None;
        }
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
