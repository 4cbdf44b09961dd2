//! Jumps to a label below: what is between is done where none of them jumps.

use super::Body;
use super::sentences::piece;
use crate::found::span;
use crate::ways::Ways;
use crate::xml::says;
use unoclp_lang::Code;

/// No more labels are jumped to at once.
const MOST_JUMPS: usize = 32;

impl<'a, 'x: 'a> Body<'_, 'a, 'x> {
    /// Passes the labels above an element, or all of them: nothing jumps there any longer.
    pub(super) fn pass_labels(&mut self, before: Option<usize>) {
        let network = self.network;
        while let Some(&label) = self.labels.last() {
            if before.is_some_and(|before| network.turn(before) < network.turn(label)) {
                return;
            }
            self.labels.pop();
            let element = &network.elements[label];
            let name = element.node.attribute("label").unwrap_or_default();
            if let Some(jump) = self.jumps.remove(name) {
                self.sentences.land(&jump);
                let lands = piece(&format!("{jump} := FALSE"), span(element.node));
                self.sentences.add(vec![lands]);
            }
        }
    }

    /// A jump; none where its label does not be below, which is reported.
    pub(super) fn jump(&mut self, at: usize) -> Option<()> {
        let network = self.network;
        let element = &network.elements[at];
        let label = element.node.attribute("label").unwrap_or_default();
        self.spend(at, network.elements.len())?;
        let is_label = |other: &usize| {
            let other = &network.elements[*other];
            other.kind == "label" && other.node.attribute("label") == Some(label)
        };
        if !self.labels.iter().any(is_label) {
            let code = match (0..network.elements.len()).any(|other| is_label(&other)) {
                true => Code::XmlJump,
                false => Code::XmlLabel,
            };
            self.tell(code, at, [label.into()]);
            return None;
        }
        let condition = self.condition(at, says(element.node, "negated"))?;
        let name = match self.jumps.get(label) {
            Some(name) => name.clone(),
            None if self.jumps.len() >= MOST_JUMPS => {
                self.too_large(at);
                return None;
            }
            None => {
                let name = self.add("jump", "BOOL", at);
                self.jumps.insert(label, name.clone());
                name
            }
        };
        let mut jumps = vec![piece(&format!("{name} := "), span(element.node))];
        jumps.extend(condition);
        self.sentences.add(jumps);
        self.sentences.jump(&name);
        Some(())
    }
}
