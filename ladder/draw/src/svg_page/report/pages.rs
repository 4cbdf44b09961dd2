//! The pages of a report, one after another, each with its head and its foot.

use super::paper::{Leaf, Paper, SMALL, TITLE, lines};
use crate::svg_page::node::Node;
use crate::svg_page::page::titled;

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
pub(super) const SPACE: f32 = 5.0;

/// The most lines of a title.
const LINES: usize = 4;

/// The pages so far.
pub(super) struct Pages<'r> {
    pub(super) report: &'r Report<'r>,
    leaves: Vec<Leaf>,
}

impl<'r> Pages<'r> {
    /// The first page, with its head.
    pub(super) fn new(report: &'r Report<'r>) -> Pages<'r> {
        Pages {
            report,
            leaves: vec![first(report)],
        }
    }

    /// The page to go on with: the last one if it has so much room, or nothing on it, and else a new one.
    pub(super) fn open(&mut self, high: f32) -> &mut Leaf {
        let fits = |leaf: &mut Leaf| leaf.empty || high <= leaf.room(self.report.paper);
        if !self.leaves.last_mut().is_some_and(fits) {
            self.leaves.push(next(self.report));
        }
        let last = self.leaves.len() - 1;
        &mut self.leaves[last]
    }

    /// Each as an SVG document.
    pub(super) fn finish(self) -> Vec<String> {
        let (report, count) = (self.report, self.leaves.len());
        let (width, height) = report.paper.size();
        let document = |(index, leaf): (usize, Leaf)| {
            let page = (report.page)(index + 1, count);
            Node::document()
                .set("width", format!("{width}mm"))
                .set("height", format!("{height}mm"))
                .set("viewBox", (0.0, 0.0, width, height))
                .with(titled(report.title))
                .with(leaf.finish(report.paper, report.file, &page))
                .written()
        };
        self.leaves.into_iter().enumerate().map(document).collect()
    }
}

/// The first page, with its head.
fn first(report: &Report<'_>) -> Leaf {
    let paper = report.paper;
    let (left, (wide, _)) = (paper.margin(), paper.room());
    let mut leaf = Leaf::new(paper.margin());
    for line in lines(report.title, TITLE.columns(wide)).iter().take(LINES) {
        leaf.text(left, leaf.y + TITLE.height(), line, &TITLE);
        leaf.y += TITLE.line();
    }
    leaf.y += SPACE;
    let base = leaf.y + SMALL.height();
    let middle = left + wide * 0.62;
    leaf.blank(left, middle - SPACE, base, report.name);
    leaf.blank(middle, left + wide, base, report.date);
    leaf.y = base + 2.0 * SPACE;
    leaf
}

/// A page after it, with the title in one line.
fn next(report: &Report<'_>) -> Leaf {
    let paper = report.paper;
    let (left, (wide, _)) = (paper.margin(), paper.room());
    let mut leaf = Leaf::new(left);
    let lines = lines(report.title, SMALL.columns(wide));
    let line = lines.first().map_or("", String::as_str);
    leaf.text(left, leaf.y + SMALL.height(), line, &SMALL);
    leaf.y += SMALL.height() + 2.0;
    leaf.rule(left, left + wide, leaf.y);
    leaf.y += SPACE;
    leaf
}
