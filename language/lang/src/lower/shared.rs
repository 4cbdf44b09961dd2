//! VAR_IN_OUT: a variable of the caller's, which the body works on itself.

use super::{BOOL, Lower, NUMBER};
use crate::ast::{Param, Section, Var};
use crate::diagnostics::{Code, Span};
use crate::names::Place;
use crate::tree::Num;
use std::collections::HashSet;

impl Lower<'_, '_> {
    /// For this call the name is that variable.
    pub(super) fn bind(&mut self, instance: usize, var: &Var, param: &Param) {
        let span = param.value.span;
        let mut place = self.place(&param.value);
        let text = self.spelled(&param.value);
        let is_bool = var.ty.text == "BOOL";
        let constant = matches!(place, Place::Always(_) | Place::Number(Num::Const(_)));
        let wrong = match place {
            _ if constant || param.negated => {
                self.found.tell(Code::NotWritable, span, [text.into()]);
                true
            }
            Place::Bit(_) if !is_bool => {
                self.wrong_type(text, span, BOOL, NUMBER);
                true
            }
            Place::Number(_) if is_bool => {
                self.wrong_type(text, span, NUMBER, BOOL);
                true
            }
            _ => false,
        };
        if wrong {
            place = Place::Unknown;
        }
        let width = self.names.width(&param.value, self.instance());
        self.names.lend_width(instance, var, width);
        let names = &mut self.names.instances[instance].names;
        names.insert(var.name.text.clone(), place);
    }

    /// A call must say what each of them is.
    pub(super) fn unbound(
        &mut self,
        unit: usize,
        instance: usize,
        given: &HashSet<String>,
        span: Span,
    ) {
        let units = self.units;
        let Some(unit) = units.get(unit) else { return };
        let in_out = unit.vars.iter().filter(|var| var.section == Section::InOut);
        for var in in_out.filter(|var| !given.contains(&var.name.text)) {
            let block = unit.name.as_ref().map_or(unit.span, |name| name.span);
            let (block, name) = (self.names.written(block), self.names.written(var.name.span));
            let needs = (
                format!("a variable for its VAR_IN_OUT `{name}`"),
                format!("uma variável para o seu VAR_IN_OUT `{name}`"),
            );
            let words = [block.into(), needs.into()];
            self.found.tell(Code::ParameterMissing, span, words);
            let names = &mut self.names.instances[instance].names;
            names.insert(var.name.text.clone(), Place::Unknown);
        }
    }
}
