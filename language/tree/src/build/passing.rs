//! What a call gives to which parameter, and what comes back.
//!
//! Owns values, places that are lent, and outputs; how they are written, `arguments` knows.

use super::arguments::{Argument, Given, Params};
use super::builder::Builder;
use super::coerce::conversion;
use super::named::{Param, Section};
use super::places::Target;
use crate::{Base, Call, Convert, ExprKind, Input, Output, Place, Stmt};
use std::collections::{HashMap, HashSet};
use unoclp_text::diagnostics::{Code, Span};

impl Builder<'_, '_> {
    /// Gives each argument to its parameter. For an instance, the stores of its outputs come back.
    pub(super) fn pass(
        &mut self,
        name: &str,
        mut params: Params,
        arguments: Vec<Argument>,
        instance: Option<&Target>,
        call: &mut Call,
        at: Span,
    ) -> Option<Vec<Stmt>> {
        let with_names = arguments.iter().filter(|a| a.name.is_some()).count();
        if with_names != 0 && with_names != arguments.len() {
            let bare = arguments.iter().find(|a| a.name.is_none());
            let names: Vec<&str> = params.iter().map(|(p, _)| p.name.as_str()).collect();
            let list = names.join(" := …, ") + " := …";
            self.tell(Code::StMixed, bare.map_or(at, |a| a.at), [list.into()]);
            return None;
        }
        let takes = |p: &Param| p.section != Section::Output;
        let mut gives = false;
        if with_names == 0 && !arguments.is_empty() {
            let order: Vec<usize> = (0..params.len()).filter(|&i| takes(&params[i].0)).collect();
            // More than it takes: what it gives too, all in the order of their declarations.
            gives = arguments.len() > order.len();
            let wrong = match instance {
                // Fewer are let by: a block keeps its inputs.
                Some(_) => arguments.len() > params.len(),
                None => gives && arguments.len() != params.len() || arguments.len() < order.len(),
            };
            if wrong && self.lenient {
                return None;
            }
            if wrong {
                let names: Vec<&str> = order.iter().map(|&i| params[i].0.name.as_str()).collect();
                self.told_count(name, &names, false, arguments.len(), at);
                return None;
            }
        }
        let mut lent: Vec<Option<Place>> = Vec::new();
        lent.resize_with(
            params
                .iter()
                .filter(|(p, _)| p.section == Section::InOut)
                .count(),
            || None,
        );
        let mut after = Vec::new();
        let mut right = true;
        let mut seen = HashSet::new();
        let mut next = 0;
        let named = params.iter().enumerate().filter(|_| with_names > 0);
        // Of two with one name the first is meant.
        let slots: HashMap<String, usize> = named
            .rev()
            .map(|(slot, (param, _))| (self.key(&param.name), slot))
            .collect();
        let mut room = [0; 32];
        for argument in arguments {
            let found = match &argument.name {
                Some((written, _)) => {
                    let named = slots.get(&*self.folded(written, &mut room));
                    named.copied()
                }
                None => {
                    while params.get(next).is_some_and(|(p, _)| !gives && !takes(p)) {
                        next += 1;
                    }
                    next += 1;
                    Some(next - 1)
                }
            };
            let Some(slot) = found.filter(|slot| *slot < params.len()) else {
                if let Some((written, span)) = argument.name
                    && !self.lenient
                {
                    self.told_no_parameter(name, &written, &params, span);
                }
                right = false;
                continue;
            };
            let param = params[slot].0.clone();
            if !seen.insert(slot) {
                self.tell(Code::StParameterTwice, argument.at, [param.name.into()]);
                right = false;
                continue;
            }
            params[slot].1 = true;
            let is_named = argument.name.is_some();
            if is_named && argument.out != (param.section == Section::Output) {
                let (what, sign) = match param.section {
                    Section::Output => (("an output", "uma saída"), "=>"),
                    _ => (("an input", "uma entrada"), ":="),
                };
                let span = argument.name.as_ref().map_or(argument.at, |name| name.1);
                let words = [param.name.into(), what.into(), name.into(), sign.into()];
                self.tell(Code::StDirection, span, words);
                right = false;
                continue;
            }
            right &= match param.section {
                Section::InOut => self.lend(name, &param, argument, &mut lent),
                Section::Output => self.take(&param, argument, instance, call, &mut after),
                _ => self.give(&param, argument, call),
            };
        }
        for (param, given) in &params {
            let needed = param.section == Section::InOut;
            if needed && !given && right && !self.lenient {
                let words = [name.into(), param.name.as_str().into()];
                self.tell(Code::StMissing, at, words);
                right = false;
            }
        }
        call.lent = lent.into_iter().flatten().collect();
        right.then_some(after)
    }

