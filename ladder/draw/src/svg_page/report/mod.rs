//! The drawing on pages of paper, for a report: a title, lines for a name and a date, the rungs, and all points with the
//! rungs that they stand in.
//!
//! Owns where everything stands on paper; a rung is never on two pages. Must not know what its words are.
//!
//! On a page everything is in millimetres; a rung is a group `rung` of its own, scaled.

mod pages;
mod paper;
mod points;

use super::page::Page;
use super::{COLUMN, GAP, MARGIN, MILLIMETRES};
use crate::listing::{Title, heading};
use crate::{Drawing, Names};
use pages::{Pages, SPACE};
use unoclp_checked::SourceMap;

pub use pages::Report;
pub use paper::Paper;

/// The drawing as SVG documents, each a page.
pub fn to_report(
    drawing: &Drawing<'_>,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    report: &Report<'_>,
) -> Vec<String> {
    let paper = report.paper;
    let mut pages = Pages::new(report);
    for (index, picture) in drawing.rungs.iter().enumerate() {
        let mut page = Page::new(drawing.ladder(), drawing.width, 0.0);
        page.headed(
            &heading(drawing.headed(), map, names, title, index),
            picture,
        );
        let wide = (drawing.width as f32 * COLUMN).max(1.0);
        let high = (page.y - GAP).max(1.0);
        let scale = MILLIMETRES.min(paper.room().0 / wide);
        let leaf = pages.open(high * scale);
        // What is too high for a page goes on one all the same, smaller.
        let scale = scale.min(leaf.room(paper) / high);
        let (x, y) = (paper.margin() - MARGIN * scale, leaf.y);
        let place = format!("matrix({scale:.5},0,0,{scale:.5},{x:.3},{y:.3})");
        let rung = page.group.set("class", "rung");
        leaf.add(rung.set("data-rung", index + 1).set("transform", place));
        leaf.y += high * scale + SPACE;
    }
    points::table(drawing, names, &mut pages);
    pages.finish()
}
