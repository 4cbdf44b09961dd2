//! What a call gives to which parameter, and what comes back.

use super::builder::Builder;
use super::named::Param;
use super::places::Target;
use super::words::both;
use crate::Expr;
use unoclp_text::diagnostics::{Code, Span, Word};

/// What stands in the parentheses of a call, one of them.
#[derive(Debug)]
pub struct Argument {
    /// The parameter that it names.
    pub name: Option<(String, Span)>,
    /// `=>`
    pub out: bool,
    /// What it gives.
    pub given: Given,
    /// Where it stands.
    pub at: Span,
}

/// What is given.
#[derive(Debug)]
pub enum Given {
    /// A value.
    Value(Expr),
    /// A place, which can be stored in.
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

    pub(super) fn told_count(
        &mut self,
        name: &str,
        parameters: &[&str],
        any: bool,
        count: usize,
        at: Span,
    ) {
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

    pub(super) fn told_no_parameter(
        &mut self,
        name: &str,
        written: &str,
        params: &Params,
        at: Span,
    ) {
        if self.told_enable(written, at) {
            return;
        }
        let names = params.iter().map(|(p, _)| p.name.as_str());
        let list: Vec<&str> = names.clone().collect();
        let list = list.join(", ");
        let help = match unoclp_text::near::nearest(written, names) {
            Some(near) => Word::Near(near.to_string()),
            None => both(format!("it has {list}"), format!("ele tem {list}")),
        };
        self.tell(Code::StNoParameter, at, [name.into(), written.into(), help]);
    }
}
