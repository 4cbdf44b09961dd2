//! A drawing for a screen that shows it live: drawn once, then only classes and short texts change.
//!
//! - `rung`: a rung; `data-rung` is its number from 1, `data-lines` the lines of its text, `data-nets` and `data-first` how
//!   many nets and steps there are before its own
//! - `wire nN`: the wires of net N of the rung, from 1; of the left rail, which all rungs share, `n0`
//! - `element nN`: a symbol, with the net after it; `data-steps` are its steps among those of the rung, `data-point` what it
//!   reads or writes
//! - `value`: an empty text above a box, for what its last step has come to
//! - `preset`, `count`: the texts beside the pins of a timer or a counter: its preset, and what it has come to, empty
//! - `rail n0`: the left rail, with power while the program runs; `rail`: the right one
//!
//! A style sheet says how they look; nothing here has a colour.

use super::area::Area;
use super::blocks::Diagram;
use super::node::Node;
use super::page::Page;
use super::{COLUMN, GAP, MARGIN};
use crate::listing::{Title, heading};
use crate::{Drawing, Ladder, Names, Picture, Rung, Style};
use unoclp_checked::{SourceMap, Work};

/// A rung on a screen. Nothing in it says where among others it stands: it is the same wherever that is.
pub(super) struct Strip {
    /// Its group, from its upper edge.
    pub(super) group: Node,
    /// Its height, with its heading.
    pub(super) height: f32,
    /// Where its elements are, in the order in which they are drawn.
    pub(super) areas: Vec<(usize, Area)>,
}

impl Strip {
    /// A rung of a ladder under its heading; `ids`: what its elements are known by.
    pub(super) fn new(
        (ladder, rung, width): (&Ladder, &Rung, usize),
        heading: &[String],
        picture: &Picture,
        ids: Option<&dyn Fn(usize) -> u32>,
    ) -> Strip {
        let mut page = Page::on_screen(ladder, rung, width);
        page.ids = ids;
        page.headed(heading, picture);
        Strip::drawn(page)
    }

    /// The same as blocks.
    pub(super) fn of_blocks(
        (ladder, rung): (&Ladder, &Rung),
        heading: &[String],
        diagram: &Diagram<'_>,
        ids: Option<&dyn Fn(usize) -> u32>,
    ) -> Strip {
        let mut page = Page::on_screen(ladder, rung, 0);
        page.ids = ids;
        page.headed_blocks(heading, diagram);
        Strip::drawn(page)
    }

    fn drawn(page: Page<'_>) -> Strip {
        Strip {
            group: page.group.set("class", "rung"),
            height: page.y - GAP,
            areas: page.areas,
        }
    }
}

/// The upper edge of the first rung.
pub(super) const TOP: f32 = MARGIN / 2.0;

/// The width of a drawing of so many columns, and its height where its last rung ends there.
pub(super) fn size(columns: usize, end: f32) -> (f32, f32) {
    (columns as f32 * COLUMN + 2.0 * MARGIN, end + MARGIN)
}

/// The drawing as an SVG element of a page, its rungs under their titles. `label` says what it is to who cannot see it.
pub fn to_screen(
    drawing: &Drawing<'_>,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    label: &str,
) -> String {
    let (ladder, columns) = (drawing.ladder(), drawing.width);
    let rungs = drawing.rungs.iter().zip(&ladder.rungs).enumerate();
    let strips = rungs.map(|(index, (picture, rung))| {
        let heading = heading(drawing.headed(), map, names, title, index);
        Strip::new((ladder, rung, columns), &heading, picture, None)
    });
    screen(ladder, map, label, columns, strips)
}

/// The same as block diagrams.
pub fn to_blocks(
    ladder: &Ladder,
    style: &Style<'_>,
    map: &SourceMap,
    title: Title<'_>,
    label: &str,
) -> String {
    Work::note(|work| work.drawings += 1);
    let (diagrams, columns) = Diagram::all(ladder, style);
    let rungs = ladder.rungs.iter().zip(&diagrams).enumerate();
    let strips = rungs.map(|(index, (rung, diagram))| {
        let heading = heading((ladder, columns), map, style.names, title, index);
        Strip::of_blocks((ladder, rung), &heading, diagram, None)
    });
    screen(ladder, map, label, columns + 2, strips)
}

/// Rungs one below the other.
fn screen(
    ladder: &Ladder,
    map: &SourceMap,
    label: &str,
    columns: usize,
    strips: impl Iterator<Item = Strip>,
) -> String {
    let mut all = Node::group();
    let mut top = TOP;
    let mut end = top;
    for (index, (strip, rung)) in strips.zip(&ladder.rungs).enumerate() {
        let mut group = strip
            .group
            .set("data-rung", index + 1)
            .set("data-nets", rung.nets)
            .set("data-first", rung.first)
            .set("transform", format!("translate(0,{top})"));
        if let Some((from, to)) = map.lines(rung.first, rung.steps) {
            group = group.set("data-lines", format!("{from}-{to}"));
        }
        all.add(group);
        end = top + strip.height;
        top = end + GAP;
    }
    let (width, height) = size(columns, end);
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
