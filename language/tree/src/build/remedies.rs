//! What is wrong with a type, and what to write instead.

use super::builder::Builder;
use super::coerce::conversion;
use super::words::both;
use crate::Generic;
use crate::{Base, Expr, ExprKind, Kind, TypeId};
use unoclp_text::diagnostics::{Code, Span, Word};

impl Builder<'_, '_> {
    pub(super) fn told_range(&mut self, at: Span, to: Base) {
        let written = self.written(at);
        let (low, high) = match (to, to.range()) {
            (_, Some((low, high))) => (low.to_string(), high.to_string()),
            (Base::Real, _) => ("-3.4E38".to_owned(), "3.4E38".to_owned()),
            _ => ("-1.8E308".to_owned(), "1.8E308".to_owned()),
        };
        let words = [written.into(), to.name().into(), low.into(), high.into()];
        self.tell(Code::StOutOfRange, at, words);
    }

    /// Tells that a value is of another type than is needed, and what converts it.
    pub(super) fn told_mismatch(&mut self, expr: &Expr, needed: TypeId) {
        if matches!(expr.kind, ExprKind::Wrong) {
            return;
        }
        let written = self.written(expr.at);
        let is = self.type_of(expr);
        let help = self.remedy(expr, needed, &written);
        let needed = self.tree.types.name(needed);
        let words = [written.into(), is, needed.into(), help];
        self.tell(Code::StMismatch, expr.at, words);
    }

    /// The type of an expression, in words.
    pub(super) fn type_of(&self, expr: &Expr) -> Word {
        match expr.base {
            Base::AnyInt => ("a whole number", "um número inteiro").into(),
            Base::AnyReal => ("a number with a fraction", "um número com casas decimais").into(),
            _ => self.tree.types.name(expr.ty).into(),
        }
    }

    /// A conversion as it is written; of what an instruction has left in the accumulator, it stands alone.
    fn converting(&self, name: String, written: &str) -> String {
        match self.is_list && written.contains(' ') {
            true => name,
            false => format!("{name}({written})"),
        }
    }

    fn remedy(&self, expr: &Expr, needed: TypeId, written: &str) -> Word {
        let name = self.tree.types.name(needed);
        let Some(to) = self.tree.types.base(needed) else {
            return both(
                format!("use a variable of type {name}"),
                format!("use uma variável do tipo {name}"),
            );
        };
        let from = expr.base;
        let write = |text: String| both(format!("write {text}"), format!("escreva {text}"));
        if let Kind::Enum(values) = self.tree.types.kind(needed) {
            let first = values.first().0;
            let names = values.some();
            return both(
                format!("the values of {name} are {names}: write {first}"),
                format!("os valores de {name} são {names}: escreva {first}"),
            );
        }
        if self.is_enum(expr.ty) {
            let of = self.tree.types.name(expr.ty);
            return write(self.converting(format!("{of}_TO_{to}"), written));
        }
        match (from, to) {
            (Base::AnyInt, Base::Bool) => both(
                format!("write TRUE or FALSE, or compare it with a value: x = {written}"),
                format!("escreva TRUE ou FALSE, ou compare com um valor: x = {written}"),
            ),
            (_, Base::Bool) if from.is_num() || from.is_bits() => write(format!("{written} <> 0")),
            (Base::Wstr, Base::Str) if written.starts_with('"') => {
                write(format!("'{}'", written.trim_matches('"')))
            }
            (Base::AnyInt, Base::Time) => write(format!("T#{written}ms")),
            (Base::AnyReal, _) if to.is_int() => match &expr.kind {
                ExprKind::Constant(value) => {
                    let whole = value.real().round();
                    both(
                        format!("write {whole}, or use REAL for the variable"),
                        format!("escreva {whole} ou use REAL para a variável"),
                    )
                }
                _ => write(self.converting(format!("REAL_TO_{to}"), written)),
            },
            (Base::AnyInt | Base::AnyReal, _) if to.is_text() => write(format!("'{written}'")),
            _ if conversion(from, to).is_some() => {
                let from = if from.is_any() { Base::Dint } else { from };
                write(self.converting(format!("{from}_TO_{to}"), written))
            }
            _ => both(
                format!("use a value of type {name}"),
                format!("use um valor do tipo {name}"),
            ),
        }
    }

