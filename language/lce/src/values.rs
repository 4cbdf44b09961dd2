//! Values: the type of a variable or a constant: R, D, W, B or a bit.
//!
//! Owns the conversions between them. A value is a bit, a DINT or a REAL; a variable of mixed kinds is what its
//! marker says. Must not know operators.

use super::ast::Kind;
use super::checker::{Cells, Checker, Slot};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Base, Convert, Expr, ExprKind, Place, Root, TypeId, Value};

/// A value before it has a type.
#[derive(Clone, Debug)]
pub(super) enum Val {
    Bit(Expr),
    Whole(Expr),
    Real(Expr),
    /// A constant, and whether it is written with 2# or 16#.
    Number(Value, bool, Span),
    /// A variable of mixed kinds: its marker, its REAL and its DINT.
    Mixed(Box<[Expr; 3]>),
    Wrong(Span),
}

/// The place of a cell.
pub(super) fn place(cell: u32, at: Span) -> Place {
    Place {
        root: Root::Static,
        offset: cell,
        indices: Vec::new(),
        at,
    }
}

fn held(cell: u32, base: Base, at: Span) -> Expr {
    Expr {
        kind: ExprKind::Read(Box::new(place(cell, at))),
        base,
        ty: TypeId::of(base),
        at,
    }
}

/// The first expression where the marker holds, else the second.
fn select(flag: Expr, yes: Expr, no: Expr) -> Expr {
    let (base, ty, at) = (yes.base, yes.ty, yes.at);
    let kind = ExprKind::Select(Box::new([flag, no, yes]));
    Expr { kind, base, ty, at }
}

impl Checker<'_, '_> {
    /// What a name holds.
    pub(super) fn held(&mut self, slot: Option<Slot>, at: Span) -> Val {
        match slot {
            None => Val::Wrong(at),
            Some(Slot::Point(point)) => {
                let cell = self.builder.point(point);
                match point.is_bit() {
                    true => Val::Bit(held(cell, Base::Bool, at)),
                    false => {
                        let read = held(cell, Base::Int, at);
                        Val::Whole(self.to(read, Convert::Keep, Base::Dint))
                    }
                }
            }
            Some(Slot::Variable(number)) => match self.cells(number) {
                Cells::One(cell, Base::Bool) => Val::Bit(held(cell, Base::Bool, at)),
                Cells::One(cell, Base::Real) => Val::Real(held(cell, Base::Real, at)),
                Cells::One(cell, base) => Val::Whole(held(cell, base, at)),
                Cells::Two { flag, real, whole } => Val::Mixed(Box::new([
                    held(flag, Base::Bool, at),
                    held(real, Base::Real, at),
                    held(whole, Base::Dint, at),
                ])),
            },
        }
    }

    pub(super) fn to(&mut self, expr: Expr, how: Convert, base: Base) -> Expr {
        self.builder.converted(expr, how, TypeId::of(base))
    }

    /// Whether it may be a number with a fraction.
    pub(super) fn may_be_real(&self, val: &Val) -> bool {
        matches!(
            val,
            Val::Real(_) | Val::Mixed(_) | Val::Number(Value::Real(_), ..)
        )
    }

    /// A value as this type; `sign` is the operator that asks for it.
    pub(super) fn taken(&mut self, val: Val, kind: Kind, sign: &str) -> Expr {
        match kind {
            Kind::R => self.as_real(val),
            Kind::D => self.as_whole(val, sign),
            Kind::W | Kind::B => {
                let bit = matches!(val, Val::Bit(_));
                let whole = self.as_whole(val, sign);
                if bit { whole } else { self.cut_to(whole, kind) }
            }
        }
    }

    /// A DINT modulo 65536 or 256.
    pub(super) fn cut_to(&mut self, whole: Expr, kind: Kind) -> Expr {
        let narrow = match kind {
            Kind::W => Base::Uint,
            Kind::B => Base::Usint,
            Kind::R | Kind::D => return whole,
        };
        let cut = self.to(whole, Convert::Wrap, narrow);
        self.to(cut, Convert::Keep, Base::Dint)
    }

    fn as_real(&mut self, val: Val) -> Expr {
        match val {
            Val::Wrong(at) => self.builder.wrong(at),
            Val::Real(expr) => expr,
            Val::Bit(expr) | Val::Whole(expr) => self.to(expr, Convert::Float, Base::Real),
            Val::Number(value, _, at) => {
                let number = self
                    .builder
                    .literal(Base::Lreal, Value::Real(value.real()), at);
                self.to(number, Convert::Single, Base::Real)
            }
            Val::Mixed(parts) => {
                let [flag, real, whole] = *parts;
                let whole = self.to(whole, Convert::Float, Base::Real);
                select(flag, real, whole)
            }
        }
    }

    fn as_whole(&mut self, val: Val, sign: &str) -> Expr {
        match val {
            Val::Wrong(at) => self.builder.wrong(at),
            Val::Whole(expr) => expr,
            Val::Bit(expr) => self.to(expr, Convert::Keep, Base::Dint),
            Val::Real(expr) => self.to(expr, Convert::Cut, Base::Dint),
            Val::Number(value, based, at) => self.whole_number(&value, based, at, sign),
            Val::Mixed(parts) => {
                let [flag, real, whole] = *parts;
                let real = self.to(real, Convert::Cut, Base::Dint);
                select(flag, real, whole)
            }
        }
    }

    /// A constant as D. With 2# and 16# it gives all 32 bits.
    fn whole_number(&mut self, value: &Value, based: bool, at: Span, sign: &str) -> Expr {
        let number = match value {
            Value::Real(real) => {
                if real.fract() != 0.0 {
                    let written = self.builder.written(at);
                    let bare = sign.trim_start_matches(['D', 'W', 'B']);
                    let words = [written.into(), sign.into(), bare.into()];
                    self.builder.tell(Code::LceCut, at, words);
                }
                real.trunc() as i128
            }
            value => value.int(),
        };
        let fits = match based {
            true => u32::try_from(number).map(|bits| bits as i32).ok(),
            false => i32::try_from(number).ok(),
        };
        match fits {
            Some(number) => self
                .builder
                .literal(Base::Dint, Value::Int(number.into()), at),
            None => {
                let written = self.builder.written(at);
                self.builder.tell(Code::LceRange, at, [written.into()]);
                self.builder.wrong(at)
            }
        }
    }

    /// A value as a bit: whether it is not 0.
    pub(super) fn as_bit(&mut self, val: Val) -> Expr {
        match val {
            Val::Wrong(at) => self.builder.wrong(at),
            Val::Bit(expr) => expr,
            Val::Whole(expr) | Val::Real(expr) => self.to(expr, Convert::Test, Base::Bool),
            Val::Number(value, _, at) => {
                let truth = Value::truth(value.real() != 0.0);
                self.builder.literal(Base::Bool, truth, at)
            }
            Val::Mixed(parts) => {
                let [flag, real, whole] = *parts;
                let real = self.to(real, Convert::Test, Base::Bool);
                let whole = self.to(whole, Convert::Test, Base::Bool);
                select(flag, real, whole)
            }
        }
    }
}
