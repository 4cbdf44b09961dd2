//! A run through a body on expressions: what it holds on its way.

use super::front::Front;
use super::run::{Acc, Run};
use super::said::{ACCUMULATOR, BOOL, NUMBER, constant};
use crate::ast::{Instr, Operand, Stmt};
use unoclp_text::diagnostics::{Code, Span, Word};
use unoclp_tree::build::{Builder, Target};
use unoclp_tree::{Base, Compare, Expr, ExprKind, Standard, Stmt as Made, StmtKind, Store, TypeId};

/// A block whose inputs are being connected.
pub(super) struct Block {
    pub operand: Operand,
    pub block: Option<(Target, Standard)>,
    pub name: String,
    pub span: Span,
    /// IN, or CU.
    pub start: Option<Expr>,
    pub down: Option<Expr>,
    pub reset: Option<Expr>,
    pub set: Option<Expr>,
    /// It stands in the program; what follows uses its outputs.
    pub written: bool,
}

pub(super) struct Walk<'w, 'a, 'f> {
    pub front: &'w mut Front<'a, 'f>,
    pub body: &'a [Stmt],
    pub unit: usize,
    pub instance: usize,
    pub run: Run,
    pub block: Option<Block>,
    /// The type of what an operand is to meet: the values of an enumeration are looked for there first.
    pub hint: Option<TypeId>,
}

impl<'a, 'f> Walk<'_, 'a, 'f> {
    pub(super) fn builder(&mut self) -> &mut Builder<'a, 'f> {
        &mut self.front.c.builder
    }

    /// The builder, of which something is asked.
    pub(super) fn built(&self) -> &Builder<'a, 'f> {
        &self.front.c.builder
    }

    /// Tells what is wrong.
    pub(super) fn tell<const N: usize>(&mut self, code: Code, at: Span, words: [Word; N]) {
        self.front.c.builder.found.tell(code, at, words);
    }

    /// A value as a condition: a number is true if it is not 0. What cannot be one is told.
    pub(super) fn tested(&mut self, expr: Expr, span: Span) -> Option<Expr> {
        if expr.base == Base::Bool || matches!(constant(&expr), Some(0..=1)) {
            return self.as_bit(expr, ACCUMULATOR, span);
        }
        if expr.base == Base::AnyReal {
            return self.as_bit(expr, ACCUMULATOR, span);
        }
        if !self.is_plain(&expr) {
            let expr = self.front.c.builder.condition(expr);
            return (!matches!(expr.kind, ExprKind::Wrong)).then_some(expr);
        }
        let none = self.whole(0, span);
        let builder = &mut self.front.c.builder;
        Some(builder.compare(Compare::NotEqual, expr, none, span))
    }

    /// A value as it is left for a label, where another way to it may have left one already; one that does not fit is told.
    pub(super) fn carries(
        &mut self,
        mut expr: Expr,
        to: Option<&Target>,
        span: Span,
    ) -> Option<Expr> {
        let base = to.and_then(|to| self.front.c.builder.tree.types.base(to.ty));
        if !self.is_plain(&expr) {
            return Some(self.front.c.builder.settled(expr));
        }
        if base == Some(Base::Bool)
            && let Some(number @ 0..=1) = constant(&expr)
        {
            // The constants 0 and 1 are both bit and number.
            expr = self.truth(number == 1, span);
        }
        let (is, needed) = match (base, expr.base == Base::Bool) {
            (Some(Base::Bool), false) => (NUMBER, BOOL),
            (Some(Base::Dint), true) => (BOOL, NUMBER),
            _ => return Some(expr),
        };
        self.wrong_type(ACCUMULATOR.into(), span, is, needed);
        None
    }

    /// The statement that stores a value, in the bits of the place's type.
    pub(super) fn assigned(&mut self, target: &Target, value: Expr, at: Span) -> Option<Made> {
        if !self.is_plain_type(target.ty) || !self.is_plain(&value) {
            return self.typed_assigned(target, value, at);
        }
        let base = self.front.c.builder.tree.types.base(target.ty)?;
        let value = self.fit(value, target.ty, base);
        if matches!(value.kind, ExprKind::Wrong) {
            return None;
        }
        let kind = StmtKind::Assign(target.place.clone(), value, Store::Narrow(base));
        Some(Made { kind, at })
    }

    /// What no operator of this reader comes to.
    pub(super) fn not_yet(&mut self, at: Span) {
        self.run.unused = None;
        self.run.acc = Acc::Wrong;
        let word = self.front.names.written(at);
        self.tell(Code::StUnsupported, at, [word.into(), "".into()]);
    }

    pub(super) fn next(&self) -> Option<&'a Stmt> {
        self.body.get(self.run.at + 1)
    }

    /// An instruction takes so many operands, and no more.
    pub(super) fn only(&mut self, instr: &Instr, most: usize) {
        if let Some(more) = instr.operands.get(most) {
            let text = self.spelled(more);
            self.tell(Code::Unexpected, more.span, [text.into()]);
        }
    }

    pub(super) fn missing(&mut self, what: &str, span: Span) {
        let example: (&str, &str) = match what {
            "ST" | "S" | "R" => ("Q1 or M1", "Q1 ou M1"),
            "JMP" => ("the name of a label", "o nome de um rótulo"),
            "CAL" | "BLK" | "IN" | "TON" | "TOF" | "TP" | "TONR" => ("T1 or C1", "T1 ou C1"),
            "CU" | "CD" | "CTU" | "CTD" | "CTUD" => ("C1", "C1"),
            "CLK" => ("the name of an R_TRIG", "o nome de um R_TRIG"),
            "CODE" => ("827301", "827301"),
            _ => ("I1, Q1 or M1", "I1, Q1 ou M1"),
        };
        self.tell(Code::OperandMissing, span, [what.into(), example.into()]);
    }
}
