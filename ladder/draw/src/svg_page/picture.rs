//! The whole drawing as one picture.

use super::node::Node;
use super::page::{Font, Page, titled};
use super::{COLUMN, GAP, MARGIN, MILLIMETRES};
use crate::listing::{Title, heading};
use crate::{Drawing, Names};
use unoclp_checked::SourceMap;

/// The drawing as an SVG document under the heading `about`, its rungs under their titles.
pub fn to_svg(
    drawing: &Drawing<'_>,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    about: &str,
) -> String {
    let mut page = Page::new(drawing, MARGIN);
    page.text(MARGIN, page.y + 16.0, about, &Font::TITLE);
    page.y += 40.0;
    for (index, picture) in drawing.rungs.iter().enumerate() {
        page.headed(
            &heading(drawing.headed(), map, names, title, index),
            picture,
        );
    }
    let width = drawing.width as f32 * COLUMN + 2.0 * MARGIN;
    let height = page.y - GAP + MARGIN;
    let paper = Node::rectangle()
        .set("width", width)
        .set("height", height)
        .set("fill", "#ffffff");
    Node::document()
        .set("width", format!("{:.1}mm", width * MILLIMETRES))
        .set("height", format!("{:.1}mm", height * MILLIMETRES))
        .set("viewBox", (0.0, 0.0, width, height))
        .with(titled(about))
        .with(paper)
        .with(page.group)
        .written()
}
