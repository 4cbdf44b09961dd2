//! What a name means in a program.

use crate::allot::{Allotted, Place, allot, by_name};
use crate::found::Found;
use crate::project::Variable;
use crate::symbol::{Counts, Meaning, Symbol, number};
use std::collections::HashMap;
use std::sync::Arc;
use unoclp_lang::{Code, Span, Word};
use unoclp_point::Address;

/// The names of one program.
pub(crate) struct Scope {
    locals: HashMap<String, Place>,
}

impl Scope {
    pub(crate) fn new(variables: &[Variable]) -> Scope {
        Scope {
            locals: by_name(variables),
        }
    }

    /// What is written at an element, which is called so and is there; none where that is told to be wrong.
    pub(crate) fn meaning(
        &mut self,
        written: &str,
        who: &Word,
        at: Span,
        all: &mut Allotted,
        found: &mut Found,
    ) -> Option<Meaning> {
        let upper = written.trim().to_uppercase();
        match upper.as_str() {
            "TRUE" | "BOOL#TRUE" | "BOOL#1" => return Some(Meaning::Truth(true)),
            "FALSE" | "BOOL#FALSE" | "BOOL#0" => return Some(Meaning::Truth(false)),
            _ => {}
        }
        if upper.starts_with('%') {
            return match all.points.address(written) {
                Ok(point) => {
                    all.points.tell_moved(written, at, found);
                    Some(Meaning::Symbol(Symbol::At(point)))
                }
                Err(help) => {
                    let words = [who.clone(), written.trim().into(), help];
                    found.tell_at(Code::XmlAddress, at, words);
                    None
                }
            };
        }
        if upper.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '+')
            || upper.contains('#')
        {
            let number = number(written);
            if number.is_none() {
                let what = ("32-bit number", "um número que caiba em 32 bits");
                found.tell_at(
                    Code::XmlValue,
                    at,
                    [who.clone(), written.into(), what.into()],
                );
            }
            return number.map(|number| Meaning::Symbol(Symbol::Constant(number)));
        }
        let member = upper.split_once('.').map(|(_, member)| member);
        let own = written.trim().split('.').next().unwrap_or_default();
        let symbol = self.symbol(own, who, at, all, found)?;
        let meant = match (symbol, member) {
            (symbol, None) => Some(symbol),
            (Symbol::At(Address::Timer(_)), Some("Q")) => Some(symbol),
            (Symbol::At(Address::Timer(timer)), Some("ET")) => {
                Some(Symbol::At(Address::Elapsed(timer)))
            }
            (Symbol::Counter(counter, Counts::Down), Some("Q"))
            | (Symbol::Counter(counter, Counts::Both), Some("QD")) => {
                Some(Symbol::At(Address::AtZero(counter)))
            }
            (Symbol::Counter(_, Counts::Up), Some("Q")) => Some(symbol),
            (Symbol::Counter(_, Counts::Both), Some("QU")) => Some(symbol),
            (Symbol::Counter(counter, _), Some("CV")) => Some(Symbol::At(Address::Count(counter))),
            (Symbol::Latch(_), Some("Q1")) => Some(symbol),
            _ => None,
        };
        if meant.is_none() {
            found.tell_at(Code::XmlUndeclared, at, [who.clone(), written.into()]);
        }
        meant.map(Meaning::Symbol)
    }

    /// The point of a variable, which gets one where it has none yet.
    fn symbol(
        &mut self,
        name: &str,
        who: &Word,
        at: Span,
        all: &mut Allotted,
        found: &mut Found,
    ) -> Option<Symbol> {
        let upper = name.to_uppercase();
        let own = match self.locals.get_mut(&upper) {
            Some(local) => Some(local),
            None => all.globals.get_mut(&upper),
        };
        let Some(own) = own else {
            match name {
                "" => found.tell_at(Code::XmlNoVariable, at, [who.clone()]),
                _ => found.tell_at(Code::XmlUndeclared, at, [who.clone(), name.into()]),
            }
            return None;
        };
        let variable = match own {
            Place::Waits(variable) => Arc::clone(variable),
            Place::Has(symbol) => return Some(*symbol),
            // That has been told.
            Place::None => return None,
        };
        let symbol = allot(&variable, who, all, found);
        let place = symbol.map_or(Place::None, Place::Has);
        let own = match self.locals.get_mut(&upper) {
            Some(local) => Some(local),
            None => all.globals.get_mut(&upper),
        };
        if let Some(own) = own {
            *own = place;
        }
        symbol
    }
}
