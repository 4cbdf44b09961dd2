//! The type of a result that a variable has to keep.

use super::Body;
use super::units::{returns, standard};
use super::what::What;
use crate::network::Wire;
use unoclp_lang::brought;
use unoclp_lang::typed::Base;

/// Results after each other are looked at so far, to find a type.
const FAR: usize = 32;

impl<'a, 'x: 'a> Body<'_, 'a, 'x> {
    /// The type of what a function gives.
    pub(super) fn kind(&mut self, at: usize) -> String {
        if let Some(known) = self.kinds.get(&at) {
            return known.clone();
        }
        let found = self.result(at, FAR);
        let kind = found.or_else(|| self.taken_as(at, FAR));
        let kind = kind.unwrap_or_else(|| match self.network.elements[at].block().as_str() {
            "AND" | "OR" | "XOR" | "NOT" => "BOOL".to_owned(),
            _ => "DINT".to_owned(),
        });
        self.kinds.insert(at, kind.clone());
        kind
    }

    /// Whether a function gives a truth.
    pub(super) fn is_truth(&mut self, at: usize) -> bool {
        self.kind(at).eq_ignore_ascii_case("BOOL")
    }

    /// The type that a function has by its name, or by what leads to it.
    fn result(&self, at: usize, far: usize) -> Option<String> {
        let far = far.checked_sub(1)?;
        let element = &self.network.elements[at];
        let name = element.block();
        if let Some(own) = self.units.get(&name) {
            return Some(returns(own));
        }
        if self.own[at] == What::Truth {
            return Some("BOOL".to_owned());
        }
        let to = name.rsplit_once("_TO_").or(name.rsplit_once("_TRUNC_"));
        let to = to.map(|(_, to)| to).or(name.strip_prefix("TO_"));
        if let Some(to) = to {
            return Some(to.to_owned());
        }
        match &*name {
            "MULTIME" | "DIVTIME" => return Some("TIME".to_owned()),
            "LEN" | "FIND" => return Some("INT".to_owned()),
            "TRUNC" => return None,
            _ => {}
        }
        let chooses = ["EN", "G", "K", "N", "L", "P"];
        let inputs = element.inputs.iter();
        let inputs = inputs.filter(|pin| !chooses.contains(&&*pin.name.to_uppercase()));
        // Of a few inputs, so that chains of many stay cheap.
        let kinds = inputs
            .take(3)
            .flat_map(|pin| &pin.wires)
            .filter_map(|wire| self.of_wire(*wire, far / 2));
        kinds.reduce(|one, other| wider(&one, other))
    }

    /// The type of what takes the result: a variable, an input of a block, another result.
    fn taken_as(&self, at: usize, far: usize) -> Option<String> {
        let far = far.checked_sub(1)?;
        let readers = self.network.readers[at].iter();
        let readers = readers.filter(|reader| !reader.output.eq_ignore_ascii_case("ENO"));
        // Of a few, so that chains of many stay cheap.
        let mut readers = readers.take(3);
        readers.find_map(|reader| {
            let by = &self.network.elements[reader.at];
            let mut pins = by.inputs.iter();
            let leads = |wire: &Wire<'_>| wire.from == at && wire.output == reader.output;
            let pin = pins.find(|pin| pin.wires.iter().any(leads));
            match (by.kind, self.own[reader.at]) {
                ("outVariable" | "inOutVariable", _) => self.of_text(&by.written),
                (_, What::Function | What::Truth) if is_truth(pin?.name) => Some("BOOL".to_owned()),
                (_, What::Block | What::Own) => self.member(&by.block(), pin?.name),
                (_, What::Function) if by.block().contains("_TO_") => {
                    let from = by.block();
                    let from = from.split("_TO_").next()?;
                    Base::named(from).map(|base| base.name().to_owned())
                }
                (_, What::Function) => self
                    .result(reader.at, far / 2)
                    .or_else(|| self.taken_as(reader.at, far / 2)),
                _ => None,
            }
        })
    }

