//! The drawing on pages of paper, for a report: a title, lines for a name and a date, the rungs, and all points with the
//! rungs that they stand in.
//!
//! Owns where everything stands on paper; a rung is never on two pages. Must not know what its words are.
//!
//! On a page everything is in millimetres; a rung is a group `rung` of its own, scaled.

mod paper;
mod points;

use super::page::{Page, titled};
use super::{COLUMN, GAP, MARGIN, MILLIMETRES};
use crate::listing::{Title, heading};
use crate::{Drawing, Names};
use paper::{Leaf, SMALL, TITLE, lines};
use svg::Document;
use unoclp_checked::SourceMap;

pub use paper::Paper;

/// What stands on the pages beside the drawing.
pub struct Report<'r> {
    /// What they are printed on.
    pub paper: Paper,
    /// At the head of the first page, and small at that of the others.
    pub title: &'r str,
    /// At the foot of all: the file.
    pub file: &'r str,
    /// Before the line for a name.
    pub name: &'r str,
    /// Before the line for a date.
    pub date: &'r str,
    /// Over the points: what the table is, and what its columns are: a point, its name, its rungs.
    pub points: [&'r str; 4],
    /// Which page of how many.
    pub page: &'r dyn Fn(usize, usize) -> String,
}

/// Between a heading and what is under it, and between two rungs, millimetres.
const SPACE: f32 = 5.0;

/// The most lines of a title.
const LINES: usize = 4;

/// The drawing as SVG documents, each a page.
pub fn to_report(
    drawing: &Drawing<'_>,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    report: &Report<'_>,
) -> Vec<String> {
    let paper = report.paper;
    let mut leaves = vec![first(report)];
    for (index, picture) in drawing.rungs.iter().enumerate() {
        let mut page = Page::new(drawing, 0.0, false);
        page.headed(&heading(drawing, map, names, title, index), picture);
        let wide = (drawing.width as f32 * COLUMN).max(1.0);
        let high = (page.y - GAP).max(1.0);
        let scale = MILLIMETRES.min(paper.room().0 / wide);
        let leaf = open(&mut leaves, report, high * scale);
        // What is too high for a page goes on one all the same, smaller.
        let scale = scale.min(leaf.room(paper) / high);
        let (x, y) = (paper.margin() - MARGIN * scale, leaf.y);
        let place = format!("matrix({scale:.5},0,0,{scale:.5},{x:.3},{y:.3})");
        let rung = page.group.set("class", "rung");
        leaf.add(rung.set("data-rung", index + 1).set("transform", place));
        leaf.y += high * scale + SPACE;
    }
    points::table(drawing, names, report, &mut leaves);
    let count = leaves.len();
    let document = |(index, leaf): (usize, Leaf)| {
        let page = (report.page)(index + 1, count);
        let (width, height) = paper.size();
        Document::new()
            .set("width", format!("{width}mm"))
            .set("height", format!("{height}mm"))
            .set("viewBox", (0.0, 0.0, width, height))
            .add(titled(report.title))
            .add(leaf.finish(paper, report.file, &page))
            .to_string()
    };
    leaves.into_iter().enumerate().map(document).collect()
}

/// The page to go on with: the last one if it has so much room, or nothing on it, and else a new one.
fn open<'l>(leaves: &'l mut Vec<Leaf>, report: &Report<'_>, high: f32) -> &'l mut Leaf {
    let fits = |leaf: &mut Leaf| leaf.empty || high <= leaf.room(report.paper);
    if !leaves.last_mut().is_some_and(fits) {
        leaves.push(next(report));
    }
    let last = leaves.len() - 1;
    &mut leaves[last]
}

/// The first page, with its head.
fn first(report: &Report<'_>) -> Leaf {
    let paper = report.paper;
    let (left, (wide, _)) = (paper.margin(), paper.room());
    let mut leaf = Leaf::new(paper.margin());
    for line in lines(report.title, TITLE.columns(wide)).iter().take(LINES) {
        leaf.text(left, leaf.y + TITLE.height, line, &TITLE);
        leaf.y += TITLE.line();
    }
    leaf.y += SPACE;
    let base = leaf.y + SMALL.height;
    let middle = left + wide * 0.62;
    leaf.blank(left, middle - SPACE, base, report.name);
    leaf.blank(middle, left + wide, base, report.date);
    leaf.y = base + 2.0 * SPACE;
    leaf
}

/// A page behind it, with the title in one line.
fn next(report: &Report<'_>) -> Leaf {
    let paper = report.paper;
    let (left, (wide, _)) = (paper.margin(), paper.room());
    let mut leaf = Leaf::new(left);
    let lines = lines(report.title, SMALL.columns(wide));
    let line = lines.first().map_or("", String::as_str);
    leaf.text(left, leaf.y + SMALL.height, line, &SMALL);
    leaf.y += SMALL.height + 2.0;
    leaf.rule(left, left + wide, leaf.y);
    leaf.y += SPACE;
    leaf
}
