//! The standard functions, as `docs/structured-text.md` lists them.

use super::arguments::Argument;
use super::builder::Builder;
use super::coerce::conversion;
use super::words::both;
use crate::{Base, Binary, Compare, Convert, Expr, ExprKind, Extra, Generic, TypeId, Unary};
use unoclp_text::diagnostics::{Code, Span};

/// What a function does with its operands.
#[derive(Clone, Copy, Debug)]
enum Does {
    /// Any number of operands, joined from left to right.
    Chain(Binary),
    Logic(Binary),
    Compare(Compare),
    /// Two operands.
    Two(Binary),
    Not,
    Abs,
    Sqrt,
    Trunc,
    Move,
    Power,
    Shift(Binary),
    Extreme(Binary),
    Limit,
    Select,
    Mux,
    /// The time of the scan, of no operand.
    Now,
    /// Of reals.
    Real(Extra),
    /// Of texts.
    Text(Extra),
}

/// A function: its name, its parameters by their names, and what it does. `IN1` stands for as many as are given.
struct Row(&'static str, &'static [&'static str], Does);

const IN: &[&str] = &["IN"];
const PAIR: &[&str] = &["IN1", "IN2"];

const TABLE: &[Row] = &[
    Row("ADD", PAIR, Does::Chain(Binary::Add)),
    Row("MUL", PAIR, Does::Chain(Binary::Multiply)),
    Row("SUB", PAIR, Does::Two(Binary::Subtract)),
    Row("DIV", PAIR, Does::Two(Binary::Divide)),
    Row("MOD", PAIR, Does::Two(Binary::Modulo)),
    Row("AND", PAIR, Does::Logic(Binary::And)),
    Row("OR", PAIR, Does::Logic(Binary::Or)),
    Row("XOR", PAIR, Does::Logic(Binary::Xor)),
    Row("GT", PAIR, Does::Compare(Compare::Greater)),
    Row("GE", PAIR, Does::Compare(Compare::GreaterEqual)),
    Row("EQ", PAIR, Does::Compare(Compare::Equal)),
    Row("LE", PAIR, Does::Compare(Compare::LessEqual)),
    Row("LT", PAIR, Does::Compare(Compare::Less)),
    Row("NE", PAIR, Does::Compare(Compare::NotEqual)),
    Row("NOT", IN, Does::Not),
    Row("ABS", IN, Does::Abs),
    Row("SQRT", IN, Does::Sqrt),
    Row("TRUNC", IN, Does::Trunc),
    Row("MOVE", IN, Does::Move),
    Row("EXPT", PAIR, Does::Power),
    Row("SHL", &["IN", "N"], Does::Shift(Binary::ShiftLeft)),
    Row("SHR", &["IN", "N"], Does::Shift(Binary::ShiftRight)),
    Row("ROL", &["IN", "N"], Does::Shift(Binary::RotateLeft)),
    Row("ROR", &["IN", "N"], Does::Shift(Binary::RotateRight)),
    Row("MIN", PAIR, Does::Extreme(Binary::Min)),
    Row("MAX", PAIR, Does::Extreme(Binary::Max)),
    Row("LIMIT", &["MN", "IN", "MX"], Does::Limit),
    Row("SEL", &["G", "IN0", "IN1"], Does::Select),
    Row("MUX", &["K", "IN0", "IN1"], Does::Mux),
    Row("TIME", &[], Does::Now),
    Row("SIN", IN, Does::Real(Extra::Sin)),
    Row("COS", IN, Does::Real(Extra::Cos)),
    Row("TAN", IN, Does::Real(Extra::Tan)),
    Row("ASIN", IN, Does::Real(Extra::Asin)),
    Row("ACOS", IN, Does::Real(Extra::Acos)),
    Row("ATAN", IN, Does::Real(Extra::Atan)),
    Row("LN", IN, Does::Real(Extra::Ln)),
    Row("LOG", IN, Does::Real(Extra::Log)),
    Row("EXP", IN, Does::Real(Extra::Exp)),
    Row("LEN", IN, Does::Text(Extra::Len)),
    Row("LEFT", &["IN", "L"], Does::Text(Extra::Left)),
    Row("RIGHT", &["IN", "L"], Does::Text(Extra::Right)),
    Row("MID", &["IN", "L", "P"], Does::Text(Extra::Mid)),
    Row("CONCAT", PAIR, Does::Text(Extra::Concat)),
    Row("INSERT", &["IN1", "IN2", "P"], Does::Text(Extra::Insert)),
    Row("DELETE", &["IN", "L", "P"], Does::Text(Extra::Delete)),
    Row(
        "REPLACE",
        &["IN1", "IN2", "L", "P"],
        Does::Text(Extra::Replace),
    ),
    Row("FIND", PAIR, Does::Text(Extra::Find)),
];

/// The names of the standard functions.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    TABLE.iter().map(|row| row.0)
}

/// The standard functions, each with its parameters. Of `IN1` and `IN2` alone some take more: `IN3`, …
pub fn functions() -> impl Iterator<Item = (&'static str, &'static [&'static str])> {
    TABLE.iter().map(|row| (row.0, row.1))
}

/// `INT_TO_REAL`, `TO_INT`: from what, if it says so, and to what.
fn conversion_named(name: &str) -> Option<(Option<&str>, Base)> {
    if let Some(to) = name.strip_prefix("TO_") {
        return Some((None, Base::named(to)?));
    }
    let (from, to) = name.rsplit_once("_TO_")?;
    Some((Some(from), Base::named(to)?))
}

/// The name, in capitals, of a function that the standard has for times alone too: `SUB_TIME`.
pub fn usual(name: &str) -> &str {
    match name {
        "ADD_TIME" | "ADD_TOD_TIME" | "ADD_DT_TIME" => "ADD",
        "SUB_TIME" | "SUB_TOD_TIME" | "SUB_DT_TIME" => "SUB",
        "MULTIME" | "MUL_TIME" => "MUL",
        "DIVTIME" | "DIV_TIME" => "DIV",
        name => name,
    }
}

/// Whether this is a standard function, or has the form of a conversion.
pub fn is_function(name: &str) -> bool {
    let key = name.to_uppercase();
    let key = usual(&key);
    let truncating = key.contains("_TRUNC_");
    TABLE.iter().any(|row| row.0 == key) || conversion_named(key).is_some() || truncating
}

impl Builder<'_, '_> {
    /// Whether this is a standard function, or has the form of a conversion.
    pub fn is_function(&self, name: &str) -> bool {
        is_function(name)
    }

    /// A standard function.
    pub fn function(&mut self, name: &str, arguments: Vec<Argument>, at: Span) -> Expr {
        let key = name.to_uppercase();
        let key = usual(&key);
        if let Some((from, to)) = conversion_named(key) {
            return self.conversion_function(name, from, to, Convert::Round, arguments, at);
        }
        if let Some((from, to)) = key.split_once("_TRUNC_") {
            let to = Base::named(to).filter(|to| to.is_int());
            if let (Some(base), Some(to)) = (Base::named(from), to)
                && base.is_real()
            {
                return self.conversion_function(name, Some(from), to, Convert::Cut, arguments, at);
            }
        }
        let row = TABLE.iter().find(|row| row.0 == key);
        let Some(Row(name, parameters, does)) = row else {
            let help = (
                "write the two types of the conversion: REAL_TO_INT",
                "escreva os dois tipos da conversão: REAL_TO_INT",
            );
            self.tell(Code::StNoConversion, at, [name.into(), help.into()]);
            return self.wrong(at);
        };
        let any = match does {
            Does::Chain(_) | Does::Logic(_) | Does::Compare(_) | Does::Extreme(_) | Does::Mux => {
                true
            }
            Does::Text(extra) => *extra == Extra::Concat,
            _ => false,
        };
        let Some(operands) = self.in_order(name, parameters, any, arguments, at) else {
            return self.wrong(at);
        };
        if operands
            .iter()
            .any(|operand| matches!(operand.kind, ExprKind::Wrong))
        {
            return self.wrong(at);
        }
        self.apply(name, *does, operands, at)
    }

    fn conversion_function(
        &mut self,
        name: &str,
        from: Option<&str>,
        to: Base,
        how: Convert,
        arguments: Vec<Argument>,
        at: Span,
    ) -> Expr {
        let Some(mut operands) = self.in_order(name, IN, false, arguments, at) else {
            return self.wrong(at);
        };
        let (Some(operand), None) = (operands.pop(), operands.pop()) else {
            return self.wrong(at);
        };
        let from = match from {
            None => None,
            Some("BCD") => None,
            Some(from) => match (Base::named(from), self.find_type(from)) {
                (Some(base), _) => Some(TypeId::of(base)),
                (None, Some(ty)) => Some(ty),
                _ => {
                    let help = self.near(
                        from,
                        both(
                            format!("there is no type {from}"),
                            format!("não existe o tipo {from}"),
                        ),
                    );
                    self.tell(Code::StNoConversion, at, [name.into(), help]);
                    return self.wrong(at);
                }
            },
        };
        let operand = match from {
            Some(from) if self.is_other(&operand, from) => {
                let (written, is) = (self.written(operand.at), self.type_of(&operand));
                let call = format!("{}_TO_{to}({written})", operand.base);
                let help = both(format!("write {call}"), format!("escreva {call}"));
                let from = self.tree.types.name(from);
                let words = [written.into(), is, from.into(), help];
                self.tell(Code::StMismatch, operand.at, words);
                return self.wrong(at);
            }
            Some(from) => self.coerce(operand, from),
            None => operand,
        };
        if how == Convert::Cut && !matches!(operand.kind, ExprKind::Wrong) {
            let mut expr = self.converted(operand, Convert::Cut, TypeId::of(to));
            expr.at = at;
            return expr;
        }
        let base = operand.base;
        if !matches!(operand.kind, ExprKind::Wrong)
            && !base.is_any()
            && conversion(base, to).is_none()
        {
            let help = (
                "there are conversions between numbers, bit strings, BOOL, TIME and strings, and from DT to DATE and TOD",
                "há conversões entre números, cadeias de bits, BOOL, TIME e strings, e de DT para DATE e TOD",
            );
            self.tell(Code::StNoConversion, at, [name.into(), help.into()]);
            return self.wrong(at);
        }
        self.explicit(operand, to, at)
    }

    /// Whether a value is of another type than the conversion begins with, and another conversion is meant.
    fn is_other(&self, operand: &Expr, from: TypeId) -> bool {
        let base = self.tree.types.base(from);
        if base.is_some_and(|base| self.goes_into(operand.base, base)) {
            return false;
        }
        let known = !matches!(operand.kind, ExprKind::Wrong) && !operand.base.is_any();
        known
            && !self.is_enum(from)
            && !self.is_enum(operand.ty)
            && base.is_some_and(|base| !operand.base.widens_to(base))
    }

    fn apply(&mut self, name: &str, does: Does, operands: Vec<Expr>, at: Span) -> Expr {
        match does {
            Does::Chain(op) | Does::Two(op) => self.chain(operands, at, |builder, a, b| {
                builder.arithmetic(op, a, b, at)
            }),
            Does::Logic(op) => {
                self.chain(operands, at, |builder, a, b| builder.logic(op, a, b, at))
            }
            Does::Extreme(op) => {
                self.chain(operands, at, |builder, a, b| builder.extreme(op, a, b, at))
            }
            Does::Compare(op) => self.compared(op, operands, at),
            Does::Power => self.power(operands, at),
            Does::Mux => self.mux(operands, at),
            Does::Text(extra) => self.of_texts(name, extra, operands, at),
            _ => self.apply_fixed(name, does, operands, at),
        }
    }

    fn apply_fixed(&mut self, name: &str, does: Does, operands: Vec<Expr>, at: Span) -> Expr {
        let mut operands = operands.into_iter();
        let (a, b, c) = (operands.next(), operands.next(), operands.next());
        let expr = match (does, a, b, c) {
            (Does::Not, Some(a), ..) => self.not(a, at),
            (Does::Abs, Some(a), ..) => self.of_number(name, Unary::Abs, Generic::Num, a, at),
            (Does::Sqrt, Some(a), ..) => {
                let a = if a.base == Base::AnyInt {
                    self.coerce(a, TypeId::of(Base::Real))
                } else {
                    a
                };
                self.of_number(name, Unary::Sqrt, Generic::Real, a, at)
            }
            (Does::Trunc, Some(a), ..) => self.truncated(name, a, at),
            (Does::Move, Some(a), ..) => Expr { at, ..a },
            (Does::Shift(op), Some(a), Some(b), _) => self.shift(name, op, a, b, at),
            (Does::Limit, Some(low), Some(x), Some(high)) => {
                let most = self.extreme(Binary::Max, low, x, at);
                self.extreme(Binary::Min, most, high, at)
            }
            (Does::Select, Some(which), Some(a), Some(b)) => self.select(which, a, b, at),
            (Does::Now, ..) => Expr {
                kind: ExprKind::Now,
                base: Base::Time,
                ty: TypeId::of(Base::Time),
                at,
            },
            (Does::Real(extra), Some(a), ..) => self.of_real(name, extra, a, at),
            _ => self.wrong(at),
        };
        Expr { at, ..expr }
    }
}
