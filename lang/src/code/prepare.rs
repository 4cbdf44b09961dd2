//! What no instruction does in one piece, in steps of its own before the statement.
//!
//! Owns which expressions those are. What is left of an expression, `bits` and `numbers` write without temporaries.

use super::coder::Coder;
use super::flat::{constant, expr, place, read};
use super::inline::{both, not};
use super::ranges::{bounds, real_bounds};
use crate::diagnostics::{Code, Span};
use crate::typed::{
    Base, Binary, Compare, Convert, Expr, ExprKind, Index, Place, Store, Unary, Value,
};
use unoclp_core::isa::Opcode;

/// Values that wait at once, at most; one is left for a table.
const MOST_WAITING: u32 = 7;
/// Brackets in brackets, at most.
const MOST_DEEP: u32 = 6;

fn whole(value: i128, base: Base, at: Span) -> Expr {
    constant(Value::Int(value), base, at)
}

pub(super) fn compare(op: Compare, a: Expr, b: Expr) -> Expr {
    let at = a.at;
    expr(
        ExprKind::Compare(op, Box::new(a), Box::new(b)),
        Base::Bool,
        at,
    )
}

impl Coder<'_, '_> {
    /// A temporary for values of this type, narrowed to it.
    fn temporary(&mut self, base: Base, at: Span) -> (Place, Expr) {
        self.temporary_for(base, at, false)
    }

    fn temporary_for(&mut self, base: Base, at: Span, wide: bool) -> (Place, Expr) {
        let cell = self.seats.temporary(base == Base::Bool, wide);
        (place(cell, at), read(cell, base, at))
    }

    /// A prepared value in a temporary.
    pub(super) fn keep(&mut self, value: Expr) -> Expr {
        let wide = !self.is_within(&value, value.base);
        let (to, held) = self.temporary_for(value.base, value.at, wide);
        self.put(&to, &value);
        Expr {
            ty: value.ty,
            ..held
        }
    }

    /// Stores a prepared value as it is.
    fn put(&mut self, to: &Place, value: &Expr) {
        self.assign_prepared(to, value, Store::Narrow(Base::Dint));
    }

    /// The same value by what is simple.
    fn simple(&mut self, value: Expr) -> Expr {
        match self.operand(&value) {
            Some(_) => value,
            None => self.keep(value),
        }
    }

    pub(super) fn prepare(&mut self, from: Expr) -> Expr {
        let Expr { kind, base, ty, at } = from;
        let again = |kind| Expr { kind, base, ty, at };
        match kind {
            ExprKind::Constant(_) | ExprKind::Wrong | ExprKind::Call(_) => again(kind),
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
            ExprKind::Extra(..) => {
                self.lacking(
                    at,
                    ("this function", "esta função"),
                    (
                        "it runs on a PC alone, with unoclp run; on the board use a table of values or a straight line between two points",
                        "ela só roda no PC, com unoclp run; na placa, use uma tabela de valores ou uma reta entre dois pontos",
                    ),
                );
                constant(Value::zero(base), base, at)
            }
        }
    }

    pub(super) fn lacking(&mut self, at: Span, what: (&str, &str), instead: (&str, &str)) {
        self.found
            .tell(Code::BoardLacks, at, [what.into(), instead.into()]);
    }

