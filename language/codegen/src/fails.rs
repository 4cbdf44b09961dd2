//! Which expressions may set S 04.
//!
//! Owns that question, by which is computed what nothing needs the value of. Must not know instructions.

use super::flat::each;
use super::ranges::bounds;
use unoclp_tree::{Binary, Convert, Expr, ExprKind, Unary};

/// Whether computing this may set S 04.
pub(super) fn may_fail(expr: &Expr) -> bool {
    let mut may = false;
    each(expr, &mut |part| may |= may_fail_itself(part));
    may
}

fn may_fail_itself(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Constant(_) | ExprKind::Now | ExprKind::Wrong | ExprKind::Compare(..) => false,
        ExprKind::Ordered(..) | ExprKind::Select(_) => false,
        ExprKind::Read(place) => !place.indices.is_empty(),
        ExprKind::Convert(how, _) => matches!(how, Convert::Round | Convert::Cut | Convert::Fit),
        ExprKind::Unary(op, _) => *op == Unary::Sqrt,
        ExprKind::Binary(Binary::DtMinusDt | Binary::DateMinusDate | Binary::Power, ..) => true,
        ExprKind::Binary(Binary::Divide | Binary::Modulo, _, by) if !by.base.is_real() => {
            let (least, most) = bounds(by);
            least <= 0 && most >= 0
        }
        ExprKind::Binary(_, a, _) => a.base.is_real(),
        ExprKind::Mux(..) | ExprKind::Extra(..) | ExprKind::Call(_) => true,
    }
}
