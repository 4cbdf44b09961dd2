//! What a symbol is known by on a screen.

use super::area::Area;
use super::node::Node;
use super::page::of_net;
use crate::{Element, Rung, Symbol};

/// The group of a symbol that takes clicks there, and shows its value at this height; one with pins has it beside them.
pub(super) fn named(
    element: &Element,
    rung: &Rung,
    symbol: Node,
    area: Area,
    value: Option<f32>,
) -> Node {
    let steps = element.steps.iter().map(|step| step - rung.first);
    let steps: Vec<String> = steps.map(|step| step.to_string()).collect();
    let target = Node::rectangle()
        .set("class", "area")
        .set("x", area.x)
        .set("y", area.y)
        .set("width", area.width)
        .set("height", area.height);
    let mut group = symbol
        .set("class", of_net("element", rung.net(element.net)))
        .set("data-steps", steps.join(" "));
    if let Some(point) = element.point {
        group = group.set("data-point", point.to_string());
    }
    if let (Symbol::Box { .. }, Some(y)) = (&element.symbol, value) {
        let value = Node::text("")
            .set("class", "value")
            .set("x", area.x + area.width / 2.0)
            .set("y", y);
        group.add(value);
    }
    group.with(target)
}
