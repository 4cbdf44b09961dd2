//! Expressions of Structured Text, as they are put together from steps.
//!
//! Owns their simplification and how they are written. Must not know instructions, nor what a place is called.

use std::fmt::Write;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

/// What a number is taken for: the same 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum View {
    Whole,
    Real,
}

/// What holds a bit or a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Place {
    /// A point, or a part of a timer or of a counter that is a block, by their numbers.
    At(Address),
    /// The pin of an input that is filtered, and the timers that do so.
    Pin(u8),
    FilterOn(u8),
    FilterOff(u8),
    Register(u8, View),
    /// The array that begins with this register.
    Table(u8),
    /// What a counter that is none has seen of CU, and of CD.
    CountUp(u8),
    CountDown(u8),
    EdgeQ(u16),
    /// What an edge in a loop has seen.
    EdgeBefore(u16),
    /// Branch point XX of a rung.
    Branch(u8),
    /// A bit, a number, and bits that are taken for a number of the other kind, within a rung.
    Bit(u16),
    Number(u16, View),
    /// The value accumulator, where it lasts.
    Value(View),
    /// The label that is jumped to; 0 if none is.
    Jump,
    /// Always 0: what is divided by a constant 0.
    Zero(View),
}

/// The type of a whole number in an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Type {
    Dint,
    Dword,
    Udint,
    Real,
    Time,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Expr {
    Is(bool),
    Place(Place),
    /// A constant of this type, by its bits.
    Constant(i32, Type),
    Not(Box<Expr>),
    /// Two or more.
    And(Vec<Expr>),
    Or(Vec<Expr>),
    Xor(Box<Expr>, Box<Expr>),
    Compare(&'static str, Box<Expr>, Box<Expr>),
    /// An operator of numbers, and how tightly it binds.
    Binary(&'static str, u8, Box<Expr>, Box<Expr>),
    Negate(Box<Expr>),
    Call(&'static str, Vec<Expr>),
    /// An element of the array that begins with this register.
    Element(u8, Box<Expr>),
    /// The whole number in whose order this REAL stands.
    Order(Box<Expr>),
}

impl Expr {
    pub fn at(point: Address) -> Expr {
        Expr::Place(Place::At(point))
    }

    pub fn is_true(&self) -> bool {
        *self == Expr::Is(true)
    }

    /// Whether it may stand at more than one place without being long.
    pub fn is_simple(&self) -> bool {
        match self {
            Expr::Is(_) | Expr::Place(_) | Expr::Constant(..) => true,
            Expr::Not(a) => matches!(**a, Expr::Place(_)),
            _ => false,
        }
    }

    pub fn parts(&self) -> Vec<&Expr> {
        match self {
            Expr::Is(_) | Expr::Place(_) | Expr::Constant(..) => Vec::new(),
            Expr::Not(a) | Expr::Negate(a) | Expr::Order(a) | Expr::Element(_, a) => vec![a],
            Expr::Xor(a, b) | Expr::Compare(_, a, b) | Expr::Binary(_, _, a, b) => vec![a, b],
            Expr::And(all) | Expr::Or(all) | Expr::Call(_, all) => all.iter().collect(),
        }
    }

    /// Whether it reads one of these.
    pub fn reads(&self, is: &dyn Fn(Place) -> bool) -> bool {
        match self {
            Expr::Place(place) => is(*place),
            Expr::Element(first, _) if is(Place::Table(*first)) => true,
            other => other.parts().iter().any(|part| part.reads(is)),
        }
    }

    /// How many parts it has.
    pub fn size(&self) -> usize {
        1 + self.parts().iter().map(|part| part.size()).sum::<usize>()
    }
}

pub(super) fn not(of: Expr) -> Expr {
    match of {
        Expr::Is(is) => Expr::Is(!is),
        Expr::Not(inner) => *inner,
        Expr::Compare(sign, a, b) => Expr::Compare(opposite(sign), a, b),
        other => Expr::Not(Box::new(other)),
    }
}

fn opposite(sign: &str) -> &'static str {
    match sign {
        "=" => "<>",
        "<>" => "=",
        "<" => ">=",
        ">" => "<=",
        "<=" => ">",
        _ => "<",
    }
}

pub(super) fn and(a: Expr, b: Expr) -> Expr {
    match (a, b) {
        (Expr::Is(true), other) | (other, Expr::Is(true)) => other,
        (Expr::Is(false), _) | (_, Expr::Is(false)) => Expr::Is(false),
        (Expr::And(mut all), b) => {
            all.push(b);
            Expr::And(all)
        }
        (a, b) => Expr::And(vec![a, b]),
    }
}

pub(super) fn or(a: Expr, b: Expr) -> Expr {
    match (a, b) {
        (Expr::Is(false), other) | (other, Expr::Is(false)) => other,
        (Expr::Is(true), _) | (_, Expr::Is(true)) => Expr::Is(true),
        (Expr::Or(mut all), b) => {
            all.push(b);
            Expr::Or(all)
        }
        (a, b) => Expr::Or(vec![a, b]),
    }
}

pub(super) fn xor(a: Expr, b: Expr) -> Expr {
    match (a, b) {
        (Expr::Is(false), other) | (other, Expr::Is(false)) => other,
        (Expr::Is(true), other) | (other, Expr::Is(true)) => not(other),
        (a, b) => Expr::Xor(Box::new(a), Box::new(b)),
    }
}

pub(super) fn whole(number: i32) -> Expr {
    Expr::Constant(number, Type::Dint)
}

pub(super) fn call(name: &'static str, of: Expr) -> Expr {
    Expr::Call(name, vec![of])
}

pub(super) fn binary(sign: &'static str, a: Expr, b: Expr) -> Expr {
    let tight = match sign {
        "*" | "/" | "MOD" => 7,
        "+" | "-" => 6,
        "AND" => 3,
        "XOR" => 2,
        _ => 1,
    };
    Expr::Binary(sign, tight, Box::new(a), Box::new(b))
}

pub(super) fn compare(sign: &'static str, a: Expr, b: Expr) -> Expr {
    Expr::Compare(sign, Box::new(a), Box::new(b))
}

/// The sign of a comparison.
pub(super) fn sign(opcode: Opcode) -> &'static str {
    match opcode {
        Opcode::Greater => ">",
        Opcode::GreaterOrEqual | Opcode::UnsignedGreaterOrEqual => ">=",
        Opcode::Equal => "=",
        Opcode::NotEqual => "<>",
        Opcode::LessOrEqual => "<=",
        _ => "<",
    }
}

/// Writes an expression with the parentheses that it needs; `name` says what a place is called.
pub(super) fn written(expr: &Expr, name: &dyn Fn(Place) -> String) -> String {
    let mut out = String::new();
    write(expr, 0, name, &mut out);
    out
}

/// How tightly an expression binds.
fn tight(expr: &Expr) -> u8 {
    match expr {
        Expr::Or(_) => 1,
        Expr::Xor(..) => 2,
        Expr::And(_) => 3,
        Expr::Compare("=" | "<>", ..) => 4,
        Expr::Compare(..) => 5,
        Expr::Binary(_, tight, ..) => *tight,
        Expr::Not(_) | Expr::Negate(_) => 8,
        Expr::Constant(number, Type::Dint | Type::Real) if *number < 0 => 8,
        _ => 9,
    }
}

fn write(expr: &Expr, within: u8, name: &dyn Fn(Place) -> String, out: &mut String) {
    let own = tight(expr);
    if own < within {
        out.push('(');
        write(expr, 0, name, out);
        out.push(')');
        return;
    }
    let chain = |all: &[Expr], sign: &str, out: &mut String| {
        for (at, part) in all.iter().enumerate() {
            if at > 0 {
                out.push_str(sign);
            }
            // The first needs no parentheses where it binds as tightly.
            write(part, own + u8::from(at > 0), name, out);
        }
    };
    let two = |a: &Expr, b: &Expr, sign: &str, out: &mut String| {
        write(a, own, name, out);
        let _ = write!(out, " {sign} ");
        write(b, own + 1, name, out);
    };
    match expr {
        Expr::Is(true) => out.push_str("TRUE"),
        Expr::Is(false) => out.push_str("FALSE"),
        Expr::Place(place) => out.push_str(&name(*place)),
        Expr::Constant(number, ty) => out.push_str(&literal(*number, *ty)),
        Expr::Not(a) => {
            out.push_str("NOT ");
            write(a, 9, name, out);
        }
        Expr::Negate(a) => {
            out.push('-');
            write(a, 9, name, out);
        }
        Expr::And(all) => chain(all, " AND ", out),
        Expr::Or(all) => chain(all, " OR ", out),
        Expr::Xor(a, b) => two(a, b, "XOR", out),
        Expr::Compare(sign, a, b) => {
            write(a, 6, name, out);
            let _ = write!(out, " {sign} ");
            write(b, 6, name, out);
        }
        Expr::Binary(sign, _, a, b) => two(a, b, sign, out),
        Expr::Call(function, all) => {
            let _ = write!(out, "{function}(");
            for (at, part) in all.iter().enumerate() {
                if at > 0 {
                    out.push_str(", ");
                }
                write(part, 0, name, out);
            }
            out.push(')');
        }
        Expr::Element(first, at) => {
            let _ = write!(out, "{}[", name(Place::Table(*first)));
            write(at, 0, name, out);
            out.push(']');
        }
        // Whoever compares it takes the REAL, and whoever does not has resolved it.
        Expr::Order(a) => write(a, 9, name, out),
    }
}

/// A constant as it is written.
pub(super) fn literal(bits: i32, ty: Type) -> String {
    match ty {
        Type::Dint => bits.to_string(),
        Type::Udint => bits.cast_unsigned().to_string(),
        Type::Dword => format!("16#{bits:X}"),
        Type::Real => format!("{:?}", f32::from_bits(bits.cast_unsigned())).replace('e', "E"),
        Type::Time => time(bits),
    }
}

/// `T#1m30s`
fn time(ms: i32) -> String {
    let mut rest = ms.max(0);
    let mut out = "T#".to_owned();
    for (unit, takes) in [
        ("d", 86_400_000),
        ("h", 3_600_000),
        ("m", 60_000),
        ("s", 1_000),
        ("ms", 1),
    ] {
        if rest >= takes {
            let _ = write!(out, "{}{unit}", rest / takes);
            rest %= takes;
        }
    }
    if out == "T#" { "T#0s".to_owned() } else { out }
}
