//! What a call gives to which parameter, and what comes back.

use super::coerce::conversion;
use super::declare::Section;
use super::places::Target;
use super::{Builder, Param, both};
use crate::diagnostics::{Code, Span, Word};
use crate::typed::{Call, Convert, Expr, ExprKind, Input, Output, Place, Stmt};
use std::collections::HashSet;

/// What stands in the parentheses of a call, one of them.
#[derive(Debug)]
pub(crate) struct Argument {
    pub name: Option<(String, Span)>,
    /// `=>`
    pub out: bool,
    pub given: Given,
    pub at: Span,
}

/// What is given.
#[derive(Debug)]
pub(crate) enum Given {
    Value(Expr),
    Place(Target),
    /// What is wrong has been told.
    Wrong,
}

/// Where a call of a block goes.
pub(super) type Params = Vec<(Param, bool)>;

impl Builder<'_, '_> {
    /// What is given, as a value.
    pub(super) fn value(&mut self, given: Given, at: Span) -> Expr {
        match given {
            Given::Value(expr) => expr,
            Given::Place(target) => self.read(Some(target), at),
            Given::Wrong => self.wrong(at),
        }
    }

    /// The operands of a standard function in the order of its parameters. With `any`, the last parameter repeats.
    pub(super) fn in_order(
        &mut self,
        name: &str,
        parameters: &[&str],
        any: bool,
        arguments: Vec<Argument>,
        at: Span,
    ) -> Option<Vec<Expr>> {
        let count = arguments.len();
        let mut names = arguments
            .iter()
            .filter_map(|argument| argument.name.clone());
        if let Some((written, span)) = names.find(|name| name.0.to_uppercase().starts_with("EN"))
            && self.told_enable(&written, span)
        {
            return None;
        }
        let fits = count == parameters.len() || any && count > parameters.len();
        if !fits {
            self.told_count(name, parameters, any, count, at);
            return None;
        }
        let named = arguments.iter().filter(|argument| argument.name.is_some());
        if named.count() == 0 {
            let values = arguments.into_iter();
            return Some(
                values
                    .map(|argument| self.value(argument.given, argument.at))
                    .collect(),
            );
        }
        let mut slots: Vec<Option<Expr>> = (0..count).map(|_| None).collect();
        for argument in arguments {
            let Some((written, span)) = argument.name else {
                self.tell(
                    Code::StMixed,
                    argument.at,
                    [parameters.join(" := …, ").into()],
                );
                return None;
            };
            let key = written.to_uppercase();
            let fixed = parameters.iter().position(|parameter| *parameter == key);
            let first: usize = parameters
                .last()
                .and_then(|last| last.strip_prefix("IN"))
                .and_then(|number| number.parse().ok())
                .unwrap_or(0);
            let further = || {
                let number: usize = key.strip_prefix("IN")?.parse().ok()?;
                (parameters.len() - 1).checked_add(number.checked_sub(first)?)
            };
            let slot = fixed.or_else(|| further().filter(|slot| any && *slot < count));
            let Some(slot) = slot else {
                if self.told_enable(&written, span) {
                    return None;
                }
                let list = parameters.join(", ");
                let help = both(format!("it has {list}"), format!("ela tem {list}"));
                self.tell(
                    Code::StNoParameter,
                    span,
                    [name.into(), written.into(), help],
                );
                return None;
            };
            let value = self.value(argument.given, argument.at);
            if slots[slot].is_some() {
                self.tell(Code::StParameterTwice, span, [written.into()]);
                return None;
            }
            slots[slot] = Some(value);
        }
        slots.into_iter().collect()
    }

    fn told_count(&mut self, name: &str, parameters: &[&str], any: bool, count: usize, at: Span) {
        let needs = parameters.len();
        let takes: Word = match (needs, any) {
            (1, _) => ("one value", "um valor").into(),
            (n, false) => both(format!("{n} values"), format!("{n} valores")),
            (n, true) => both(
                format!("{n} values or more"),
                format!("{n} valores ou mais"),
            ),
        };
        let list = parameters.join(", ");
        let help = both(
            format!("write {name}({list})"),
            format!("escreva {name}({list})"),
        );
        self.tell(
            Code::StArguments,
            at,
            [name.into(), takes, count.to_string().into(), help],
        );
    }

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
        if with_names == 0 && !arguments.is_empty() {
            let order: Vec<usize> = (0..params.len()).filter(|&i| takes(&params[i].0)).collect();
            let wrong = match instance {
                // Fewer are let by: a block keeps its inputs.
                Some(_) => arguments.len() > order.len(),
                None => arguments.len() != order.len(),
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
        for argument in arguments {
            let found = match &argument.name {
                Some((written, _)) => {
                    let key = self.key(written);
                    params.iter().position(|(p, _)| self.key(&p.name) == key)
                }
                None => {
                    while params.get(next).is_some_and(|(p, _)| !takes(p)) {
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
            if argument.out != (param.section == Section::Output) {
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

    /// EN and ENO, which are not read: it is told.
    fn told_enable(&mut self, written: &str, at: Span) -> bool {
        let is = ["EN", "ENO"]
            .iter()
            .any(|name| written.eq_ignore_ascii_case(name));
        if is {
            let help = (
                "write IF … THEN … END_IF around the call",
                "escreva IF … THEN … END_IF em volta da chamada",
            );
            self.tell(Code::StUnsupported, at, [written.into(), help.into()]);
        }
        is
    }

    fn told_no_parameter(&mut self, name: &str, written: &str, params: &Params, at: Span) {
        if self.told_enable(written, at) {
            return;
        }
        let names = params.iter().map(|(p, _)| p.name.as_str());
        let list: Vec<&str> = names.clone().collect();
        let list = list.join(", ");
        let help = match crate::names::near::nearest(written, names) {
            Some(near) => both(format!("is it `{near}`?"), format!("seria `{near}`?")),
            None => both(format!("it has {list}"), format!("ele tem {list}")),
        };
        self.tell(Code::StNoParameter, at, [name.into(), written.into(), help]);
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
        let value = match (self.tree.types.base(param.ty), self.tree.types.base(to.ty)) {
            (Some(from), Some(base)) if from.widens_to(base) && !self.is_enum(to.ty) => {
                let how = conversion(from, base).unwrap_or(Convert::Keep);
                Some((from, how, self.store_of(to.ty)))
            }
            _ if self.tree.types.same(param.ty, to.ty) => None,
            _ => {
                self.told_other_type(&to, param.ty);
                return false;
            }
        };
        call.outputs.push(Output {
            from: param.offset,
            cells: self.tree.types.get(param.ty).cells,
            to: to.place,
            value,
        });
        true
    }
}
