//! The whole drawing as one picture.

use super::node::Node;
use super::page::{Font, Page, titled};
use super::{COLUMN, GAP, MARGIN, MILLIMETRES};
use crate::listing::{Title, heading, wrapped};
use crate::{Drawing, Names};
use unoclp_checked::SourceMap;

/// From one line of the title to the next, and what a letter of it takes, on an average.
const TITLE_ROW: f32 = 24.0;
const TITLE_LETTER: f32 = 10.5;

/// The drawing as an SVG document under the heading `about`, its rungs under their titles.
pub fn to_svg(
    drawing: &Drawing<'_>,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    about: &str,
) -> String {
    let columns = (drawing.width as f32 * COLUMN / TITLE_LETTER) as usize;
    under(&wrapped(about, columns), drawing, map, names, title, about)
}

/// The same without a heading, for a place that says what it is.
pub fn to_picture(
    drawing: &Drawing<'_>,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    about: &str,
) -> String {
    under(&[], drawing, map, names, title, about)
}

/// The drawing under these lines.
fn under(
    lines: &[String],
    drawing: &Drawing<'_>,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    about: &str,
) -> String {
    let mut page = Page::new(drawing, MARGIN);
    for line in lines {
        page.text(MARGIN, page.y + 16.0, line, &Font::TITLE);
        page.y += TITLE_ROW;
    }
    if !lines.is_empty() {
        page.y += 40.0 - TITLE_ROW;
    }
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
