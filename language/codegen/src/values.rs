//! Expressions and places of a unit as those of the program.
//!
//! Owns the order in which operands and the calls in them are computed.

use super::flat::{Does, constant, place, read};
use super::inline::{Frame, Inliner, MOST_HIGH};
use super::pure;
use super::ranges::ANALOGUE;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Expr, ExprKind, Place, Root, Store, Value, Width};

pub(super) fn zero() -> Expr {
    constant(Value::Int(0), Base::Dint, Span::default())
}

impl Inliner<'_, '_> {
    pub(super) fn place(&mut self, from: &Place, frame: &Frame) -> Place {
        let mut made = match from.root {
            Root::Static => place(0, from.at),
            Root::Own => place(frame.own, from.at),
            Root::Local => place(frame.local, from.at),
            Root::Lent(number) => match frame.lent.get(number as usize) {
                Some(lent) => lent.clone(),
                None => place(0, from.at),
            },
        };
        made.at = from.at;
        made.offset += from.offset;
        for index in &from.indices {
            let subscript = self.expr(&index.subscript, frame);
            made.indices.push(unoclp_tree::Index {
                subscript,
                ..index.clone()
            });
        }
        made
    }

    /// The same expression of the program; 0 where it is too large, which is told.
    pub(super) fn expr(&mut self, from: &Expr, frame: &Frame) -> Expr {
        if self.high >= MOST_HIGH {
            self.too_large.get_or_insert(from.at);
        }
        if self.too_large.is_some() {
            return constant(Value::zero(from.base), from.base, from.at);
        }
        self.high += 1;
        let made = self.any_expr(from, frame);
        self.high -= 1;
        made
    }

    fn any_expr(&mut self, from: &Expr, frame: &Frame) -> Expr {
        let kind = match &from.kind {
            ExprKind::Constant(_) | ExprKind::Wrong => from.kind.clone(),
            ExprKind::Read(place) => {
                if place.root == Root::Local
                    && place.indices.is_empty()
                    && let Some(given) = frame.given.get(&place.offset)
                {
                    return given.clone();
                }
                let place = self.place(place, frame);
                let ty = match self.analogue.contains(&place.offset) {
                    true => ANALOGUE,
                    false => from.ty,
                };
                let kind = ExprKind::Read(Box::new(place));
                return Expr {
                    ty,
                    ..from.with(kind)
                };
            }
            ExprKind::Convert(how, a) => ExprKind::Convert(*how, Box::new(self.expr(a, frame))),
            ExprKind::Unary(op, a) => ExprKind::Unary(*op, Box::new(self.expr(a, frame))),
            ExprKind::Binary(op, a, b) => {
                let [a, b] = self.operands([&**a, &**b], frame);
                ExprKind::Binary(*op, Box::new(a), Box::new(b))
            }
            ExprKind::Compare(op, a, b) => {
                let [a, b] = self.operands([&**a, &**b], frame);
                ExprKind::Compare(*op, Box::new(a), Box::new(b))
            }
            ExprKind::Select(three) => {
                let made = self.operands([&three[0], &three[1], &three[2]], frame);
                ExprKind::Select(Box::new(made))
            }
            ExprKind::Now => return read(self.flat.now(), from.base, from.at),
            ExprKind::Ordered(op, all) => ExprKind::Ordered(*op, self.all(all, frame)),
            ExprKind::Extra(function, all) => ExprKind::Extra(*function, self.all(all, frame)),
            ExprKind::Mux(which, all) => {
                let which = self.expr(which, frame);
                ExprKind::Mux(Box::new(which), self.all(all, frame))
            }
            ExprKind::Call(call) => {
                let Some(result) = self.call(call, frame) else {
                    return constant(Value::zero(from.base), from.base, from.at);
                };
                // A later call of the same function has cells of its own, so this stays.
                return Expr {
                    ty: from.ty,
                    ..read(result, from.base, from.at)
                };
            }
        };
        from.with(kind)
    }

    /// Operands in their order: what a call after them might change is put aside.
    fn operands<const N: usize>(&mut self, from: [&Expr; N], frame: &Frame) -> [Expr; N] {
        let mut at = 0;
        from.map(|operand| {
            let made = self.expr(operand, frame);
            at += 1;
            match from[at..]
                .iter()
                .any(|later| pure::may_change(&self.pure, later))
            {
                true => self.aside(made),
                false => made,
            }
        })
    }

    fn all(&mut self, from: &[Expr], frame: &Frame) -> Vec<Expr> {
        // Of each, whether one after it may change something: asked once, from the last to the first.
        let mut changes = false;
        let later = from.iter().rev().map(|operand| {
            let later = changes;
            changes |= pure::may_change(&self.pure, operand);
            later
        });
        let later: Vec<bool> = later.collect();
        let mut made = Vec::with_capacity(from.len());
        for (operand, later) in from.iter().zip(later.into_iter().rev()) {
            let value = self.expr(operand, frame);
            made.push(if later { self.aside(value) } else { value });
        }
        made
    }

    /// A value in a cell of its own, which is not narrowed: nothing is stored there.
    pub(super) fn aside(&mut self, value: Expr) -> Expr {
        if matches!(value.kind, ExprKind::Constant(_)) {
            return value;
        }
        let at = value.at;
        let base = match value.base.width() {
            Width::Signed => Base::Dint,
            _ => value.base,
        };
        let cell = self.temporary(base);
        self.push(
            Does::Assign(place(cell, at), value, Store::Narrow(base)),
            at,
        );
        read(cell, base, at)
    }
}
