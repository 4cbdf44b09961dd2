//! An element that goes: what led to it leads on, or its branch ends.

use super::passage::{Led, Passage};
use super::sheet::{Sheet, Sources};
use crate::bodies::body;
use crate::edges::{removed, spliced};
use crate::found::Found;
use crate::xml::{self, all};
use roxmltree::Node;

/// A project without an element of a drawn unit; what led to it leads on, but where it was a branch beside others. Values that
/// led to nothing else go too.
pub fn erase(text: &str, unit: &str, at: &str) -> Option<String> {
    let tree = xml::parse(text, &mut Found::default())?;
    let root = tree.root_element();
    let sheet = Sheet::of(text, body(root, unit)?)?;
    let node = sheet.element(at)?;
    let passage = Passage::of(&sheet, root, node);
    let sources = Sources::of(&sheet);
    let mut pieces = vec![removed(text, node)];
    let mut led = Vec::new();
    for wire in sheet.readers(at) {
        let pin = wire.parent()?;
        let before = passage.before(wire);
        // What another wire brings anyway comes once.
        let has: Vec<String> = sheet.wires(pin);
        // A branch beside others ends, where they begin alike: what led to it would go past them.
        let others = all(pin, "connection").filter(|own| own.attribute("refLocalId") != Some(at));
        let reached = sources.before(others.filter_map(|own| own.attribute("refLocalId")));
        let is_beside = |own: &Led| reached.contains(own.from) && !reached.contains(at);
        let is_more = |own: &&Led| !has.contains(&own.wire) && !is_beside(own);
        let more = before.iter().filter(is_more);
        let more: String = more.map(|own| own.wire.as_str()).collect();
        pieces.push(match more.is_empty() {
            true => removed(text, wire),
            false => (wire.range(), more),
        });
        led.extend(before.iter().map(|own| own.from));
    }
    let is_own = |wire: &Node<'_, '_>| wire.ancestors().any(|of| of == node);
    let is_lonely = |value: &Node<'_, '_>| {
        let id = value.attribute("localId").unwrap_or_default();
        let is_value = value.tag_name().name() == "inVariable" && sources.leads(id, at);
        is_value && !led.contains(&id) && sheet.readers(id).iter().all(is_own)
    };
    let values = sheet.body.children().filter(Node::is_element);
    pieces.extend(values.filter(is_lonely).map(|value| removed(text, value)));
    Some(spliced(text, pieces))
}
