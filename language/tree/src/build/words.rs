//! Words that messages put together, in both languages.

use super::builder::Builder;
use super::named::{Lock, Named};
use crate::{Kind, TypeId, UnitKind};
use unoclp_text::diagnostics::Word;

/// A word for each language.
pub fn both(en: impl Into<String>, pt: impl Into<String>) -> Word {
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
                    ("a function block type", "um tipo de bloco de funções").into()
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

    /// Why nothing can be stored in a variable of this kind, and what to do.
    pub(super) fn why_not_written(lock: Lock) -> (Word, Word) {
        let (what, help) = match lock {
            Lock::Constant => (
                ("a constant", "uma constante"),
                (
                    "declare it with VAR, without CONSTANT",
                    "declare-a com VAR, sem CONSTANT",
                ),
            ),
            Lock::Output => (
                ("an output of its block", "uma saída do seu bloco"),
                (
                    "only the block changes it; assign a value to a block input",
                    "só o bloco a muda; atribua um valor a uma entrada dele",
                ),
            ),
            Lock::Chart => (
                (
                    "part of a step or action of the chart",
                    "parte de uma etapa ou ação do SFC",
                ),
                (
                    "only transitions activate steps; write a TRANSITION to this step",
                    "só as transições ativam etapas; escreva uma TRANSITION para esta etapa",
                ),
            ),
            Lock::Sensor => (
                (
                    "a point that a program can only read",
                    "um ponto que o programa só pode ler",
                ),
                (
                    "use an output (%QX1) or a variable",
                    "use uma saída (%QX1) ou uma variável",
                ),
            ),
        };
        (what.into(), help.into())
    }
}
