//! The condition of a transition: written beside it, drawn to it, or a transition of the unit by its name.

use super::bodies::Bodies;
use super::net::{Transition, reference};
use super::wired::Wired;
use super::written::{in_language, tell};
use crate::found::{Found, span};
use crate::st;
use crate::st::list::Role;
use crate::text::Text;
use crate::xml::{all, first, says, text};
use roxmltree::Node;
use unoclp_lang::{Code, Word};

impl<'a, 'x: 'a> Bodies<'_, 'a, 'x> {
    /// Writes `:= condition;` of a transition.
    pub(super) fn condition(
        &mut self,
        transition: &Transition<'a, 'x>,
        body: Node<'a, 'x>,
        to: &mut Text,
        found: &mut Found,
    ) {
        let Some(of) = first(transition.node, "condition") else {
            return self.lacks(transition, NOTHING.into(), found);
        };
        let negated = says(of, "negated") || says(transition.node, "negated");
        if let Some(name) = reference(of) {
            let named = self.transitions.get(&name.to_uppercase()).copied();
            return match named.and_then(|named| first(named, "body")) {
                Some(body) => self.written(transition, body, negated, to, found),
                // A variable.
                None => {
                    let at = first(of, "reference").map_or(transition.at, span);
                    let not = if negated { "NOT " } else { "" };
                    to.piece(&format!(":= {not}{name};"), at);
                }
            };
        }
        if let Some(inline) = first(of, "inline") {
            return self.written(transition, inline, negated, to, found);
        }
        let mut points = all(of, "connectionPointIn");
        let wires = all(of, "connection").chain(points.by_ref().flat_map(|p| all(p, "connection")));
        let wires: Vec<Node<'_, '_>> = wires.collect();
        if wires.is_empty() {
            return match of.children().find(Node::is_element) {
                Some(_) => self.written(transition, of, negated, to, found),
                None => self.lacks(transition, NOTHING.into(), found),
            };
        }
        let mut wired = Wired::new(self, body, found);
        let Some(said) = wired.condition(&wires) else {
            return;
        };
        to.piece(if negated { ":= NOT (" } else { ":= " }, transition.at);
        for (piece, at) in said {
            to.piece(&piece, at);
        }
        to.piece(if negated { ");" } else { ";" }, transition.at);
    }

    fn lacks(&self, transition: &Transition<'_, '_>, what: Word, found: &mut Found) {
        let (who, at) = (transition.who.clone(), transition.at);
        tell(found, Code::XmlCondition, who, at, [what]);
    }

    /// A condition in a language of its own.
    fn written(
        &mut self,
        transition: &Transition<'a, 'x>,
        of: Node<'a, 'x>,
        negated: bool,
        to: &mut Text,
        found: &mut Found,
    ) {
        let Some(body) = of.children().find(Node::is_element) else {
            return self.lacks(transition, NOTHING.into(), found);
        };
        let at = transition.at;
        match body.tag_name().name() {
            "ST" => {
                let written = text(body);
                let written = written.trim();
                if written.trim_matches([':', '=', ';', ' ']).is_empty() {
                    return self.lacks(transition, NOTHING.into(), found);
                }
                let assigns = written.starts_with(":=");
                if negated && assigns {
                    return self.lacks(transition, "NOT :=".into(), found);
                }
                to.piece(if assigns { "" } else { ":= " }, at);
                to.piece(if negated { "NOT (" } else { "" }, at);
                to.body(self.xml, body);
                // After a comment that ends with its line.
                to.piece(if negated { "\n)" } else { "\n" }, at);
                to.piece(if written.ends_with(';') { "" } else { ";" }, at);
            }
            "IL" => {
                let role = Role {
                    code: Code::XmlCondition,
                    who: transition.who.clone().into(),
                };
                let (unit, globals) = (self.unit(&[]), self.globals);
                let said = st::list::expression(self.xml, (&unit, role), body, globals, found);
                to.piece(if negated { ":= NOT (" } else { ":= (" }, at);
                for (piece, at) in said.into_iter().flatten() {
                    to.piece(&piece, at);
                }
                to.piece(");", at);
            }
            "LD" | "FBD" => {
                let name = reference(transition.node).unwrap_or_default().to_owned();
                let mut wired = Wired::new(self, body, found);
                let Some(said) = wired.coil(&name) else {
                    return;
                };
                to.piece(if negated { ":= NOT (" } else { ":= (" }, at);
                for (piece, at) in said {
                    to.piece(&piece, at);
                }
                to.piece(");", at);
            }
            other => self.lacks(transition, in_language(other), found),
        }
    }
}

const NOTHING: (&str, &str) = ("an empty body", "um corpo vazio");
