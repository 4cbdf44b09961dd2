//! Functions and function blocks of the text's own.

use super::calls::positional;
use super::operands::Is;
use super::run::Acc;
use super::said::{BOOL, NUMBER};
use super::typed::natural;
use super::walk::Walk;
use crate::ast::{Instr, Param, Section, Unit, Var};
use std::collections::HashSet;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::{Argument, Given, Named, Target};
use unoclp_tree::{Base, Expr, ExprKind, Kind, Root, Stmt, StmtKind, TypeId};

/// So many names a message lists at most.
const MOST_NAMES: usize = 40;

/// What a call gives, where nothing is wrong with it, the names of the inputs among it, and what goes back after it.
type GivenTo = (Vec<Argument>, HashSet<String>, Vec<Stmt>);

impl<'a> Walk<'_, 'a, '_> {
    /// Whether a function as an operator takes the accumulator as its first input: where one operand is lacking.
    pub(super) fn takes_accumulator(&self, instr: &Instr) -> bool {
        let Some(unit) = self.function_of(instr) else {
            return instr.params.is_empty();
        };
        let inputs: Vec<&Var> = unit.vars.iter().filter(|var| is_input(var)).collect();
        let copied = inputs
            .first()
            .is_some_and(|var| var.section == Section::Input);
        instr.params.len() + instr.operands.len() + 1 == inputs.len() && copied
    }

