//! Calls: what is given to which parameter, and what comes back.

use super::coerce::conversion;
use super::declare::Section;
use super::places::Target;
use super::{Builder, Named, Param, both};
use crate::diagnostics::{Code, Span, Word};
use crate::typed::standard::{Role, Standard};
use crate::typed::{
    Base, Call, Convert, Expr, ExprKind, Input, Kind, Output, Place, Root, Stmt, StmtKind, Store,
    TypeId, UnitKind,
};
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
type Params = Vec<(Param, bool)>;

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

    /// A call of a function of the text: its value.
    pub fn call(&mut self, unit: u32, arguments: Vec<Argument>, name_at: Span, at: Span) -> Expr {
        let Some((call, result)) = self.made_call(unit, arguments, name_at, at) else {
            return self.wrong(at);
        };
        let Some(base) = self.tree.types.base(result) else {
            let (written, what) = (self.written(name_at), self.what_type(result));
            let part = format!("x := {written}(…)");
            self.tell(Code::StSharedWhole, at, [written.into(), what, part.into()]);
            return self.wrong(at);
        };
        Expr {
            kind: ExprKind::Call(Box::new(call)),
            base,
            ty: result,
            at,
        }
    }

    /// A call of a function of the text as a statement.
    pub fn call_statement(
        &mut self,
        unit: u32,
        arguments: Vec<Argument>,
        name_at: Span,
        at: Span,
    ) -> Option<Stmt> {
        let (call, _) = self.made_call(unit, arguments, name_at, at)?;
        if call.lent.is_empty() && call.outputs.is_empty() {
            let name = self.written(name_at);
            self.tell(Code::StResultUnused, at, [name.into()]);
        }
        Some(Stmt {
            kind: StmtKind::Call(call),
            at,
        })
    }

    /// A call whose result, with parts, is stored: `x := F(…)`.
    pub fn call_into(
        &mut self,
        unit: u32,
        arguments: Vec<Argument>,
        target: Target,
        at: Span,
    ) -> Option<Stmt> {
        let name_at = at;
        let (mut call, result) = self.made_call(unit, arguments, name_at, at)?;
        if !self.tree.types.same(target.ty, result) {
            let wrong = Expr {
                kind: ExprKind::Read(Box::new(target.place)),
                base: Base::Bool,
                ty: result,
                at,
            };
            self.told_mismatch(&wrong, target.ty);
            return None;
        }
        let to = self.writable(target)?;
        call.outputs.push(Output {
            from: 0,
            cells: self.tree.types.get(result).cells,
            to: to.place,
            value: None,
        });
        Some(Stmt {
            kind: StmtKind::Call(call),
            at,
        })
    }

    fn made_call(
        &mut self,
        unit: u32,
        arguments: Vec<Argument>,
        name_at: Span,
        at: Span,
    ) -> Option<(Call, TypeId)> {
        let draft = self.draft(unit)?;
        let name = draft.unit.name.clone();
        let result = draft.result?;
        let params: Params = draft.params.iter().map(|p| (p.clone(), false)).collect();
        self.lenient = draft.incomplete;
        if let Some(here) = self.current {
            self.edges.push((here as u32, unit, name_at));
        }
        let mut call = Call {
            unit,
            instance: None,
            inputs: Vec::new(),
            lent: Vec::new(),
            outputs: Vec::new(),
            at,
        };
        self.pass(&name, params, arguments, None, &mut call, at)?;
        self.writes |= !call.lent.is_empty() || !call.outputs.is_empty();
        Some((call, result))
    }

    /// A call of an instance of a block: its inputs, the call, what is read behind it.
    pub fn block(&mut self, target: Target, arguments: Vec<Argument>, at: Span) -> Vec<Stmt> {
        self.writes = true;
        match self.tree.types.kind(target.ty).clone() {
            Kind::Standard(block) => self.standard(block, target, arguments, at),
            Kind::Block(unit) => self.own_block(unit, target, arguments, at),
            _ => {
                let (written, what) = (self.written(target.at), self.what_type(target.ty));
                let help = (
                    "a function and an instance of a function block can be called",
                    "podem ser chamadas uma função e uma instância de um bloco de funções",
                );
                self.tell(
                    Code::StNotCallable,
                    target.at,
                    [written.into(), what, help.into()],
                );
                Vec::new()
            }
        }
    }

    fn own_block(
        &mut self,
        unit: u32,
        target: Target,
        arguments: Vec<Argument>,
        at: Span,
    ) -> Vec<Stmt> {
        let Some(draft) = self.draft(unit) else {
            return Vec::new();
        };
        let name = draft.unit.name.clone();
        let params: Params = draft.params.iter().map(|p| (p.clone(), false)).collect();
        self.lenient = draft.incomplete;
        if let Some(here) = self.current {
            self.edges.push((here as u32, unit, target.at));
        }
        let mut call = Call {
            unit,
            instance: Some(target.place.clone()),
            inputs: Vec::new(),
            lent: Vec::new(),
            outputs: Vec::new(),
            at,
        };
        let Some(mut after) = self.pass(&name, params, arguments, Some(&target), &mut call, at)
        else {
            return Vec::new();
        };
        let mut all = vec![Stmt {
            kind: StmtKind::Call(call),
            at,
        }];
        all.append(&mut after);
        all
    }

    fn standard(
        &mut self,
        block: Standard,
        target: Target,
        arguments: Vec<Argument>,
        at: Span,
    ) -> Vec<Stmt> {
        let written = self.written(target.at);
        let timed = !matches!(block, Standard::Sr | Standard::Rs);
        if timed && self.loops > 0 {
            let words = [written.clone().into(), block.name().into()];
            self.tell(Code::StCalledInLoop, target.at, words);
        }
        let scope = match target.place.root {
            Root::Static => None,
            _ => self.current,
        };
        let key = (scope, target.place.root, target.place.offset);
        if timed && self.called.insert(key, at).is_some() {
            let words = [written.into(), block.name().into()];
            self.tell(Code::StCalledTwice, target.at, words);
        }
        let param = |(offset, (name, base, role)): (u32, (&str, Base, Role))| {
            let section = match role {
                Role::Input => Section::Input,
                _ => Section::Output,
            };
            let param = Param {
                name: name.to_owned(),
                section,
                ty: TypeId::of(base),
                offset,
            };
            (param, false)
        };
        let parts = (0..).zip(block.parts().iter().copied());
        let params = parts
            .filter(|(_, part)| part.2 != Role::Hidden)
            .map(param)
            .collect();
        let mut call = Call {
            unit: 0,
            instance: None,
            inputs: Vec::new(),
            lent: Vec::new(),
            outputs: Vec::new(),
            at,
        };
        let after = self.pass(
            block.name(),
            params,
            arguments,
            Some(&target),
            &mut call,
            at,
        );
        let Some(mut after) = after else {
            return Vec::new();
        };
        let mut all = Vec::new();
        for input in call.inputs {
            if let Input::Value(offset, value, store) = input {
                let mut place = target.place.clone();
                place.offset += offset;
                let at = value.at;
                all.push(Stmt {
                    kind: StmtKind::Assign(place, value, store),
                    at,
                });
            }
        }
        all.push(Stmt {
            kind: StmtKind::Standard(block, target.place),
            at,
        });
        all.append(&mut after);
        all
    }

    /// Gives each argument to its parameter. For an instance, the stores of its outputs come back.
    fn pass(
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

    pub(super) fn told_other_type(&mut self, target: &Target, needed: TypeId) {
        let (written, is) = (self.written(target.at), self.tree.types.name(target.ty));
        let name = self.tree.types.name(needed);
        let help = both(
            format!("give it a variable of type {name}"),
            format!("dê a ele uma variável do tipo {name}"),
        );
        let words = [written.into(), is.into(), name.into(), help];
        self.tell(Code::StMismatch, target.at, words);
    }

    /// What is called by this name.
    pub fn callee(&mut self, name: &str, at: Span) -> Option<u32> {
        match self.find(name).cloned() {
            Some(Named::Unit(unit)) => {
                let kind = self.draft(unit)?.unit.kind;
                if kind == UnitKind::Function {
                    return Some(unit);
                }
                None
            }
            Some(Named::Type(ty))
                if matches!(self.tree.types.kind(ty), Kind::Standard(_) | Kind::Block(_)) =>
            {
                let instance = format!("{name}1");
                self.tell(Code::StTypeCalled, at, [name.into(), instance.into()]);
                self.told_name(name);
                None
            }
            Some(named) => {
                let what = self.what(&named);
                let help = (
                    "a function and an instance of a function block can be called",
                    "podem ser chamadas uma função e uma instância de um bloco de funções",
                );
                self.tell(Code::StNotCallable, at, [name.into(), what, help.into()]);
                self.told_name(name);
                None
            }
            None => {
                if Standard::named(&name.to_uppercase()).is_some() {
                    let instance = format!("{name}1");
                    self.tell(Code::StTypeCalled, at, [name.into(), instance.into()]);
                    return None;
                }
                let help = (
                    "declare an instance of a function block, or write a FUNCTION of this name",
                    "declare uma instância de um bloco de funções ou escreva uma FUNCTION com esse nome",
                );
                let help = self.near(name, help.into());
                self.tell(Code::StUndeclared, at, [name.into(), help]);
                self.told_name(name);
                None
            }
        }
    }

    /// How a value of this type is stored.
    pub(super) fn store_of(&self, ty: TypeId) -> Store {
        match self.tree.types.kind(ty) {
            Kind::Range { base, low, high } => Store::Within(*base, *low, *high),
            Kind::Text { most, .. } => Store::Text(*most),
            Kind::Base(base) if base.is_text() => Store::Text(254),
            _ => Store::Narrow(self.tree.types.base(ty).unwrap_or(Base::Bool)),
        }
    }
}
