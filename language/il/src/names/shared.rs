//! Variables that stand elsewhere: those of the caller, and those of the whole file.

use super::meaning::{Names, Place};
use crate::ast::{Section, UnitKind, Var};
use unoclp_text::diagnostics::{Code, Found};

impl Names<'_> {
    /// Whether a declaration gives a variable no place of its own.
    pub(super) fn is_elsewhere(
        &mut self,
        var: &Var,
        kind: UnitKind,
        instance: usize,
        found: &mut Found,
    ) -> bool {
        match var.section {
            Section::InOut => self.in_out(var, kind, instance, found),
            Section::External => return self.external(var, found),
            // A block with two instances has its globals once.
            Section::Global => {
                return kind != UnitKind::Program && self.global.contains_key(&var.name.text);
            }
            _ => return false,
        }
        true
    }

    /// Each call says what it is.
    fn in_out(&mut self, var: &Var, kind: UnitKind, instance: usize, found: &mut Found) {
        let span = var.name.span;
        if kind == UnitKind::Program {
            let why = (
                "a program cannot be called; declare it with VAR",
                "um programa não pode ser chamado; declare com VAR",
            );
            found.tell(Code::Structure, span, ["VAR_IN_OUT".into(), why.into()]);
        }
        self.lend_width(instance, var, None);
        let names = &mut self.instances[instance].names;
        let place = match var.typed {
            Some(_) => Place::Typed,
            None => Place::Unknown,
        };
        let twice = names.insert(var.name.text.clone(), place);
        if twice.is_some() {
            let text = self.written(span);
            found.tell(Code::NameTwice, span, [text.into()]);
        }
    }

    /// Whether VAR_GLOBAL declares it. Where nothing does, it is told, and declared here for all that mention it.
    fn external(&mut self, var: &Var, found: &mut Found) -> bool {
        let new = self.globals.insert(var.name.text.clone());
        if new {
            let name = self.written(var.name.span);
            found.tell(Code::NoGlobal, var.name.span, [name.into()]);
        }
        !new
    }
}