    /// Tells that an operand is of the wrong type.
    pub(super) fn told_operand(&mut self, name: &str, generic: Generic, operand: &Expr) {
        if matches!(operand.kind, ExprKind::Wrong) {
            return;
        }
        let written = self.written(operand.at);
        let is = self.type_of(operand);
        let base = operand.base;
        let write = |text: String| both(format!("write {text}"), format!("escreva {text}"));
        let help: Word = match generic {
            _ if self.is_enum(operand.ty) => (
                "a value of an enumeration can only be compared and stored",
                "um valor de enumeração só pode ser comparado e guardado",
            )
                .into(),
            Generic::Bit if name == "NOT" && !base.is_text() => both(
                format!(
                    "NOT comes before a comparison: write NOT ({written} = …), or {written} <> …"
                ),
                format!(
                    "NOT vem antes de uma comparação: escreva NOT ({written} = …) ou {written} <> …"
                ),
            ),
            Generic::Bit if base.is_int() => {
                let word = match base.bits() {
                    8 => "BYTE",
                    16 => "WORD",
                    64 => "LWORD",
                    _ => "DWORD",
                };
                both(
                    format!(
                        "compare it ({written} <> 0), or write {base}_TO_{word}({written}) to use its bits"
                    ),
                    format!(
                        "compare-o ({written} <> 0) ou escreva {base}_TO_{word}({written}) para usar os bits"
                    ),
                )
            }
            Generic::Bit => write(format!("{written} <> 0")),
            Generic::Int if base.is_real() => {
                write(self.converting("REAL_TO_DINT".to_owned(), &written))
            }
            Generic::Real if base.is_int() => {
                write(self.converting(format!("{base}_TO_REAL"), &written))
            }
            _ if base == Base::Bool => both(
                format!(
                    "to use a BOOL as a number, write BOOL_TO_INT({written}); AND and OR combine two BOOL values"
                ),
                format!(
                    "para usar um BOOL como número, escreva BOOL_TO_INT({written}); AND e OR combinam dois valores BOOL"
                ),
            ),
            _ if base.is_bits() => {
                let int = match base {
                    Base::Byte => "USINT",
                    Base::Word => "UINT",
                    Base::Dword => "UDINT",
                    _ => "ULINT",
                };
                write(self.converting(format!("{base}_TO_{int}"), &written))
            }
            _ if base.is_text() => (
                "use CONCAT to join strings",
                "use CONCAT para juntar strings",
            )
                .into(),
            _ => both(
                format!("use a variable of another type for {written}"),
                format!("use uma variável de outro tipo para {written}"),
            ),
        };
        let words = [name.into(), generic.name().into(), written.into(), is, help];
        self.tell(Code::StOperand, operand.at, words);
    }

    pub(super) fn told_no_common(&mut self, name: &str, a: &Expr, b: &Expr, at: Span) {
        let (x, y) = (self.type_of(a), self.type_of(b));
        let (first, second) = (self.written(a.at), self.written(b.at));
        let settle = |base: Base| match base {
            Base::AnyInt => Base::Int,
            Base::AnyReal => Base::Real,
            base => base,
        };
        let (p, q) = (settle(a.base), settle(b.base));
        let help = match (p, q) {
            (Base::Bool, _) if !b.base.is_any() => self.converting(format!("{q}_TO_BOOL"), &second),
            (_, Base::Bool) => self.converting(format!("BOOL_TO_{p}"), &second),
            (Base::Bool, _) => self.converting(format!("BOOL_TO_{q}"), &first),
            _ if q.is_real() => self.converting(format!("{p}_TO_{q}"), &first),
            (Base::Time, _) if b.base.is_any() => format!("T#{second}ms"),
            _ => self.converting(format!("{q}_TO_{p}"), &second),
        };
        let words = [name.into(), x, y, help.into()];
        self.tell(Code::StNoCommon, at, words);
    }
}
