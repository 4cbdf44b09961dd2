//! The whole drawing as one picture.

use super::blocks::Diagram;
use super::node::Node;
use super::page::{Font, Page, titled};
use super::{COLUMN, GAP, MARGIN, MILLIMETRES};
use crate::listing::{Title, heading, wrapped};
use crate::{Drawing, Ladder, Names, Style};
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
    let mut page = Page::new(drawing.ladder(), drawing.width, MARGIN);
    page.about(about);
    drawn(page, drawing, map, names, title, about)
}

/// The same without a heading, for a place that says what it is.
pub fn to_picture(
    drawing: &Drawing<'_>,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    about: &str,
) -> String {
    let page = Page::new(drawing.ladder(), drawing.width, MARGIN);
    drawn(page, drawing, map, names, title, about)
}

/// The rungs on this page, under their titles.
fn drawn<'p>(
    mut page: Page<'p>,
    drawing: &'p Drawing<'p>,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    about: &str,
) -> String {
    for (index, picture) in drawing.rungs.iter().enumerate() {
        page.headed(
            &heading(drawing.headed(), map, names, title, index),
            picture,
        );
    }
    written(page, drawing.width, about)
}

/// The same as block diagrams.
pub fn to_svg_of_blocks(
    ladder: &Ladder,
    style: &Style<'_>,
    map: &SourceMap,
    title: Title<'_>,
    about: &str,
) -> String {
    let (diagrams, columns) = Diagram::all(ladder, style);
    let mut page = Page::new(ladder, columns, MARGIN);
    page.about(about);
    for (index, diagram) in diagrams.iter().enumerate() {
        let heading = heading((ladder, columns), map, style.names, title, index);
        page.headed_blocks(&heading, diagram);
    }
    written(page, columns, about)
}

impl Page<'_> {
    /// What a program is about, above its rungs.
    fn about(&mut self, about: &str) {
        let columns = (self.width as f32 * COLUMN / TITLE_LETTER) as usize;
        for line in wrapped(about, columns) {
            self.text(MARGIN, self.y + 16.0, &line, &Font::TITLE);
            self.y += TITLE_ROW;
        }
        self.y += 40.0 - TITLE_ROW;
    }
}

/// A page as a document.
fn written(page: Page<'_>, columns: usize, about: &str) -> String {
    let width = columns as f32 * COLUMN + 2.0 * MARGIN;
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
