//! Calls of function blocks.

use super::Body;
use super::sentences::{Group, Piece, piece};
use super::units::standard;
use crate::circuit::Circuit;
use crate::found::span;
use crate::network::Wire;
use crate::ways::Ways;
use unoclp_lang::Code;
use unoclp_lang::typed::{Role, Standard};

/// Inputs that a block of the standard may go without.
const LOOSE: [&str; 4] = ["R", "LD", "CU", "CD"];

impl<'a, 'x: 'a> Body<'_, 'a, 'x> {
    /// Calls a block, once; none, with a message, where something is wrong.
    pub(super) fn block(&mut self, at: usize) -> Option<()> {
        if let Some(fine) = self.begun.get(&at) {
            return fine.then_some(());
        }
        self.calls_above(at);
        if let Some(fine) = self.begun.get(&at) {
            // A call above has asked for it.
            return fine.then_some(());
        }
        self.begun.insert(at, true);
        let called = self.call(at);
        self.begun.insert(at, called.is_some());
        called
    }

    /// Makes the calls of the same instance that are drawn above.
    fn calls_above(&mut self, at: usize) {
        let name = self.network.elements[at].node.attribute("instanceName");
        let key = name.unwrap_or_default().to_uppercase();
        let network = self.network;
        loop {
            let Some(calls) = self.instances.get_mut(&key) else {
                return;
            };
            let next = calls.all.get(calls.made).copied();
            let Some(next) = next.filter(|next| network.turn(*next) < network.turn(at)) else {
                return;
            };
            calls.made += 1;
            self.block(next);
        }
    }

