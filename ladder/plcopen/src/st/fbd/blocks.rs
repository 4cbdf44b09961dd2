//! Blocks of a diagram: when each is computed, and the variables that keep what it gave.

use super::super::sentences::{Piece, piece};
use super::super::what::What;
use super::super::{Body, Eno};
use crate::found::span;
use crate::network::Wire;
use crate::ways::Ways;
use unoclp_lang::Code;

/// A result of more pieces is kept in a variable.
const LONG: usize = 100;

impl<'a, 'x: 'a> Body<'_, 'a, 'x> {
    /// What ENO of a block says; none where it has no EN, or is not computed yet.
    pub(super) fn eno(&mut self, at: usize) -> Option<Vec<Piece>> {
        let place = span(self.network.elements[at].node);
        match self.enos.get(&at)? {
            Eno::Named(name) => Some(vec![piece(&name.clone(), place)]),
            Eno::Said(said) => Some(said.clone()),
        }
    }

    /// The result of a function that one element takes, written there.
    pub(super) fn inline(&mut self, at: usize) -> Option<Vec<Piece>> {
        if !self.network.elements[at].wires("EN").is_empty() {
            let said = self.led(at, "EN")?;
            self.enos.insert(at, Eno::Said(said));
        }
        let value = self.function_of(at, &[])?;
        if value.len() <= LONG {
            return Some(value);
        }
        let place = span(self.network.elements[at].node);
        let name = self.named(at);
        let mut does = vec![piece(&format!("{name} := "), place)];
        does.extend(value);
        self.sentences.add(does);
        Some(vec![piece(&name, place)])
    }

    /// Computes a block once; none, with a message, where something is wrong.
    pub(super) fn computed(&mut self, at: usize) -> Option<()> {
        if let Some(fine) = self.begun.get(&at) {
            return fine.then_some(());
        }
        self.begun.insert(at, true);
        let computed = match self.entered(at) {
            Some(()) => {
                let since = std::mem::replace(&mut self.since, self.walk.open.len());
                let computed = self.compute_now(at);
                self.since = since;
                self.walk.open.pop();
                computed
            }
            None => None,
        };
        self.begun.insert(at, computed.is_some());
        computed
    }

    fn compute_now(&mut self, at: usize) -> Option<()> {
        let network = self.network;
        let element = &network.elements[at];
        let place = span(element.node);
        let condition = match element.wires("EN").is_empty() {
            true => None,
            false => Some(self.led(at, "EN")?),
        };
        let mut does = Vec::new();
        let mut otherwise = None;
        if self.own[at] == What::Block {
            does = self.called(at)?;
        } else {
            let name = self.named(at);
            let mut further = Vec::new();
            for (output, _) in &element.outputs {
                if !output.eq_ignore_ascii_case("ENO") && !self.is_result(output, at) {
                    further.push((*output, self.output_of(at, output)?));
                }
            }
            does.push(piece(&format!("{name} := "), place));
            does.extend(self.function_of(at, &further)?);
            if self.is_truth(at) {
                otherwise = Some(vec![piece(&format!("{name} := FALSE"), place)]);
            }
        }
        let Some(condition) = condition else {
            self.sentences.add(does);
            return Some(());
        };
        // Where something has asked for ENO, which may be an input here, that keeps what it was until this is done.
        let is_asked = self.enos.contains_key(&at);
        let eno = self.eno_of(at);
        let name = match is_asked {
            true => self.add("en", "BOOL", at),
            false => eno.clone(),
        };
        let mut enables = vec![piece(&format!("{name} := "), place)];
        enables.extend(condition);
        self.sentences.add(enables);
        let condition = vec![piece(&name, place)];
        let group = (at, "EN".to_owned());
        self.sentences.grouped(group, condition, does, otherwise);
        if is_asked {
            let gives = piece(&format!("{eno} := {name}"), place);
            self.sentences.add(vec![gives]);
        }
        Some(())
    }

    /// The call of a function block.
    fn called(&mut self, at: usize) -> Option<Vec<Piece>> {
        let network = self.network;
        let element = &network.elements[at];
        let place = span(element.node);
        let instance = self.instance(at)?;
        let mut call = vec![piece(&format!("{instance}("), place)];
        for pin in &element.inputs {
            if pin.name.eq_ignore_ascii_case("EN") || pin.wires.is_empty() {
                continue;
            }
            let value = self.led(at, pin.name)?;
            let comma = if call.len() > 1 { ", " } else { "" };
            call.push(piece(&format!("{comma}{} := ", pin.name), place));
            call.extend(value);
        }
        call.push(piece(")", place));
        Some(call)
    }

    /// What a block has given last at an output.
    pub(super) fn given_by(&mut self, wire: Wire<'a>) -> Option<Vec<Piece>> {
        let at = wire.from;
        let place = span(self.network.elements[at].node);
        let is_eno = wire.output.eq_ignore_ascii_case("ENO");
        let is_enabled = !self.network.elements[at].wires("EN").is_empty();
        let name = match self.own[at] {
            _ if is_eno && !is_enabled => "TRUE".to_owned(),
            _ if is_eno => self.eno_of(at),
            What::Block => format!("{}.{}", self.instance(at)?, self.output(wire)),
            _ if self.is_result(wire.output, at) => self.named(at),
            _ => self.output_of(at, wire.output)?,
        };
        Some(vec![piece(&name, place)])
    }

    /// The variable that keeps the result of a function.
    fn named(&mut self, at: usize) -> String {
        if let Some(name) = self.names.get(&at) {
            return name.clone();
        }
        let kind = self.kind(at);
        let what = self.network.elements[at].block();
        let name = self.add(&what, &kind, at);
        self.names.insert(at, name.clone());
        name
    }

    /// The variable that keeps ENO of a block.
    fn eno_of(&mut self, at: usize) -> String {
        if let Some(Eno::Named(name)) = self.enos.get(&at) {
            return name.clone();
        }
        let name = self.add("eno", "BOOL", at);
        self.enos.insert(at, Eno::Named(name.clone()));
        name
    }

    /// The variable that keeps a further output of a function of the project.
    fn output_of(&mut self, at: usize, output: &str) -> Option<String> {
        let key = (at, output.to_uppercase());
        if let Some(name) = self.outputs.get(&key) {
            return Some(name.clone());
        }
        let block = self.network.elements[at].block();
        let Some(kind) = self.member(&block, output) else {
            self.tell(Code::XmlOutput, at, [block.into(), output.into()]);
            return None;
        };
        let name = self.add(output, &kind, at);
        self.outputs.insert(key, name.clone());
        Some(name)
    }
}
