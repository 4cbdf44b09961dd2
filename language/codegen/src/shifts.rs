//! Shifts and rotations by any number.
//!
//! Owns how a computed number is made of constant ones. What is left, `numbers` writes.

use super::coder::Coder;
use super::flat::{both, compare, expr, whole};
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Binary, Compare, Convert, Expr, ExprKind};

impl Coder<'_, '_> {
    pub(super) fn shifted(
        &mut self,
        op: Binary,
        bits: Expr,
        by: Expr,
        base: Base,
        at: Span,
    ) -> Expr {
        let by_some = |bits, by| expr(ExprKind::Binary(op, Box::new(bits), Box::new(by)), base, at);
        let turns = matches!(op, Binary::RotateLeft | Binary::RotateRight);
        if base == Base::Bool {
            // Of one bit.
            return match turns {
                true => bits,
                false => {
                    let by = self.simple(by);
                    both(
                        Binary::And,
                        bits,
                        compare(Compare::Equal, by, whole(0, Base::Dint, at)),
                    )
                }
            };
        }
        let narrow = !self.is_within(&bits, base);
        let own = match narrow {
            true => expr(ExprKind::Convert(Convert::Wrap, Box::new(bits)), base, at),
            false => bits,
        };
        if matches!(by.kind, ExprKind::Constant(_)) {
            let own = if turns { self.simple(own) } else { own };
            return by_some(own, by);
        }
        // By 1, by 2, by 4 … where the number has that bit.
        let by = self.simple(by);
        let held = self.keep(own);
        let ExprKind::Read(to) = &held.kind else {
            return held;
        };
        let width = i128::from(base.bits());
        let mut part = 1;
        while part < width {
            let bit = both(Binary::And, by.clone(), whole(part, by.base, at));
            let has = compare(Compare::NotEqual, bit, whole(0, Base::Dint, at));
            let more = by_some(held.clone(), whole(part, Base::Dint, at));
            self.guarded(&has, to, &more);
            part *= 2;
        }
        if !turns {
            let bare = expr(
                ExprKind::Convert(Convert::Keep, Box::new(by)),
                Base::Udint,
                at,
            );
            let all = compare(Compare::GreaterEqual, bare, whole(width, Base::Udint, at));
            self.guarded(&all, to, &whole(0, base, at));
        }
        held
    }
}
