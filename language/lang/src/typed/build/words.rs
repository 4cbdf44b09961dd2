//! Words that messages put together, in both languages.

use super::builder::Builder;
use super::named::Named;
use crate::diagnostics::Word;
use crate::typed::{Kind, TypeId, UnitKind};

pub(crate) fn both(en: impl Into<String>, pt: impl Into<String>) -> Word {
    Word::Both(en.into(), pt.into())
}

/// What a unit is, in words.
fn kind_of(kind: UnitKind) -> (&'static str, &'static str) {
    match kind {
        UnitKind::Program => ("a program", "um programa"),
        UnitKind::Block => ("a function block", "um bloco de funções"),
        UnitKind::Function => ("a function", "uma função"),
    }
}

impl Builder<'_, '_> {
    /// What a name stands for, in words.
    pub(super) fn what(&self, named: &Named) -> Word {
        match named {
            Named::Variable(variable) => self.what_type(variable.ty),
            Named::Constant(_, ty) | Named::Ambiguous(ty) => {
                let name = self.tree.types.name(*ty);
                both(format!("a value of {name}"), format!("um valor de {name}"))
            }
            Named::Type(ty) => match self.tree.types.kind(*ty) {
                Kind::Block(_) | Kind::Standard(_) => {
                    ("a type of function blocks", "um tipo de bloco de funções").into()
                }
                _ => ("a type", "um tipo").into(),
            },
            Named::Unit(unit) => match self.draft(*unit) {
                Some(draft) => kind_of(draft.unit.kind).into(),
                None => ("a unit", "uma unidade").into(),
            },
        }
    }

    /// A variable of this type, in words.
    pub(super) fn what_type(&self, ty: TypeId) -> Word {
        let name = self.tree.types.name(ty);
        match self.tree.types.kind(ty) {
            Kind::Array { .. } => both(format!("an array, {name}"), format!("uma matriz, {name}")),
            Kind::Struct(_) => both(
                format!("a structure, {name}"),
                format!("uma estrutura, {name}"),
            ),
            Kind::Standard(_) | Kind::Block(_) => both(
                format!("an instance of {name}"),
                format!("uma instância de {name}"),
            ),
            _ => name.into(),
        }
    }

    /// Why nothing can be stored in a constant, and what to do.
    pub(super) fn constant_locked() -> (Word, Word) {
        (
            ("a constant", "uma constante").into(),
            (
                "declare it with VAR, without CONSTANT",
                "declare-a com VAR, sem CONSTANT",
            )
                .into(),
        )
    }
}
