//! What a name stands for, and which one was meant.
//!
//! Owns the tables of names and what is told of a name but once.

use super::builder::{Builder, Draft};
use super::named::Named;
use crate::{Kind, TypeId, Value};
use unoclp_text::diagnostics::{Code, Span, Word};
use unoclp_text::near::nearest;

/// For more names than this, no near one is looked for.
const MOST_NEAR: u32 = 32;

/// Nor among more names than these.
const MOST_NAMES: usize = 4_000;

/// The same for a shorter time.
fn shorter<'n>(name: &'static str) -> &'n str {
    name
}

impl<'t, 'f> Builder<'t, 'f> {
    /// A name whose declaration is wrong: what is done with it is not told.
    pub fn hide(&mut self, name: &str) {
        let key = (self.current, self.key(name));
        self.hidden.insert(key);
        if let Some(draft) = self.here() {
            draft.incomplete = true;
        }
    }

    /// Whether the declaration of this name is wrong, or what is wrong with the name has been told.
    pub fn is_hidden(&self, name: &str) -> bool {
        if self.hidden.is_empty() {
            return false;
        }
        let key = self.key(name);
        let here = self.current.and_then(|unit| self.drafts.get(unit));
        if here.is_some_and(|draft| draft.names.contains_key(&key)) {
            return false;
        }
        let globally = !self.globals.contains_key(&key);
        self.hidden.contains(&(self.current, key.clone()))
            || globally && self.hidden.contains(&(None, key))
    }

    /// What is wrong with this name has been told: not again in this unit.
    pub(super) fn told_name(&mut self, name: &str) {
        let key = (self.current, self.key(name));
        self.hidden.insert(key);
    }

    /// Whether an instance of this type takes or gives something of this name.
    pub fn has_parameter(&self, ty: TypeId, name: &str) -> bool {
        let key = self.key(name);
        match self.tree.types.kind(ty) {
            Kind::Standard(block) => block.part(&key).is_some(),
            Kind::Block(unit) => self.draft(*unit).is_some_and(|draft| {
                let mut params = draft.params.iter();
                params.any(|param| self.key(&param.name) == key)
            }),
            _ => false,
        }
    }

    /// Gives a type its name.
    pub fn name_type(&mut self, name: &str, ty: TypeId, at: Span) {
        let key = self.key(name);
        if self.globals.insert(key, Named::Type(ty)).is_some() {
            self.tell(Code::StNameTwice, at, [name.into()]);
        }
    }

    /// Makes the values of an enumeration known.
    pub fn name_values(&mut self, ty: TypeId) {
        let Kind::Enum(values) = self.tree.types.kind(ty).clone() else {
            return;
        };
        for (name, number) in values.values() {
            let named = Named::Constant(Value::Int(number.into()), ty);
            let key = self.key(name);
            let before = self.globals.get(&key);
            let named = match before {
                None => named,
                Some(Named::Constant(..) | Named::Ambiguous(_)) => Named::Ambiguous(ty),
                Some(_) => continue,
            };
            self.globals.insert(key, named);
        }
    }

    /// What a name stands for here.
    pub fn find(&self, name: &str) -> Option<&Named> {
        let mut room = [0; 32];
        let key = &*self.folded(name, &mut room);
        let here = self.current.and_then(|unit| self.drafts.get(unit));
        let own = here.and_then(|draft| draft.names.get(key));
        own.or_else(|| self.globals.get(key))
    }

    /// Whether something is declared by this name where the builder is.
    pub fn is_taken(&self, name: &str) -> bool {
        let key = self.key(name);
        match self.current.and_then(|unit| self.drafts.get(unit)) {
            Some(draft) => draft.names.contains_key(&key),
            None => self.globals.contains_key(&key),
        }
    }

    /// The type of this name, which a variable may have too.
    pub fn find_type(&self, name: &str) -> Option<TypeId> {
        match self.globals.get(&*self.folded(name, &mut [0; 32])) {
            Some(Named::Type(ty)) => Some(*ty),
            _ => None,
        }
    }

    /// The name that may have been meant, in words.
    pub fn near(&mut self, name: &str, otherwise: Word) -> Word {
        self.asked += 1;
        if self.asked > MOST_NEAR {
            return otherwise;
        }
        let here = self.current.and_then(|unit| self.drafts.get(unit));
        let own = here.into_iter().flat_map(|draft| draft.unit_names());
        let globals = self.globals.keys().map(String::as_str);
        // For no longer than the names of the text live.
        let known = super::functions::names().map(shorter);
        let mut names: Vec<&str> = own.chain(globals).chain(known).collect();
        if names.len() > MOST_NAMES {
            return otherwise;
        }
        // Of two that are as near, the same is told each time.
        names.sort_unstable();
        match nearest(name, names.into_iter()) {
            Some(near) => Word::Near(self.spelt(near)),
            None => otherwise,
        }
    }

    /// A name of the tables as it was declared.
    fn spelt(&self, key: &str) -> String {
        match self.find(key) {
            Some(Named::Variable(variable)) => variable.name.clone(),
            Some(Named::Type(ty)) => self.tree.types.name(*ty),
            Some(Named::Unit(unit)) => match self.draft(*unit) {
                Some(draft) => draft.unit.name.clone(),
                None => key.to_owned(),
            },
            _ => key.to_owned(),
        }
    }
}

impl Draft {
    fn unit_names(&self) -> impl Iterator<Item = &str> {
        self.names.keys().map(String::as_str)
    }
}