    /// The instance that a block calls; none where nothing declares it as one, which is reported.
    pub(super) fn instance(&mut self, at: usize) -> Option<&'a str> {
        let node = self.network.elements[at].node;
        let instance = node.attribute("instanceName").unwrap_or_default();
        let name = node.attribute("typeName").unwrap_or_default();
        let key = instance.to_uppercase();
        match self.variables.get(&key).map(|variable| &variable.kind) {
            None if !instance.contains(['.', '[']) || instance.is_empty() => {
                self.tell(Code::XmlUndeclared, at, [instance.into()]);
                return None;
            }
            Some(kind) if !kind.eq_ignore_ascii_case(name) => {
                let words = [instance.into(), kind.clone().into(), name.into()];
                self.tell(Code::XmlType, at, words);
                return None;
            }
            _ => {}
        }
        Some(instance)
    }

    fn call(&mut self, at: usize) -> Option<()> {
        let network = self.network;
        let element = &network.elements[at];
        let place = span(element.node);
        let instance = self.instance(at)?;
        let calls = self.instances.get(&instance.to_uppercase());
        let is_called_again = calls.is_some_and(|calls| calls.all.len() > 1);
        let norm = standard(&element.block());
        if let Some(input) = norm.and_then(|norm| self.lacks(at, norm)) {
            self.tell(Code::XmlPin, at, [input.into()]);
            return None;
        }
        let enabled = self.enabled(at)?;
        let mut call = vec![piece(&format!("{instance}("), place)];
        for pin in &element.inputs {
            let input = pin.name.to_uppercase();
            if input == "EN" {
                continue;
            }
            if pin.wires.is_empty() {
                continue;
            }
            let value = self.given(at, pin.name)?;
            let comma = if call.len() > 1 { ", " } else { "" };
            call.push(piece(&format!("{comma}{} := ", pin.name), place));
            call.extend(value);
        }
        call.push(piece(")", place));
        self.when(at, &enabled, call, None);
        if is_called_again {
            self.keep_outputs(at);
        }
        Some(())
    }

    /// Keeps what a call gave, since another call of the instance follows.
    fn keep_outputs(&mut self, at: usize) {
        let network = self.network;
        let element = &network.elements[at];
        let instance = element.node.attribute("instanceName").unwrap_or_default();
        let place = span(element.node);
        let mut readers = network.readers[at].clone();
        readers.retain(|reader| !network.is_end(reader.at));
        for reader in readers {
            let output = self.output(Wire {
                from: at,
                output: reader.output,
            });
            let key = (at, output.to_uppercase());
            if output.eq_ignore_ascii_case("ENO") || self.outputs.contains_key(&key) {
                continue;
            }
            let Some(kind) = self.member(&element.block(), output) else {
                continue;
            };
            let what = format!("{instance}_{output}").replace(|c: char| !c.is_alphanumeric(), "_");
            let name = self.add(&what, &kind, at);
            let keeps = format!("{name} := {instance}.{output}");
            self.sentences.add(vec![piece(&keeps, place)]);
            self.outputs.insert(key, name);
        }
    }

    /// The name of an output; of a wire that names none, the first.
    pub(super) fn output(&self, wire: Wire<'a>) -> &'a str {
        let element = &self.network.elements[wire.from];
        let named = element.outputs.iter().map(|(name, _)| *name);
        let mut named = named.filter(|name| !name.eq_ignore_ascii_case("ENO"));
        match wire.output {
            "" => named.next().unwrap_or("Q"),
            output => output,
        }
    }

    /// An input to which nothing leads and without which a block of the standard does nothing.
    fn lacks(&self, at: usize, norm: Standard) -> Option<&'static str> {
        let pins = self.network.elements[at].inputs.iter();
        let wired: Vec<&str> = pins
            .filter(|pin| !pin.wires.is_empty())
            .filter_map(|pin| norm.part(&pin.name.to_uppercase()))
            .map(|(_, part)| part.0)
            .collect();
        let inputs = norm.parts().iter();
        let mut needed = inputs.filter(|part| part.2 == Role::Input && !LOOSE.contains(&part.0));
        let lacking = needed.find(|part| !wired.contains(&part.0));
        lacking.map(|part| part.0)
    }

    /// What is done where EN of an element has power.
    pub(super) fn when(
        &mut self,
        at: usize,
        enabled: &Circuit,
        does: Vec<Piece>,
        otherwise: Option<Vec<Piece>>,
    ) {
        if enabled.is_empty() {
            return self.sentences.add(does);
        }
        let condition = self.said(enabled, false);
        let group = self.group(at);
        self.sentences.grouped(group, condition, does, otherwise);
    }

    /// What EN of an element comes from: after an ENO, what that comes from itself.
    fn group(&self, mut at: usize) -> Group {
        let network = self.network;
        for _ in 0..network.elements.len() {
            let [wire] = network.elements[at].wires("EN") else {
                break;
            };
            let is_eno = network.elements[wire.from].kind == "block"
                && wire.output.eq_ignore_ascii_case("ENO")
                && !network.elements[wire.from].wires("EN").is_empty();
            if !is_eno {
                return (wire.from, wire.output.to_uppercase());
            }
            at = wire.from;
        }
        (at, "EN".to_owned())
    }

    /// The way to EN; of none, the left rail.
    pub(super) fn enabled(&mut self, at: usize) -> Option<Circuit> {
        if let Some(known) = self.enabled.get(&at) {
            return known.clone();
        }
        let network = self.network;
        let mut enabled = match network.elements[at].wires("EN").is_empty() {
            true => Some(Circuit::new()),
            false => self.input(at, "EN"),
        };
        // Power that goes on is what it was, whatever this block writes.
        let mut readers = network.readers[at].iter();
        let goes_on = readers.any(|reader| {
            let by = &network.elements[reader.at];
            let is_eno = reader.output.eq_ignore_ascii_case("ENO");
            let takes = by.wires("EN").iter().any(|wire| wire.from == at);
            is_eno && !network.is_end(reader.at) && !takes
        });
        if let Some(circuit) = &enabled
            && goes_on
            && self.rewrites[at]
            && !circuit.is_empty()
        {
            enabled = Some(self.keep(at, &circuit.clone()));
        }
        self.enabled.insert(at, enabled.clone());
        enabled
    }

    /// An output of a block.
    pub(super) fn gives(&mut self, wire: Wire<'a>) -> Option<Circuit> {
        let at = wire.from;
        let element = &self.network.elements[at];
        let output = self.output(wire);
        if output.eq_ignore_ascii_case("ENO") {
            return match self.enabled.get(&at) {
                Some(known) => known.clone(),
                None => {
                    self.tell(Code::XmlLoop, at, []);
                    None
                }
            };
        }
        let instance = element.node.attribute("instanceName").unwrap_or_default();
        let given = match self.outputs.get(&(at, output.to_uppercase())) {
            Some(kept) => kept.clone(),
            None => format!("{instance}.{output}"),
        };
        let text = match element.is_negated(output) {
            true => format!("NOT {given}"),
            false => given,
        };
        let index = element.outputs.iter();
        let index = index.take_while(|(name, _)| *name != output).count();
        let said = vec![piece(&text, span(element.node))];
        Some(vec![self.leaf((at, 100 + index), said)])
    }
}
