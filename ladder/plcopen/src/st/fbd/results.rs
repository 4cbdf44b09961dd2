//! Results of functions in a diagram.

use super::super::Body;
use super::super::functions::{place_of, sign};
use super::super::sentences::{Piece, inverted, piece};
use super::super::what::What;
use super::grouped;
use crate::found::span;
use crate::ways::Ways;
use unoclp_lang::Code;
use unoclp_lang::typed::usual;

/// Functions of as many inputs as one likes, which go without those that nothing leads to.
const MANY: [&str; 5] = ["ADD", "MUL", "AND", "OR", "XOR"];

impl<'a, 'x: 'a> Body<'_, 'a, 'x> {
    /// Whether the result of a function has to be in a variable: it is taken more than once, or other than right
    /// after it is computed.
    pub(super) fn is_result_kept(&self, at: usize) -> bool {
        if !self.own[at].is_function() {
            return false;
        }
        let network = self.network;
        let element = &network.elements[at];
        let mut readers = network.readers[at].iter();
        let is_late = |by: usize| {
            let by = &network.elements[by];
            by.kind == "connector" || by.kind == "block" && by.order.is_some()
        };
        let is_enabled = !element.wires("EN").is_empty();
        let is_stored = |by: usize| network.elements[by].kind == "outVariable";
        self.circles[at]
            || self.shares
            || element.order.is_some()
            || readers.len() > 1
            || readers.any(|by| {
                is_late(by.at) || is_enabled && !is_stored(by.at) || !self.is_result(by.output, at)
            })
    }

    /// Whether an output of a function is its result, and no further one.
    pub(super) fn is_result(&self, output: &str, at: usize) -> bool {
        let name = self.network.elements[at].block();
        let first = self.network.elements[at].outputs.iter();
        let mut first = first.map(|(name, _)| *name);
        let first = first.find(|name| !name.eq_ignore_ascii_case("ENO"));
        output.is_empty()
            || output.eq_ignore_ascii_case("OUT")
            || output.eq_ignore_ascii_case(&name)
            || self.own[at] != What::Own && first == Some(output)
    }

    /// A function of what leads to its inputs; its further outputs go to these variables.
    pub(super) fn function_of(
        &mut self,
        at: usize,
        further: &[(&str, String)],
    ) -> Option<Vec<Piece>> {
        let network = self.network;
        let element = &network.elements[at];
        let place = span(element.node);
        let name = element.node.attribute("typeName").unwrap_or_default();
        let usual = usual(&element.block()).to_owned();
        let is_own = self.own[at] == What::Own;
        let pins = element.inputs.iter();
        let pins = pins.filter(|pin| !pin.name.eq_ignore_ascii_case("EN"));
        let wired = pins.clone().filter(|pin| !pin.wires.is_empty()).count();
        let is_loose = is_own || MANY.contains(&&*usual) && wired > 1;
        let mut pins: Vec<&str> = pins
            .filter(|pin| !is_loose || !pin.wires.is_empty())
            .map(|pin| pin.name)
            .collect();
        if !is_own {
            pins.sort_by_key(|pin| place_of(pin));
        }
        if pins.is_empty() && !is_own {
            self.tell(Code::XmlPin, at, ["IN".into()]);
            return None;
        }
        let sign = if is_own {
            None
        } else {
            sign(&usual, pins.len())
        };
        let mut values = Vec::with_capacity(pins.len());
        for pin in pins {
            let mut value = grouped(self.led(at, pin)?, sign.is_some());
            if is_own {
                value.insert(0, piece(&format!("{pin} := "), place));
            }
            values.push(value);
        }
        for (output, name) in further {
            values.push(vec![piece(&format!("{output} => {name}"), place)]);
        }
        let between = sign.map_or(", ".to_owned(), |sign| format!(" {sign} "));
        let mut said = match sign {
            Some("NOT") => return Some(inverted(values.concat(), place)),
            Some(_) => vec![piece("(", place)],
            None => vec![piece(&format!("{name}("), place)],
        };
        for (index, value) in values.into_iter().enumerate() {
            if index > 0 {
                said.push(piece(&between, place));
            }
            said.extend(value);
        }
        said.push(piece(")", place));
        Some(said)
    }
}