    /// A value into an input.
    fn give(&mut self, param: &Param, argument: Argument, call: &mut Call) -> bool {
        if !self.tree.types.is_scalar(param.ty) {
            let Given::Place(target) = argument.given else {
                let value = self.value(argument.given, argument.at);
                self.told_mismatch(&value, param.ty);
                return false;
            };
            if !self.tree.types.same(target.ty, param.ty) {
                self.told_other_type(&target, param.ty);
                return false;
            }
            let cells = self.tree.types.get(param.ty).cells;
            call.inputs
                .push(Input::Cells(param.offset, target.place, cells));
            return true;
        }
        let value = self.value(argument.given, argument.at);
        let value = self.coerce(value, param.ty);
        if matches!(value.kind, ExprKind::Wrong) {
            return false;
        }
        let store = self.store_of(param.ty);
        call.inputs.push(Input::Value(param.offset, value, store));
        true
    }

    /// A place for VAR_IN_OUT.
    fn lend(
        &mut self,
        name: &str,
        param: &Param,
        argument: Argument,
        lent: &mut [Option<Place>],
    ) -> bool {
        let Given::Place(target) = argument.given else {
            if let Given::Value(_) = argument.given {
                let written = self.written(argument.at).into();
                let words = [name.into(), param.name.as_str().into(), written];
                self.tell(Code::StNeedsVariable, argument.at, words);
            }
            return false;
        };
        if !self.tree.types.same(target.ty, param.ty) {
            self.told_other_type(&target, param.ty);
            return false;
        }
        let Some(target) = self.writable(target) else {
            return false;
        };
        match lent.get_mut(param.offset as usize) {
            Some(slot) => *slot = Some(target.place),
            None => return false,
        }
        true
    }

    pub(super) fn goes_into(&self, from: Base, to: Base) -> bool {
        let is_small = |base: Base| base.is_int() && base.bits() <= 32;
        from.widens_to(to) || self.is_wide && is_small(from) && is_small(to)
    }

    /// What comes out, into a variable.
    fn take(
        &mut self,
        param: &Param,
        argument: Argument,
        instance: Option<&Target>,
        call: &mut Call,
        after: &mut Vec<Stmt>,
    ) -> bool {
        let Given::Place(to) = argument.given else {
            if let Given::Value(_) = argument.given {
                let written = self.written(argument.at).into();
                let words = [
                    param.name.as_str().into(),
                    param.name.as_str().into(),
                    written,
                ];
                self.tell(Code::StNeedsVariable, argument.at, words);
            }
            return false;
        };
        let Some(to) = self.writable(to) else {
            return false;
        };
        let bases = self
            .tree
            .types
            .base(param.ty)
            .zip(self.tree.types.base(to.ty));
        let bases = bases.filter(|&(from, into)| {
            let goes = self.goes_into(from, into) || self.bits_counted(from, into).is_some();
            // What a block gives is stored as any value is, and an enumeration is no number there.
            let is_number = instance.is_none() || !self.is_enum(param.ty);
            goes && is_number && !self.is_enum(to.ty)
        });
        if bases.is_none() && !self.tree.types.same(param.ty, to.ty) {
            self.told_other_type(&to, param.ty);
            return false;
        }
        if let Some(instance) = instance {
            let mut from = instance.clone();
            from.place.offset += param.offset;
            from.ty = param.ty;
            from.value = None;
            from.at = argument.at;
            let statement = match self.tree.types.is_scalar(param.ty) {
                true => {
                    let value = self.read(Some(from), argument.at);
                    self.assign(to, value, argument.at)
                }
                false => self.copy(to, from, argument.at),
            };
            let right = statement.is_some();
            after.extend(statement);
            return right;
        }
        let value = bases.map(|(from, into)| {
            self.takes_bits(from, into, argument.at);
            let how = conversion(from, into).unwrap_or(Convert::Keep);
            (from, how, self.store_of(to.ty))
        });
        call.outputs.push(Output {
            from: param.offset,
            cells: self.tree.types.get(param.ty).cells,
            to: to.place,
            value,
        });
        true
    }
}
