//! Edges that have no instance of their own: EU, ED, LDP, PLS.

use super::walk::Walk;
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::{Argument, Builder, Given, Section, Traits};
use unoclp_tree::{Expr, Kind, Standard, UnitKind};

/// The instance that an edge needs which stands here, before the unit's declarations are closed; false where there is
/// no room, which is told.
pub(super) fn declare_edge(builder: &mut Builder, edge: Opcode, at: Span) -> bool {
    let block = match edge {
        Opcode::FallingEdge => Standard::FTrig,
        _ => Standard::RTrig,
    };
    let types = &mut builder.tree.types;
    let ty = types.add_kind(Kind::Standard(block), block.cells());
    let traits = Traits {
        unseen: true,
        ..Traits::default()
    };
    let made = builder.declare(&edge_name(at), at, ty, Section::Var, traits);
    made.is_some()
}

fn edge_name(at: Span) -> String {
    format!("#edge {}", at.start)
}

/// What a call gives to the parameter of this name.
pub(super) fn named(name: &str, expr: Expr) -> Argument {
    Argument {
        name: Some((name.to_owned(), expr.at)),
        out: false,
        at: expr.at,
        given: Given::Value(expr),
    }
}

impl Walk<'_, '_, '_> {
    /// Whether a bit has risen or fallen since this line asked last; none where it cannot be asked, which is told.
    pub(super) fn edge_of(&mut self, bit: Expr, at: Span) -> Option<Expr> {
        if self.built().kind_here() == Some(UnitKind::Function) {
            let word = self.built().written(at);
            self.tell(Code::Stateless, at, [word.into()]);
            return None;
        }
        let name = edge_name(at);
        // There may have been too many to declare.
        self.built().find(&name)?;
        let target = self.builder().name(&name, at)?;
        let given = vec![named("CLK", bit)];
        let body = self.builder().block(target.clone(), given, at);
        // It changes nothing that a text can name.
        body.into_iter().for_each(|one| self.push(one));
        let q = self.builder().member(target, "Q", at)?;
        Some(self.builder().read(Some(q), at))
    }
}