    fn of_wire(&self, wire: Wire<'a>, far: usize) -> Option<String> {
        let from = &self.network.elements[wire.from];
        match (from.kind, self.own[wire.from]) {
            ("contact" | "coil" | "leftPowerRail", _) => Some("BOOL".to_owned()),
            ("inVariable" | "inOutVariable", _) => self.of_text(&from.written),
            ("continuation", _) => {
                let connector = self.network.connector(wire.from)?;
                let of = self.network.elements[connector].wires("").first()?;
                self.of_wire(*of, far.checked_sub(1)?)
            }
            (_, What::Block) => self.member(&from.block(), wire.output),
            (_, what) if what.is_function() => match wire.output.to_uppercase().as_str() {
                "ENO" => Some("BOOL".to_owned()),
                _ => self.result(wire.from, far),
            },
            _ => None,
        }
    }

    /// The type of a variable with its members and subscripts, or of a number; none where the text does not say it.
    pub(super) fn of_text(&self, written: &str) -> Option<String> {
        let written = written.trim();
        let upper = written.to_uppercase();
        if matches!(&*upper, "TRUE" | "FALSE") {
            return Some("BOOL".to_owned());
        }
        if let Some((kind, _)) = upper.split_once('#') {
            return match kind {
                "T" => Some("TIME".to_owned()),
                kind => Base::named(kind).map(|base| base.name().to_owned()),
            };
        }
        let is_name = |c: char| c.is_alphanumeric() || c == '_';
        let end = written.find(|c| !is_name(c)).unwrap_or(written.len());
        let (name, mut rest) = written.split_at_checked(end)?;
        let name = name.to_uppercase();
        let result = self.result.as_ref().filter(|(own, _)| *own == name);
        let mut kind = match (self.variables.get(&name), result) {
            (Some(variable), _) => variable.kind.clone(),
            (None, Some((_, kind))) => kind.clone(),
            (None, None) => return None,
        };
        while !rest.is_empty() {
            if let Some(subscripts) = rest.strip_prefix('[') {
                rest = subscripts.split_once(']')?.1;
                let array = self.units.types.base(&kind).unwrap_or(kind);
                kind = array.split_once(" OF ")?.1.to_owned();
            } else if let Some(member) = rest.strip_prefix('.') {
                let end = member.find(|c| !is_name(c)).unwrap_or(member.len());
                kind = self.member(&kind, member.get(..end)?)?;
                rest = member.get(end..)?;
            } else {
                // An operator: the type of a sum is that of what it begins with.
                break;
            }
        }
        Some(kind)
    }

    /// The type of a member of a structure or a block.
    pub(super) fn member(&self, of: &str, member: &str) -> Option<String> {
        if let Some(pou) = self.units.get(of) {
            let mut variables = pou.variables.iter();
            let own = variables.find(|own| own.name.eq_ignore_ascii_case(member))?;
            return Some(own.kind.clone());
        }
        if let Some(block) = standard(&of.to_uppercase()) {
            let (_, (_, base, _)) = block.part(&member.to_uppercase())?;
            return Some(base.name().to_owned());
        }
        let brought = brought(&of.to_uppercase(), &member.to_uppercase());
        let brought = brought.map(|base| base.name().to_owned());
        brought.or_else(|| self.units.types.member(of, member))
    }
}

/// The type that holds the values of both.
fn wider(one: &str, other: String) -> String {
    let common = Base::named(&one.to_uppercase())
        .zip(Base::named(&other.to_uppercase()))
        .and_then(|(one, other)| one.common(other));
    common.map_or(other, |base| base.name().to_owned())
}

/// Whether an input of a function of the standard is a truth, whatever it gives.
fn is_truth(pin: &str) -> bool {
    pin.eq_ignore_ascii_case("EN") || pin.eq_ignore_ascii_case("G")
}
