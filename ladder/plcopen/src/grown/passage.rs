//! What stands for an output of an element once the element is gone: the wires to the input that goes on there.
//!
//! Power passes from EN to ENO, and to an output that is a truth; the value before a block to its first output. Nothing
//! stands for the others, such as the number of a counter.

use super::sheet::{Sheet, connection};
use super::signature::signature;
use crate::xml::{all, first};
use roxmltree::Node;

/// The inputs whose wires lead on.
pub(super) struct Passage<'a, 'x> {
    /// To ENO.
    enabled: Option<Node<'a, 'x>>,
    /// To the output that goes on.
    main: Option<Node<'a, 'x>>,
    /// The name of that output; none: each.
    output: Option<String>,
}

/// A wire that leads on.
pub(super) struct Led<'a> {
    /// The element that it comes from.
    pub from: &'a str,
    pub wire: String,
}

impl<'a, 'x: 'a> Passage<'a, 'x> {
    /// That of an element.
    pub(super) fn of(
        sheet: &Sheet<'_, 'a, 'x>,
        root: Node<'_, '_>,
        node: Node<'a, 'x>,
    ) -> Passage<'a, 'x> {
        if node.tag_name().name() != "block" {
            return Passage {
                enabled: None,
                main: sheet.power(node),
                output: None,
            };
        }
        let pins = first(node, "inputVariables").into_iter();
        let pins: Vec<_> = pins.flat_map(|list| all(list, "variable")).collect();
        let is = |pin: &Node<'_, '_>, name: &str| {
            let own = pin.attribute("formalParameter").unwrap_or_default();
            own.eq_ignore_ascii_case(name)
        };
        let named = |name: &str| {
            let pin = pins.iter().find(|pin| is(pin, name))?;
            first(*pin, "connectionPointIn")
        };
        let enabled = named("EN");
        let kind = node.attribute("typeName").unwrap_or_default();
        let signature = signature(root, kind, sheet.is_blocks);
        let main = match &signature {
            Some(own) if own.gives_truth && enabled.is_some() => enabled,
            Some(own) if own.takes.is_some() => own.takes.as_deref().and_then(named),
            // Nobody knows the block.
            _ => {
                let first_value = pins.iter().find(|pin| !is(pin, "EN"));
                first_value.and_then(|pin| first(*pin, "connectionPointIn"))
            }
        };
        let outputs = signature.map_or(Vec::new(), |own| own.outputs);
        let mut outputs = outputs.into_iter().filter(|name| name != "ENO");
        let output = outputs.next().filter(|_| outputs.next().is_some());
        Passage {
            enabled,
            main,
            output,
        }
    }

    /// The wires that stand for one from the element.
    pub(super) fn before(&self, wire: Node<'_, '_>) -> Vec<Led<'a>> {
        let name = wire.attribute("formalParameter").unwrap_or_default();
        let goes_on = self.output.as_deref();
        let pin = match name {
            name if name.eq_ignore_ascii_case("ENO") => self.enabled,
            name if name.is_empty() || goes_on.is_none_or(|own| own.eq_ignore_ascii_case(name)) => {
                self.main
            }
            _ => None,
        };
        let wires = pin.into_iter().flat_map(|pin| all(pin, "connection"));
        let led = wires.filter_map(|wire| {
            let of = |name| wire.attribute(name).filter(|said| !said.is_empty());
            let from = of("refLocalId")?;
            let wire = connection(from, of("formalParameter"));
            Some(Led { from, wire })
        });
        led.collect()
    }
}
