//! Variables: what a declaration says, and where the variable stands.

use super::builder::{Builder, MOST_CELLS};
use super::named::{Named, Param, Section, Traits, Variable};
use super::stages::{Closed, Declaring};
use super::words::both;
use crate::{Base, Declared, Expr, ExprKind, Initial, Kind, Root, Store, TypeId, UnitKind, Value};
use std::sync::Arc;
use unoclp_text::diagnostics::{Code, Span};

impl Builder<'_, '_> {
    /// Shows what was declared last by another name.
    pub fn show_as(&mut self, name: &str) {
        if let Some((shown, ..)) = self.shown.last_mut() {
            name.clone_into(shown);
        }
    }

    /// Declares a variable where the builder is: in a unit, or for all. What is wrong with it is told.
    pub fn declare(
        &mut self,
        name: &str,
        at: Span,
        ty: TypeId,
        section: Section,
        traits: Traits,
    ) -> Option<Variable> {
        let key = self.key(name);
        let here = self.current.and_then(|unit| self.drafts.get(unit));
        let taken = match here {
            Some(draft) => draft.names.contains_key(&key),
            None => self.globals.contains_key(&key),
        };
        if taken {
            self.tell(Code::StNameTwice, at, [name.into()]);
            return None;
        }
        if section == Section::External {
            return self.external(name, at, ty, traits.constant);
        }
        if let (Some(UnitKind::Function), true) = (self.kind_here(), self.keeps(ty))
            && section != Section::InOut
        {
            let word = name.into();
            self.tell(Code::StStateless, at, [word]);
            return None;
        }
        let root = self.root_of(section);
        let offset = match (root, traits.point) {
            (Root::Static, Some(point)) => {
                if !point.is_written() && traits.initial.as_deref().is_some_and(is_some_value) {
                    self.tell(Code::StInputFirst, at, [name.into()]);
                }
                self.point_with(point, ty, &traits)
            }
            _ => self.room(name, at, ty, section, root, &traits)?,
        };
        if !traits.unseen {
            self.tree.declared.push(Declared {
                unit: self.current.map(|unit| unit as u32),
                name: name.to_owned(),
                ty,
                at,
            });
        }
        let lent = matches!(root, Root::Lent(_));
        let variable = Variable {
            name: name.to_owned(),
            ty,
            root,
            // What is lent is counted from the place that the caller gives.
            offset: if lent { 0 } else { offset },
            section,
            constant: traits.constant,
            at,
        };
        if root == Root::Static && !traits.unseen {
            let program = self.current.map(|unit| unit as u32);
            self.shown
                .push((name.to_owned(), variable.clone(), program));
        }
        let named = match (traits.constant, self.tree.types.base(ty), &traits.initial) {
            (true, Some(base), initial) => {
                let own = self.tree.types.initials(ty).pop();
                let value = match initial.clone().or(own).as_deref() {
                    Some(Initial::Value(value)) => value.clone(),
                    _ => Value::zero(base),
                };
                if let (Root::Own, Some(draft)) = (root, self.here()) {
                    draft.constants.push((name.to_owned(), ty, offset));
                }
                Named::Constant(value, ty)
            }
            _ => Named::Variable(variable.clone()),
        };
        if let Some(draft) = self.here() {
            if matches!(section, Section::Input | Section::Output | Section::InOut) {
                draft.params.push(Param {
                    name: name.to_owned(),
                    section,
                    ty,
                    offset,
                });
            }
            draft.names.insert(key, named);
        } else {
            self.globals.insert(key, named);
        }
        Some(variable)
    }

    /// Makes the result of the function that the builder is in: its first local cells.
    pub fn result(&mut self, ty: TypeId, at: Span) {
        let Some(name) = self.here().map(|draft| draft.unit.name.clone()) else {
            return;
        };
        let made = self.declare(&name, at, ty, Section::Var, Traits::default());
        if let (Some(_), Some(draft)) = (made, self.here()) {
            draft.result = Some(ty);
        }
    }

    /// Ends the declarations of a unit: instances of a block can be declared from here on, and it can get its body.
    pub fn close(&mut self, unit: Declaring) -> Closed {
        let closed = Closed(unit.0);
        let Some(draft) = self.drafts.get_mut(unit.0 as usize) else {
            return closed;
        };
        draft.closed = true;
        let (ty, cells) = (draft.block, draft.unit.own.len() as u32);
        let parts = draft.names.values().filter_map(|named| match named {
            Named::Variable(variable) if variable.root == Root::Own => Some(variable.ty),
            _ => None,
        });
        self.tree.types.close_block(ty, cells, parts);
        closed
    }

    /// Whether a variable of this type keeps something from one call to the next.
    fn keeps(&self, ty: TypeId) -> bool {
        match self.tree.types.kind(ty) {
            Kind::Standard(_) | Kind::Block(_) => true,
            Kind::Array { of, .. } => {
                let of = self.tree.types.kind(*of);
                matches!(of, Kind::Standard(_) | Kind::Block(_))
            }
            _ => false,
        }
    }

