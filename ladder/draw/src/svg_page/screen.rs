//! A drawing for a screen that shows it live: drawn once, then only classes and short texts change.
//!
//! - `wire nN`: the wires of net N ([`Net::number`](crate::Net::number))
//! - `element nN`: a symbol, with the net after it; `data-element` is its index, `data-steps` its steps, `data-point`
//!   what it reads or writes
//! - `value`: an empty text above a box, for what its last step has come to
//! - `rung`: a rung; `data-rung` is its number from 1, `data-lines` the lines of its text
//!
//! A style sheet says how they look; nothing here has a colour.

use super::node::Node;
use super::page::{Page, of_net};
use super::{AXIS, COLUMN, GAP, MARGIN, x};
use crate::listing::{Title, heading};
use crate::{Drawing, Element, Names, Symbol};
use unoclp_checked::SourceMap;

/// The drawing as an SVG element of a page, its rungs under their titles. `label` says what it is to who cannot see it.
pub fn to_screen(
    drawing: &Drawing<'_>,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    label: &str,
) -> String {
    let mut page = Page::new(drawing, MARGIN / 2.0, true);
    let mut all = Node::group();
    for (index, picture) in drawing.rungs.iter().enumerate() {
        page.headed(&heading(drawing, map, names, title, index), picture);
        let rung = &drawing.ladder().rungs[index];
        let mut group = std::mem::take(&mut page.group)
            .set("class", "rung")
            .set("data-rung", index + 1);
        if let Some((from, to)) = map.lines(rung.first, rung.steps) {
            group = group.set("data-lines", format!("{from}-{to}"));
        }
        all.add(group);
    }
    let width = drawing.width as f32 * COLUMN + 2.0 * MARGIN;
    let height = page.y - GAP + MARGIN;
    Node::document()
        .set("class", "ladder")
        .set("role", "img")
        .set("aria-label", label)
        .set("width", width)
        .set("height", height)
        .set("viewBox", (0.0, 0.0, width, height))
        .with(all)
        .written()
}

/// The group of a symbol, with the area that takes clicks on it.
pub(super) fn named(
    element: &Element,
    index: usize,
    symbol: Node,
    (from, to): (usize, usize),
    y: f32,
) -> Node {
    let (left, right) = (x(from as f32), x(to as f32));
    let steps: Vec<String> = element.steps.iter().map(usize::to_string).collect();
    let area = Node::rectangle()
        .set("class", "area")
        .set("x", left)
        .set("y", y - AXIS)
        .set("width", right - left)
        .set("height", AXIS + 13.0);
    let mut group = symbol
        .set("class", of_net("element", element.net.number()))
        .set("data-element", index)
        .set("data-steps", steps.join(" "));
    if let Some(point) = element.point {
        group = group.set("data-point", point.to_string());
    }
    if matches!(element.symbol, Symbol::Box { .. }) {
        let value = Node::text("")
            .set("class", "value")
            .set("x", (left + right) / 2.0)
            .set("y", y - 15.0);
        group.add(value);
    }
    group.with(area)
}
