//! Computed subscripts: one number that counts registers from 0.
//!
//! Owns how several subscripts become one and what is outside is found.

use super::coder::Coder;
use super::flat::expr;
use super::flat::{both, compare, whole};
use super::prepare::MOST_WAITING;
use super::ranges::bounds;
use unoclp_tree::{Base, Binary, Compare, Convert, Expr, ExprKind, Index, Place};

impl Coder<'_, '_> {
    /// A place with one subscript at most, which counts registers from 0.
    pub(super) fn prepare_place(&mut self, from: Place) -> Place {
        if from.indices.is_empty() {
            return from;
        }
        let at = from.at;
        let reach = super::uses::reach(&from);
        let many = from.indices.len() > 1;
        let mut sum: Option<Expr> = None;
        let mut outside: Option<Expr> = None;
        for index in from.indices {
            let subscript = self.prepare(index.subscript);
            let (low, high) = bounds(&subscript);
            let low_bound = i128::from(index.low);
            let stride = i128::from(index.stride);
            let [least, most] = [low, high].map(|end| (end - low_bound) * stride);
            let fits = i128::from(i32::MIN) <= least && most <= i128::from(i32::MAX);
            // As a DINT, by a node of its own: another type for this one would undo a conversion that it is.
            let mut number = expr(
                ExprKind::Convert(Convert::Keep, Box::new(subscript)),
                Base::Dint,
                at,
            );
            if index.low != 0 {
                number = both(Binary::Subtract, number, whole(low_bound, Base::Dint, at));
            }
            let inside = low >= low_bound && high < low_bound + i128::from(index.count);
            if !inside && (many || !fits) {
                number = self.simple(number);
                let count = whole(index.count.into(), Base::Udint, at);
                let bare = expr(
                    ExprKind::Convert(Convert::Keep, Box::new(number.clone())),
                    Base::Udint,
                    at,
                );
                let beyond = compare(Compare::GreaterEqual, bare, count);
                outside = Some(match outside {
                    None => beyond,
                    Some(other) => both(Binary::Or, other, beyond),
                });
            }
            if stride != 1 {
                number = both(Binary::Multiply, number, whole(stride, Base::Dint, at));
            }
            sum = Some(match sum {
                None => number,
                Some(sum) => both(Binary::Add, sum, number),
            });
        }
        let mut subscript = sum.unwrap_or_else(|| whole(0, Base::Dint, at));
        if let Some(outside) = outside {
            let (to, held) = self.temporary(Base::Dint, at);
            self.put(&to, &subscript);
            self.guarded(&outside, &to, &whole(-1, Base::Dint, at));
            subscript = held;
        } else if self.height(&subscript) >= MOST_WAITING {
            subscript = self.keep(subscript);
        }
        let index = Index {
            subscript,
            low: 0,
            count: reach + 1,
            stride: 1,
        };
        Place {
            indices: vec![index],
            ..from
        }
    }
}