    fn root_of(&self, section: Section) -> Root {
        match (section, self.kind_here()) {
            (Section::InOut, Some(UnitKind::Block | UnitKind::Function)) => {
                let draft = self.current.and_then(|unit| self.drafts.get(unit));
                Root::Lent(draft.map_or(0, |draft| draft.unit.references))
            }
            (Section::Temp, Some(_)) | (_, Some(UnitKind::Function)) => Root::Local,
            (_, Some(UnitKind::Block)) => Root::Own,
            _ => Root::Static,
        }
    }

    /// Cells for a variable: the first one's offset.
    fn room(
        &mut self,
        name: &str,
        at: Span,
        ty: TypeId,
        section: Section,
        root: Root,
        traits: &Traits,
    ) -> Option<u32> {
        if matches!(root, Root::Lent(_)) {
            let draft = self.here()?;
            draft.unit.references += 1;
            return Some(draft.unit.references - 1);
        }
        let cells = self.tree.types.get(ty).cells;
        self.cells += u64::from(cells);
        if self.cells > u64::from(MOST_CELLS) {
            let count = cells.to_string().into();
            let most = MOST_CELLS.to_string().into();
            self.tell(Code::StTooLarge, at, [name.into(), count, most]);
            self.cells -= u64::from(cells);
            return None;
        }
        let mut made = self.initial_cells(ty, traits);
        let scratch = traits.unseen && section == Section::Temp;
        made.iter_mut().for_each(|cell| cell.scratch = scratch);
        let cells = match root {
            Root::Own => &mut self.here()?.unit.own,
            Root::Local => &mut self.here()?.unit.locals,
            _ => &mut self.tree.cells,
        };
        let offset = cells.len() as u32;
        cells.extend(made);
        Some(offset)
    }

    /// VAR_EXTERNAL: the global of this name, whose type it repeats.
    fn external(&mut self, name: &str, at: Span, ty: TypeId, constant: bool) -> Option<Variable> {
        let key = self.key(name);
        let named = self.globals.get(&key).cloned();
        let (is, held) = match &named {
            Some(Named::Variable(variable)) => (variable.ty, Some(variable.clone())),
            Some(Named::Constant(_, is)) => (*is, None),
            _ if !constant && self.globals_are_elsewhere() => {
                return self.own_external(name, at, ty);
            }
            _ => {
                let declare = self.as_global(name, ty);
                let help = both(
                    format!("declare it outside the program: {declare}"),
                    format!("declare-a fora do programa: {declare}"),
                );
                let help = self.near(name, help);
                self.tell(Code::StUndeclared, at, [name.into(), help]);
                return None;
            }
        };
        if !self.tree.types.same(is, ty) {
            let (is, said) = (self.tree.types.name(is), self.tree.types.name(ty));
            let help = both(
                format!("write the type of its VAR_GLOBAL: {is}"),
                format!("escreva o tipo do seu VAR_GLOBAL: {is}"),
            );
            let words = [name.into(), is.into(), said.into(), help];
            self.tell(Code::StMismatch, at, words);
        }
        if let (Some(draft), Some(named)) = (self.here(), named) {
            draft.names.insert(key, named);
        }
        held
    }

    /// Whether the text declares no globals, so that another file must.
    fn globals_are_elsewhere(&self) -> bool {
        let is_enum = |ty: TypeId| matches!(self.tree.types.kind(ty), Kind::Enum(_));
        let here = self.globals.values().filter(|is| match is {
            Named::Variable(_) => true,
            // The values of an enumeration come with its type.
            Named::Constant(_, ty) => !is_enum(*ty),
            _ => false,
        });
        here.count() == self.externals
    }

    /// A global of another file: it is declared here, for all units that name it.
    fn own_external(&mut self, name: &str, at: Span, ty: TypeId) -> Option<Variable> {
        let declare = self.as_global(name, ty);
        self.tell(Code::StExternalOwn, at, [name.into(), declare.into()]);
        let unit = self.current.take();
        let made = self.declare(name, at, ty, Section::Global, Traits::default());
        self.current = unit;
        self.externals += 1;
        let (key, named) = (self.key(name), made.clone().map(Named::Variable));
        if let (Some(draft), Some(named)) = (self.here(), named) {
            draft.names.insert(key, named);
        }
        made
    }

    fn as_global(&self, name: &str, ty: TypeId) -> String {
        format!("VAR_GLOBAL {name} : {}; END_VAR", self.tree.types.name(ty))
    }

    /// The first value of a variable without parts; none where it is not known, which is told.
    pub fn initial(&mut self, expr: Expr, ty: TypeId) -> Option<Arc<Initial>> {
        let expr = self.coerce(expr, ty);
        match expr.kind {
            ExprKind::Constant(value) => {
                let value = match self.store_of(ty) {
                    Store::Text(most) => value.cut(most),
                    _ => value,
                };
                Some(Arc::new(Initial::Value(value)))
            }
            ExprKind::Wrong => None,
            _ => {
                let written = self.written(expr.at);
                self.tell(Code::StNotConstant, expr.at, [written.into()]);
                None
            }
        }
    }
}

/// Whether a first value is another than the one that a variable has anyway.
fn is_some_value(initial: &Initial) -> bool {
    !matches!(initial, Initial::Value(value) if *value == Value::zero(Base::Dint) || *value == Value::truth(false))
}