    fn function_of(&self, instr: &Instr) -> Option<&'a Unit> {
        let unit = self.front.functions.get(instr.function.as_ref()?)?;
        self.front.units.get(*unit)
    }

    /// A function as an operator: `LIMIT a, b`.
    pub(super) fn function(&mut self, instr: &Instr) {
        let name = instr.function.as_ref();
        let unit = name.and_then(|name| self.front.functions.get(name));
        let Some(&unit) = unit else {
            return self.norm_operator(instr);
        };
        let mut params = instr.params.clone();
        params.extend(instr.operands.iter().map(positional));
        if !self.takes_accumulator(instr) {
            self.run.unused = None;
            return self.call_function(unit, &params, None, instr.span, instr.whole);
        }
        match self.take("CAL", instr.span) {
            Some(expr) => self.call_function(unit, &params, Some(expr), instr.span, instr.whole),
            None => self.run.acc = Acc::Wrong,
        }
    }

    /// A call of a function, with its first input where that is the accumulator.
    pub(super) fn call_function(
        &mut self,
        unit: usize,
        params: &[Param],
        first: Option<Expr>,
        name: Span,
        span: Span,
    ) {
        let number = self.front.numbers[unit];
        let Some((mut given, inputs, back)) = self.given_to(unit, params, first, name) else {
            self.run.acc = Acc::Wrong;
            return;
        };
        // What is not given has its default: a function keeps nothing.
        let defaults = self.defaults(unit, &inputs, span);
        given.extend(defaults);
        for param in params.iter().filter(|param| param.out) {
            let Some(target) = self.storable(&param.value) else {
                continue;
            };
            let Some(name) = &param.name else { continue };
            given.push(Argument {
                name: Some((name.text.clone(), name.span)),
                out: true,
                at: param.value.span,
                given: Given::Place(target),
            });
        }
        let changes = given.iter().any(|one| matches!(one.given, Given::Place(_)));
        if changes {
            self.front.writes = true;
            self.before_call(&given);
        }
        let expr = self.front.c.builder.call(number, given, name, span);
        // What it may change is changed here, and once.
        if !self.needed() {
            if let ExprKind::Call(call) = expr.kind {
                let kind = StmtKind::Call(*call);
                self.push(Stmt { kind, at: span });
            }
            back.into_iter().for_each(|one| self.push(one));
            self.run.acc = Acc::Empty;
            return;
        }
        let expr = self.aside(expr);
        back.into_iter().for_each(|one| self.push(one));
        let expr = self.wide(expr);
        self.run.links = 0;
        self.hold(Some(expr));
    }

    /// The inputs of a function that a call does not give.
    fn defaults(&mut self, unit: usize, given: &HashSet<String>, span: Span) -> Vec<Argument> {
        let units = self.front.units;
        let vars = units[unit].vars.iter();
        let left =
            vars.filter(|var| var.section == Section::Input && !given.contains(&var.name.text));
        let left: Vec<&Var> = left.filter(|var| var.typed.is_none()).collect();
        let mut all = Vec::new();
        for var in left {
            let number = var.init.last().and_then(|init| init.value.number());
            let number = number.unwrap_or(0);
            let Some(base) = Base::named(&var.ty.text) else {
                continue;
            };
            let value = match base {
                Base::Bool => self.truth(number != 0, span),
                _ => {
                    let whole = self.whole(number, span);
                    self.fit(whole, TypeId::of(base), base)
                }
            };
            all.push(Argument {
                name: Some((var.name.text.clone(), span)),
                out: false,
                at: span,
                given: Given::Value(value),
            });
        }
        all
    }

    /// A call of an instance of a function block.
    pub(super) fn call_instance(&mut self, target: Target, params: &[Param], span: Span) {
        let Kind::Block(number) = *self.front.c.builder.tree.types.kind(target.ty) else {
            return;
        };
        let Some(unit) = self.front.numbers.iter().position(|one| *one == number) else {
            return;
        };
        let from = (target.place.root != Root::Static).then_some(self.unit);
        let called = (from, target.place.offset);
        self.front.instance_calls.push((called, unit, span));
        let Some((given, _, back)) = self.given_to(unit, params, None, span) else {
            return;
        };
        self.before_call(&given);
        let body = self.front.c.builder.block(target.clone(), given, span);
        body.into_iter().for_each(|one| self.push(one));
        back.into_iter().for_each(|one| self.push(one));
        let (name, _) = self.front.unit_name(unit);
        for param in params.iter().filter(|param| param.out) {
            let output = param.name.as_ref().map_or("", |name| name.text.as_str());
            let draft = self.front.c.builder.draft(number);
            let Some(Named::Variable(variable)) = draft.and_then(|draft| draft.names.get(output))
            else {
                self.no_parameter(&name, param, ("see its VAR_OUTPUT", "veja seu VAR_OUTPUT"));
                continue;
            };
            let (offset, ty) = (variable.offset, variable.ty);
            let mut from = Target {
                ty,
                ..target.clone()
            };
            from.place.offset += offset;
            let value = self.read(from, span);
            self.store_value(value, &param.value, param.negated);
        }
    }

    /// The inputs that a call gives, each told that is wrong.
    fn given_to(
        &mut self,
        unit: usize,
        params: &[Param],
        first: Option<Expr>,
        span: Span,
    ) -> Option<GivenTo> {
        let (name, _) = self.front.unit_name(unit);
        let units = self.front.units;
        let vars: Vec<&Var> = units[unit]
            .vars
            .iter()
            .filter(|var| is_input(var))
            .collect();
        let done = usize::from(first.is_some());
        let mut given = Vec::new();
        let mut names = HashSet::new();
        let mut back = Vec::new();
        let mut right = true;
        if let (Some(expr), Some(var)) = (first, vars.first()) {
            right &= self.give(var, expr, span, &mut given);
            names.insert(var.name.text.clone());
        }
        for (index, param) in params.iter().enumerate().filter(|(_, param)| !param.out) {
            let named = param.name.as_ref().map(|name| name.text.as_str());
            let var = match named {
                Some(named) => vars.iter().find(|var| var.name.text == named),
                None => vars.get(index + done),
            };
            let Some(var) = var else {
                let all: Vec<&str> = vars.iter().map(|var| var.name.text.as_str()).collect();
                let names = few(&all);
                let has = (format!("it has {names}"), format!("tem {names}"));
                let (text, span) = match &param.name {
                    Some(word) => (self.front.names.written(word.span), word.span),
                    None => (self.spelled(&param.value), param.value.span),
                };
                let words = [name.as_str().into(), text.into(), has.into()];
                self.tell(Code::NoSuchParameter, span, words);
                right = false;
                continue;
            };
            names.insert(var.name.text.clone());
            if var.typed.is_some() {
                right &= self.give_typed(var, param, &mut given);
                continue;
            }
            if var.section == Section::InOut {
                right &= self.lend(var, param, &mut given, &mut back);
                continue;
            }
            let mut expr = self.value(&param.value);
            if param.negated {
                expr = self.param_bit(param);
            }
            match expr {
                Some(expr) => right &= self.give(var, expr, param.value.span, &mut given),
                None => right = false,
            }
        }
        let in_outs = vars.iter().filter(|var| var.section == Section::InOut);
        for var in in_outs.filter(|var| !names.contains(&var.name.text)) {
            let variable = self.front.names.written(var.name.span);
            let needs = (
                format!("a variable for its VAR_IN_OUT `{variable}`"),
                format!("uma variável para o seu VAR_IN_OUT `{variable}`"),
            );
            let words = [name.as_str().into(), needs.into()];
            self.tell(Code::ParameterMissing, span, words);
            right = false;
        }
        right.then_some((given, names, back))
    }

    /// A value for an input.
    fn give(&mut self, var: &Var, expr: Expr, span: Span, given: &mut Vec<Argument>) -> bool {
        let base = Base::named(&var.ty.text);
        let value = match base {
            _ if var.typed.is_some() => Some(natural(expr)),
            Some(Base::Bool) => self.as_bit(expr, "VAR_INPUT", span),
            Some(base) => {
                let number = self.as_number(expr, "VAR_INPUT", span);
                number.map(|number| self.fit(number, TypeId::of(base), base))
            }
            // A block cannot be given.
            None => return true,
        };
        let Some(value) = value else { return false };
        given.push(Argument {
            name: Some((var.name.text.clone(), span)),
            out: false,
            at: span,
            given: Given::Value(value),
        });
        true
    }

    /// A copy of a number of another width, which goes back after the call.
    fn lend_copy(
        &mut self,
        target: Target,
        own: Option<Base>,
        span: Span,
        back: &mut Vec<Stmt>,
    ) -> Target {
        let Some(copy) = own.and_then(|own| self.own(TypeId::of(own), span)) else {
            return target;
        };
        let value = self.read(target.clone(), span);
        let there = self.assigned(&copy, value, span);
        there.into_iter().for_each(|one| self.push(one));
        let value = self.read(copy.clone(), span);
        back.extend(self.assigned(&target, value, span));
        copy
    }

    /// A variable of the caller, for VAR_IN_OUT.
    fn lend(
        &mut self,
        var: &Var,
        param: &Param,
        given: &mut Vec<Argument>,
        back: &mut Vec<Stmt>,
    ) -> bool {
        let span = param.value.span;
        let text = self.spelled(&param.value);
        let wants_bit = var.ty.text == "BOOL";
        let target = match self.meaning(&param.value) {
            Is::Wrong => return false,
            Is::Constant(_) => {
                self.tell(Code::NotWritable, span, [text.into()]);
                return false;
            }
            _ if param.negated => {
                self.tell(Code::NotWritable, span, [text.into()]);
                return false;
            }
            Is::Variable(target) => {
                let base = self.front.c.builder.tree.types.base(target.ty);
                let own = Base::named(&var.ty.text);
                match (base == Some(Base::Bool), wants_bit) {
                    (true, false) => {
                        self.wrong_type(text.into(), span, BOOL, NUMBER);
                        return false;
                    }
                    (false, true) => {
                        self.wrong_type(text.into(), span, NUMBER, BOOL);
                        return false;
                    }
                    _ if own.is_some() && own != base => self.lend_copy(target, own, span, back),
                    _ => target,
                }
            }
            Is::Block(target, _) | Is::Instance(target) => target,
        };
        given.push(Argument {
            name: Some((var.name.text.clone(), span)),
            out: false,
            at: span,
            given: Given::Place(Target {
                locked: None,
                ..target
            }),
        });
        true
    }
}

/// Whether a call gives a variable: VAR_INPUT, VAR_IN_OUT.
fn is_input(var: &Var) -> bool {
    matches!(var.section, Section::Input | Section::InOut)
}

/// The first of these names.
fn few(names: &[&str]) -> String {
    let more = if names.len() > MOST_NAMES {
        ", …"
    } else {
        ""
    };
    let first = names.iter().take(MOST_NAMES).copied();
    first.collect::<Vec<_>>().join(", ") + more
}
