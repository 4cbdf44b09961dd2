//! What no instruction does in one piece, in steps of its own before the statement.
//!
//! Owns which expressions those are. What is left of an expression, `bits` and `numbers` write without temporaries.

use super::coder::Coder;
use super::flat::constant;
use super::ranges::bounds;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Base, Binary, Expr, ExprKind, Unary, Value};

/// Values that wait at once, at most; one is left for a table.
pub(super) const MOST_WAITING: u32 = 7;
/// Brackets in brackets, at most.
pub(super) const MOST_DEEP: u32 = 6;

impl Coder<'_, '_> {
    pub(super) fn prepare(&mut self, from: Expr) -> Expr {
        let Expr { kind, base, ty, at } = from;
        let again = |kind| Expr { kind, base, ty, at };
        match kind {
            ExprKind::Constant(_) | ExprKind::Now | ExprKind::Wrong | ExprKind::Call(_) => {
                again(kind)
            }
            ExprKind::Read(place) => {
                let place = self.prepare_place(*place);
                again(ExprKind::Read(Box::new(place)))
            }
            ExprKind::Convert(how, a) => {
                let a = self.prepare(*a);
                self.prepare_convert(how, a, base, at, ty)
            }
            ExprKind::Unary(op, a) => {
                let a = self.prepare(*a);
                match op {
                    Unary::Abs if !a.base.is_real() && bounds(&a).0 < 0 => self.absolute(a),
                    Unary::Abs if !a.base.is_real() => a,
                    _ => again(ExprKind::Unary(op, Box::new(a))),
                }
            }
            ExprKind::Binary(op, a, b) => {
                let (mut a, mut b) = (self.prepare(*a), self.prepare(*b));
                if base == Base::Bool {
                    if self.nest(&a) >= MOST_DEEP {
                        a = self.keep(a);
                    }
                    if self.nest(&b) >= MOST_DEEP {
                        b = self.keep(b);
                    }
                } else if self.height(&b) >= MOST_WAITING {
                    b = self.keep(b);
                }
                self.prepare_binary(op, a, b, base, at)
            }
            ExprKind::Compare(op, a, b) => {
                let (a, mut b) = (self.prepare(*a), self.prepare(*b));
                if self.height(&b) >= MOST_WAITING {
                    b = self.keep(b);
                }
                again(ExprKind::Compare(op, Box::new(a), Box::new(b)))
            }
            ExprKind::Ordered(op, all) => self.ordered(op, all, at),
            ExprKind::Select(three) => {
                let [which, no, yes] = *three;
                let (which, no) = (self.prepare(which), self.prepare(no));
                let yes = self.prepare(yes);
                self.select(which, no, yes, base, at)
            }
            ExprKind::Mux(which, all) => self.mux(*which, all, base, at),
            // Told before.
            ExprKind::Extra(..) => constant(Value::zero(base), base, at),
        }
    }

    pub(super) fn lacking(&mut self, at: Span, what: (&str, &str), instead: (&str, &str)) {
        self.found
            .tell(Code::BoardLacks, at, [what.into(), instead.into()]);
    }

    /// Brackets in brackets of a prepared BOOL.
    pub(super) fn nest(&self, of: &Expr) -> u32 {
        match &of.kind {
            ExprKind::Unary(_, a) | ExprKind::Convert(_, a) => self.nest(a),
            ExprKind::Binary(op, a, b) if of.base == Base::Bool => {
                // Contacts in a row stand beside each other, and so do branches.
                let part = |of: &Expr| match &of.kind {
                    ExprKind::Binary(inner @ (Binary::And | Binary::Or), ..) if inner == op => {
                        self.nest(of)
                    }
                    _ => 1 + self.nest(of),
                };
                part(a).max(part(b))
            }
            ExprKind::Compare(_, a, b) if a.base == Base::Bool => {
                2 + self.nest(a).max(self.nest(b))
            }
            _ => 0,
        }
    }
}