    /// Brackets in brackets of a prepared BOOL.
    fn nest(&self, of: &Expr) -> u32 {
        match &of.kind {
            ExprKind::Unary(_, a) | ExprKind::Convert(_, a) => self.nest(a),
            ExprKind::Binary(_, a, b) if of.base == Base::Bool => {
                1 + self.nest(a).max(self.nest(b))
            }
            ExprKind::Compare(_, a, b) if a.base == Base::Bool => {
                2 + self.nest(a).max(self.nest(b))
            }
            _ => 0,
        }
    }

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
            let far = (low - low_bound).abs().max((high - low_bound).abs()) * stride;
            let mut number = Expr {
                base: Base::Dint,
                ..subscript.clone()
            };
            if subscript.base.width() == crate::typed::Width::Unsigned {
                number = expr(
                    ExprKind::Convert(Convert::Keep, Box::new(subscript)),
                    Base::Dint,
                    at,
                );
            }
            if index.low != 0 {
                number = both(Binary::Subtract, number, whole(low_bound, Base::Dint, at));
            }
            let inside = low >= low_bound && high < low_bound + i128::from(index.count);
            if !inside && (many || far > i128::from(i32::MAX)) {
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

    /// Stores a prepared value where a prepared condition holds. The value is computed either way.
    fn guarded(&mut self, condition: &Expr, to: &Place, value: &Expr) {
        self.bit(condition, false);
        self.value(value);
        self.store(to.offset);
    }

    fn prepare_convert(
        &mut self,
        how: Convert,
        a: Expr,
        base: Base,
        at: Span,
        ty: crate::typed::TypeId,
    ) -> Expr {
        let made = |a: Expr| Expr {
            kind: ExprKind::Convert(how, Box::new(a)),
            base,
            ty,
            at,
        };
        if a.base == Base::Bool && base != Base::Bool {
            let (to, held) = self.temporary(Base::Dint, at);
            self.bit(&a, false);
            self.pen.changes_value(Opcode::LoadBit);
            self.pen.fresh();
            self.store(to.offset);
            // 0 or 1 is in each type.
            let held = Expr { base, ..held };
            return match how {
                Convert::Float => expr(
                    ExprKind::Convert(
                        how,
                        Box::new(Expr {
                            base: Base::Dint,
                            ..held
                        }),
                    ),
                    base,
                    at,
                ),
                _ => held,
            };
        }
        if !matches!(how, Convert::Round | Convert::Cut) {
            return made(a);
        }
        let (least, most) = base.range().unwrap_or((0, 0));
        let (low, high) = real_bounds(&a);
        if low - 1.0 >= least as f64 && high + 1.0 <= most as f64
            || base == Base::Dint
            || base == Base::Time
        {
            return made(a);
        }
        if most > i128::from(i32::MAX) {
            self.lacking(
                at,
                (
                    "a conversion of REAL to a number of 32 bits without a sign",
                    "uma conversão de REAL para um número de 32 bits sem sinal",
                ),
                ("convert to DINT first", "converta antes para DINT"),
            );
            return whole(0, base, at);
        }
        let number = expr(ExprKind::Convert(how, Box::new(a)), Base::Dint, at);
        let held = self.keep(number);
        let above = compare(Compare::Greater, held.clone(), whole(most, Base::Dint, at));
        let below = compare(Compare::Less, held.clone(), whole(least, Base::Dint, at));
        self.zero_where(&both(Binary::Or, above, below), &held);
        Expr { base, ..held }
    }

    /// What a register holds becomes 0, and S 04 is set, where this holds.
    fn zero_where(&mut self, wrong: &Expr, held: &Expr) {
        self.bit(wrong, false);
        self.pen.border(Opcode::If);
        self.fail();
        if let ExprKind::Read(place) = &held.kind {
            self.store(place.offset);
        }
        self.pen.border(Opcode::EndIf);
        self.pen.holds = None;
    }

    fn absolute(&mut self, a: Expr) -> Expr {
        let (base, at) = (a.base, a.at);
        let size = expr(ExprKind::Unary(Unary::Abs, Box::new(a.clone())), base, at);
        let wide = !self.is_within(&size, base);
        let (place, held) = self.temporary_for(base, at, wide);
        self.put(&place, &a);
        let negative = compare(Compare::Less, held.clone(), whole(0, base, at));
        if self.is_unsigned(&held) {
            return held;
        }
        self.bit(&negative, false);
        self.value(&held);
        self.pen.changes_value(Opcode::Negate);
        self.store(place.offset);
        held
    }

    fn select(&mut self, which: Expr, no: Expr, yes: Expr, base: Base, at: Span) -> Expr {
        if base == Base::Bool {
            let mut which = which;
            if self.nest(&which) > 0 {
                which = self.keep(which);
            }
            let first = both(Binary::And, which.clone(), yes);
            let second = both(Binary::And, not(which), no);
            let made = both(Binary::Or, first, second);
            return if self.nest(&made) >= MOST_DEEP {
                self.keep(made)
            } else {
                made
            };
        }
        let wide = !self.is_within(&no, base) || !self.is_within(&yes, base);
        let (to, held) = self.temporary_for(base, at, wide);
        self.put(&to, &no);
        self.guarded(&which, &to, &yes);
        held
    }

    fn ordered(&mut self, op: Compare, all: Vec<Expr>, at: Span) -> Expr {
        let mut simple = Vec::with_capacity(all.len());
        for operand in all {
            let operand = self.prepare(operand);
            let bare = operand.base == Base::Bool && self.nest(&operand) == 0;
            simple.push(if bare { operand } else { self.simple(operand) });
        }
        let pairs = simple.windows(2).filter_map(|pair| match pair {
            [a, b] => Some(compare(op, a.clone(), b.clone())),
            _ => None,
        });
        let all: Vec<Expr> = pairs.collect();
        let joined = all.into_iter().reduce(|a, b| both(Binary::And, a, b));
        joined.unwrap_or_else(|| constant(Value::truth(true), Base::Bool, at))
    }

    fn mux(&mut self, which: Expr, all: Vec<Expr>, base: Base, at: Span) -> Expr {
        let which = self.prepare(which);
        let which = self.simple(which);
        let count = all.len() as i128;
        let (to, held) = match base {
            Base::Bool => {
                let (to, held) = self.temporary(Base::Dint, at);
                (to, Expr { base, ..held })
            }
            _ => self.temporary_for(base, at, true),
        };
        let values: Vec<Expr> = all.into_iter().map(|value| self.prepare(value)).collect();
        let number = |value: Expr, this: &mut Self| match value.base {
            Base::Bool => this.prepare_convert(
                Convert::Keep,
                value,
                Base::Dint,
                at,
                crate::typed::TypeId::of(Base::Dint),
            ),
            _ => value,
        };
        let mut made = Vec::with_capacity(values.len());
        for value in values {
            made.push(number(value, self));
        }
        let bare = expr(
            ExprKind::Convert(Convert::Keep, Box::new(which.clone())),
            Base::Udint,
            at,
        );
        let (low, high) = bounds(&which);
        self.put(&to, &whole(0, Base::Dint, at));
        if low < 0 || high >= count {
            let outside = compare(Compare::GreaterEqual, bare, whole(count, Base::Udint, at));
            self.zero_where(
                &outside,
                &Expr {
                    base: Base::Dint,
                    ..held.clone()
                },
            );
        }
        for (at_number, value) in (0..).zip(&made) {
            let is = compare(
                Compare::Equal,
                which.clone(),
                whole(at_number, which.base, at),
            );
            self.guarded(&is, &to, value);
        }
        held
    }

    fn prepare_binary(&mut self, op: Binary, a: Expr, b: Expr, base: Base, at: Span) -> Expr {
        let again = |a, b| expr(ExprKind::Binary(op, Box::new(a), Box::new(b)), base, at);
        let day = |sum: Expr| {
            let all = || whole(86_400_000, Base::Dint, at);
            both(Binary::Modulo, both(Binary::Add, sum, all()), all())
        };
        let within_day = |time: Expr| both(Binary::Modulo, time, whole(86_400_000, Base::Dint, at));
        let seconds = |time: Expr| {
            let time = both(Binary::Divide, time, whole(1000, Base::Time, at));
            expr(
                ExprKind::Convert(Convert::Keep, Box::new(time)),
                Base::Dt,
                at,
            )
        };
        match op {
            Binary::Min | Binary::Max if base != Base::Bool => self.extreme(op, a, b),
            Binary::Power => self.power(a, b, base, at),
            Binary::Modulo if base.is_real() => {
                self.lacking(
                    at,
                    ("MOD of REAL numbers", "MOD de números REAL"),
                    (
                        "convert to DINT first, or subtract the divisor in a loop",
                        "converta antes para DINT, ou subtraia o divisor em um laço",
                    ),
                );
                again(a, b)
            }
            Binary::ShiftLeft | Binary::ShiftRight | Binary::RotateLeft | Binary::RotateRight => {
                if !matches!(b.kind, ExprKind::Constant(_)) {
                    self.lacking(
                        at,
                        (
                            "a shift by a number that is computed",
                            "um deslocamento por um número calculado",
                        ),
                        (
                            "shift by a constant, or by 1 in a FOR loop",
                            "desloque por uma constante, ou por 1 em um laço FOR",
                        ),
                    );
                    return again(a, whole(0, Base::Dint, at));
                }
                let turns = matches!(op, Binary::RotateLeft | Binary::RotateRight);
                let a = match turns {
                    true if base.bits() < 32 && !self.is_within(&a, base) => self.keep(expr(
                        ExprKind::Convert(Convert::Wrap, Box::new(a)),
                        base,
                        at,
                    )),
                    true => self.simple(a),
                    false => a,
                };
                again(a, b)
            }
            Binary::DtPlusTime => both(Binary::Add, a, seconds(b)),
            Binary::DtMinusTime => both(Binary::Subtract, a, seconds(b)),
            Binary::TodPlusTime => {
                let sum = both(Binary::Add, within_day(b), a);
                Expr { base, ..day(sum) }
            }
            Binary::TodMinusTime => {
                let time = expr(
                    ExprKind::Unary(Unary::Negate, Box::new(within_day(b))),
                    Base::Dint,
                    at,
                );
                Expr {
                    base,
                    ..day(both(Binary::Add, time, a))
                }
            }
            Binary::DtMinusDt => self.difference(a, b, 1_000, at),
            Binary::DateMinusDate => self.difference(a, b, 86_400_000, at),
            _ => again(a, b),
        }
    }

    /// As a TIME; 0 and S 04 where it is beyond.
    fn difference(&mut self, a: Expr, b: Expr, unit: i128, at: Span) -> Expr {
        let most = i128::from(i32::MAX) / unit;
        let apart = both(Binary::Subtract, a, b);
        let apart = expr(
            ExprKind::Convert(Convert::Keep, Box::new(apart)),
            Base::Dint,
            at,
        );
        let held = self.keep(apart);
        let shifted = both(Binary::Add, held.clone(), whole(most, Base::Dint, at));
        let shifted = expr(
            ExprKind::Convert(Convert::Keep, Box::new(shifted)),
            Base::Udint,
            at,
        );
        let wrong = compare(Compare::Greater, shifted, whole(2 * most, Base::Udint, at));
        self.zero_where(&wrong, &held);
        let made = both(Binary::Multiply, held, whole(unit, Base::Dint, at));
        Expr {
            base: Base::Time,
            ..made
        }
    }

    /// The smaller or the greater.
    fn extreme(&mut self, op: Binary, a: Expr, b: Expr) -> Expr {
        let (base, at) = (a.base, a.at);
        let b = self.simple(b);
        let wide = !self.is_within(&a, base) || !self.is_within(&b, base);
        let (to, held) = self.temporary_for(base, at, wide);
        self.put(&to, &a);
        let how = match op {
            Binary::Min => Compare::Less,
            _ => Compare::Greater,
        };
        let other = compare(how, b.clone(), held.clone());
        self.guarded(&other, &to, &b);
        held
    }

    /// To a constant power, by squaring, each product rounded.
    fn power(&mut self, a: Expr, b: Expr, base: Base, at: Span) -> Expr {
        let one = || match base.is_real() {
            true => constant(Value::Real(1.0), base, at),
            false => whole(1, base, at),
        };
        let exponent = match &b.kind {
            ExprKind::Constant(value) => value.int(),
            _ => i128::MIN,
        };
        if exponent == i128::MIN || exponent < 0 && !base.is_real() || exponent.abs() > 1_000 {
            self.lacking(
                at,
                ("a power whose exponent is computed", "uma potência de expoente calculado"),
                (
                    "write a whole number from 0 to 1000 as the exponent, or multiply in a loop",
                    "escreva um número inteiro de 0 a 1000 como expoente, ou multiplique em um laço",
                ),
            );
            return one();
        }
        let mut rest = exponent.unsigned_abs();
        let mut square = if rest > 1 { self.simple(a) } else { a };
        let mut result: Option<Expr> = None;
        while rest > 0 {
            if rest & 1 == 1 {
                result = Some(match result {
                    None => square.clone(),
                    Some(result) => both(Binary::Multiply, result, square.clone()),
                });
            }
            rest >>= 1;
            if rest > 0 {
                let product = both(Binary::Multiply, square.clone(), square);
                square = match rest == 1 && result.is_none() {
                    true => product,
                    false => self.keep(product),
                };
            }
        }
        let result = result.unwrap_or_else(one);
        match exponent < 0 {
            true => both(Binary::Divide, one(), result),
            false => result,
        }
    }
}
