//! How wide the numbers are that a text declares: what is declared narrower than 32 bits keeps the bits of its type.
//!
//! Whatever no declaration names is a DINT.

use super::meaning::{Names, Place};
use crate::ast::{Operand, Var};
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_tree::{Base, Value, narrow};

/// The type of this name, where it is a number of less than 32 bits.
pub(crate) fn narrow_type(ty: &str) -> Option<Base> {
    Base::named(ty).filter(|base| (base.is_int() || base.is_bits()) && base.bits() < 32)
}

/// What a variable of this type keeps of a number.
pub(crate) fn kept(base: Option<Base>, number: i32) -> i32 {
    match base.map(|base| narrow(base, Value::Int(number.into()))) {
        Some(Value::Int(number)) => number as i32,
        _ => number,
    }
}

impl Names<'_> {
    /// Notes the type of a name that this instance has, or the whole file.
    pub(crate) fn note_width(&mut self, instance: Option<usize>, name: &str, ty: &str) {
        let Some(base) = narrow_type(ty) else { return };
        self.widths.of.insert((instance, name.to_owned()), base);
    }

    /// For a call, a name is the caller's variable, whose type it has where that is narrower.
    pub(crate) fn lend_width(&mut self, instance: usize, var: &Var, of: Option<Base>) {
        let own = narrow_type(&var.ty.text);
        let base = match (own, of) {
            (Some(own), Some(of)) if own.bits() < of.bits() => Some(own),
            (own, of) => of.or(own),
        };
        let key = (Some(instance), var.name.text.clone());
        match base {
            Some(base) => self.widths.of.insert(key, base),
            None => self.widths.of.remove(&key),
        };
    }

    /// The type of a name of an instance.
    pub(crate) fn width_of(&self, instance: usize, name: &str) -> Option<Base> {
        let key = (Some(instance), name.to_owned());
        self.widths.of.get(&key).copied()
    }

    /// The type of what an operand names, as seen from an instance.
    pub(crate) fn width(&self, operand: &Operand, instance: Option<usize>) -> Option<Base> {
        let name = operand.name()?;
        let has = |name: &str| {
            let local = instance.and_then(|at| self.instances.get(at)?.names.get(name));
            local
                .map(|place| (instance, *place))
                .or_else(|| self.global.get(name).map(|place| (None, *place)))
        };
        if let Some((instance, _)) = has(name) {
            let key = (instance, name.to_owned());
            return self.widths.of.get(&key).copied();
        }
        let (block, member) = name.split_once('.')?;
        match has(block)? {
            (_, Place::Instance(instance)) => self.width_of(instance, member),
            _ => None,
        }
    }

    /// What a variable keeps of a number that stands in the text; told where that is another.
    pub(crate) fn cut(&self, to: (Base, &str), number: i32, span: Span, found: &mut Found) -> i32 {
        let (base, name) = to;
        let kept = kept(Some(base), number);
        if kept != number {
            let words = [
                number.to_string().into(),
                name.to_owned().into(),
                base.name().into(),
                kept.to_string().into(),
            ];
            found.tell(Code::Narrowed, span, words);
        }
        kept
    }
}
