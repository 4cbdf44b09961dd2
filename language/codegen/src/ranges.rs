//! Between which bounds the value of an expression is, as far as its types and constants say.
//!
//! Owns those bounds, by which narrowing and checks are left out that change nothing. Must not know what is stored where.

use super::flat::TEMPORARY;
use unoclp_tree::{Base, Binary, Convert, Expr, ExprKind, TypeId, Unary, Width};

/// The type of what an analogue input reads.
pub(super) const ANALOGUE: TypeId = TypeId(u32::MAX);

/// The type of what a counter's number reads: it goes on beyond INT.
pub(super) const COUNT: TypeId = TypeId(u32::MAX - 1);

/// The least and the greatest value.
pub(super) type Bounds = (i128, i128);

fn wide(base: Base) -> Bounds {
    match base.width() {
        Width::Bit => (0, 1),
        Width::Unsigned => (0, u32::MAX.into()),
        _ => (i32::MIN.into(), i32::MAX.into()),
    }
}

/// These bounds, or those of the width where they go beyond it.
fn within(base: Base, (low, high): Bounds) -> Bounds {
    let (least, most) = wide(base);
    match least <= low && high <= most {
        true => (low, high),
        false => (least, most),
    }
}

fn of_type(base: Base) -> Bounds {
    base.range().unwrap_or(wide(base))
}

/// Of a whole number or a BOOL.
pub(super) fn bounds(expr: &Expr) -> Bounds {
    let base = expr.base;
    let of = |e: &Expr| bounds(e);
    match &expr.kind {
        ExprKind::Constant(value) => (value.int(), value.int()),
        ExprKind::Read(_) if expr.ty == ANALOGUE => (0, 1023),
        ExprKind::Read(_) if expr.ty == COUNT => (i32::MIN.into(), i32::MAX.into()),
        ExprKind::Read(place) if place.offset >= TEMPORARY && place.offset & 1 == 1 => wide(base),
        ExprKind::Convert(Convert::Keep, a) => within(base, of(a)),
        ExprKind::Convert(Convert::Wrap, a) if !a.base.is_real() => {
            let (low, high) = of(a);
            let (least, most) = of_type(base);
            match least <= low && high <= most {
                true => (low, high),
                false => (least, most),
            }
        }
        ExprKind::Unary(op, a) if !a.base.is_real() => {
            let (low, high) = of(a);
            match op {
                Unary::Negate => within(base, (-high, -low)),
                Unary::Not if base.width() == Width::Signed => (!high, !low),
                Unary::Abs => within(base, (0, low.abs().max(high.abs()))),
                Unary::Sqrt => (0, 65_536),
                Unary::Low(bits, false) => (0, (1 << bits) - 1),
                Unary::Not | Unary::Low(..) | Unary::Order => wide(base),
            }
        }
        ExprKind::Binary(op, a, b) if !a.base.is_real() => of_two(*op, base, of(a), of(b)),
        ExprKind::Select(three) => join(of(&three[1]), of(&three[2])),
        ExprKind::Mux(_, all) => all.iter().map(of).fold((0, 0), join),
        _ => of_type(base),
    }
}

fn join(a: Bounds, b: Bounds) -> Bounds {
    (a.0.min(b.0), a.1.max(b.1))
}

fn of_two(op: Binary, base: Base, a: Bounds, b: Bounds) -> Bounds {
    let corners = |f: fn(i128, i128) -> i128| {
        let all = [f(a.0, b.0), f(a.0, b.1), f(a.1, b.0), f(a.1, b.1)];
        let least = all.into_iter().min().unwrap_or(0);
        (least, all.into_iter().max().unwrap_or(0))
    };
    let both = a.0 >= 0 && b.0 >= 0;
    let full = |high: i128| (1_i128 << (128 - high.leading_zeros())) - 1;
    match op {
        Binary::Add => within(base, (a.0 + b.0, a.1 + b.1)),
        Binary::Subtract => within(base, (a.0 - b.1, a.1 - b.0)),
        Binary::Multiply => within(base, corners(|x, y| x * y)),
        Binary::Divide => {
            let most = a.0.abs().max(a.1.abs());
            within(base, (if both { 0 } else { -most }, most))
        }
        Binary::Modulo => {
            let most = (b.0.abs().max(b.1.abs()) - 1).clamp(0, a.0.abs().max(a.1.abs()).max(0));
            let low = if a.0 >= 0 { 0 } else { -most };
            (low, most)
        }
        Binary::And if a.0 >= 0 && b.0 >= 0 => (0, a.1.min(b.1)),
        Binary::And if a.0 >= 0 => (0, a.1),
        Binary::And if b.0 >= 0 => (0, b.1),
        Binary::Or | Binary::Xor if both => (0, full(a.1.max(b.1))),
        Binary::Min => (a.0.min(b.0), a.1.min(b.1)),
        Binary::Max => (a.0.max(b.0), a.1.max(b.1)),
        Binary::ShiftLeft | Binary::ShiftRight | Binary::RotateLeft | Binary::RotateRight => {
            of_type(base)
        }
        Binary::TodPlusTime | Binary::TodMinusTime => (0, 86_399_999),
        _ => wide(base),
    }
}

/// Of a REAL, with room for rounding.
pub(super) fn real_bounds(expr: &Expr) -> (f64, f64) {
    let all = (f64::NEG_INFINITY, f64::INFINITY);
    let of = |e: &Expr| real_bounds(e);
    let room = |(low, high): (f64, f64)| {
        let more = low.abs().max(high.abs()) * 1e-6 + 1e-30;
        match low.is_nan() || high.is_nan() {
            true => all,
            false => (low - more, high + more),
        }
    };
    match &expr.kind {
        ExprKind::Constant(value) => (value.real(), value.real()),
        ExprKind::Convert(Convert::Float, a) => {
            let (low, high) = bounds(a);
            room((low as f64, high as f64))
        }
        ExprKind::Unary(Unary::Negate, a) => {
            let (low, high) = of(a);
            (-high, -low)
        }
        ExprKind::Unary(Unary::Abs, a) => {
            let (low, high) = of(a);
            (0.0, low.abs().max(high.abs()))
        }
        ExprKind::Binary(op, a, b) => {
            let ((a, b), (c, d)) = (of(a), of(b));
            match op {
                Binary::Add => room((a + c, b + d)),
                Binary::Subtract => room((a - d, b - c)),
                Binary::Multiply => {
                    let corners = [a * c, a * d, b * c, b * d];
                    match corners.iter().any(|x| x.is_nan()) {
                        true => all,
                        false => room((
                            corners.into_iter().fold(f64::INFINITY, f64::min),
                            corners.into_iter().fold(f64::NEG_INFINITY, f64::max),
                        )),
                    }
                }
                Binary::Divide if c == d && c != 0.0 => {
                    room(((a / c).min(b / c), (a / c).max(b / c)))
                }
                _ => all,
            }
        }
        _ => all,
    }
}
