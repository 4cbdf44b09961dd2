//! A drawing for a screen on which it is edited: as for one that shows it live, and where everything is.
//!
//! Beside what `screen` names, a symbol and a rung have a `data-id`.

use super::area::Area;
use super::node::Node;
use super::page::Page;
use super::{COLUMN, GAP, MARGIN};
use crate::Drawing;

/// A drawing, and where everything is.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The drawing as an SVG element of a page.
    pub svg: String,
    /// All of it.
    pub area: Area,
    /// The elements of the ladder, by their index, in the order in which they are drawn.
    pub elements: Vec<(usize, Area)>,
    /// The rungs, with their headings.
    pub rungs: Vec<Area>,
}

/// What is known of a drawing that is edited.
pub struct Labels<'l> {
    /// What the elements of the ladder are known by.
    pub elements: &'l dyn Fn(usize) -> u32,
    /// What its rungs are known by.
    pub rungs: &'l dyn Fn(usize) -> u32,
    /// What stands above a rung, line by line.
    pub heading: &'l dyn Fn(usize) -> Vec<String>,
    /// What the drawing is to who cannot see it.
    pub drawing: &'l str,
}

/// The drawing as an SVG element of a page on which it is edited.
pub fn to_sheet(drawing: &Drawing<'_>, labels: &Labels<'_>) -> Sheet {
    let mut page = Page::new(drawing, MARGIN / 2.0, true);
    page.ids = Some(labels.elements);
    let width = drawing.width as f32 * COLUMN + 2.0 * MARGIN;
    let mut all = Node::group();
    let mut rungs = Vec::new();
    for (index, picture) in drawing.rungs.iter().enumerate() {
        let top = page.y;
        page.headed(&(labels.heading)(index), picture);
        rungs.push(Area {
            x: 0.0,
            y: top,
            width,
            height: page.y - GAP - top,
        });
        let group = std::mem::take(&mut page.group)
            .set("class", "rung")
            .set("data-rung", index + 1)
            .set("data-id", (labels.rungs)(index));
        all.add(group);
    }
    let height = page.y - GAP + MARGIN;
    let svg = Node::document()
        .set("class", "ladder")
        .set("role", "img")
        .set("aria-label", labels.drawing)
        .set("width", width)
        .set("height", height)
        .set("viewBox", (0.0, 0.0, width, height))
        .with(all);
    Sheet {
        svg: svg.written(),
        area: Area {
            x: 0.0,
            y: 0.0,
            width,
            height,
        },
        elements: page.areas,
        rungs,
    }
}
