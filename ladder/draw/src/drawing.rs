//! The finished drawing: rungs of cells between the rails, and the same as text.

use crate::block::{Block, Cell};
use crate::face::Face;
use crate::power::Power;
use crate::style::Style;
use crate::wrap::Wrap;
use crate::{Element, Ladder, Rung};
use std::fmt;
use unoclp_checked::Work;

/// A drawing of a ladder. All rungs are of the same width.
pub struct Drawing<'l> {
    ladder: &'l Ladder,
    /// The rungs, in order.
    pub rungs: Vec<Picture>,
    /// The columns of every row.
    pub width: usize,
    /// The columns that it might have taken.
    pub(crate) limit: usize,
}

/// A rung in cells.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The rows, from the left rail to the right.
    pub rows: Vec<Vec<Cell>>,
    /// The first row that has a wire.
    pub axis: usize,
}

impl Ladder {
    /// Draws it.
    pub fn draw(&self, style: &Style<'_>) -> Drawing<'_> {
        Drawing::new(self, style)
    }
}

impl<'l> Drawing<'l> {
    fn new(ladder: &'l Ladder, style: &Style<'_>) -> Drawing<'l> {
        Work::note(|work| work.drawings += 1);
        let lay = |rung| (rung, Laid::new(ladder, rung, style));
        let rungs: Vec<(&Rung, Laid)> = ladder.rungs.iter().map(lay).collect();
        let width = style.between_rails(rungs.iter().map(|(_, laid)| laid.width));
        let rungs = rungs.into_iter();
        Drawing {
            ladder,
            rungs: rungs
                .map(|(rung, laid)| laid.picture(rung, width))
                .collect(),
            width: width + 2,
            limit: style.limit(),
        }
    }

    /// What headings depend on: the ladder, and the columns that there are.
    pub(crate) fn headed(&self) -> (&'l Ladder, usize) {
        (self.ladder, self.limit)
    }

    /// The ladder that is drawn.
    pub fn ladder(&self) -> &'l Ladder {
        self.ladder
    }
}

/// A rung as its lines stand one below the other, before it is as wide as the others.
pub(crate) struct Laid {
    blocks: Vec<Block>,
    /// The columns that it takes between the rails.
    pub(crate) width: usize,
}

impl Laid {
    pub(crate) fn new(ladder: &Ladder, rung: &Rung, style: &Style<'_>) -> Laid {
        Work::note(|work| work.rungs += 1);
        let face = |element: &Element| Face::new(element, style.names, style.medium);
        let elements = ladder.elements.get(rung.elements.clone());
        let faces: Vec<Face> = elements.into_iter().flatten().map(face).collect();
        let wrap = Wrap {
            ladder,
            faces: (rung.elements.start, &faces),
            room: style.limit() - 2,
        };
        let lines = wrap.lines(&rung.series, rung.rail);
        let blocks: Vec<Block> = lines.iter().map(|line| wrap.layout(line)).collect();
        let width = blocks.iter().map(|block| block.width).max();
        Laid {
            blocks,
            width: width.unwrap_or(0),
        }
    }

    /// The rung in so many columns between the rails.
    pub(crate) fn picture(self, rung: &Rung, width: usize) -> Picture {
        let axis = self.blocks.first().map_or(0, |block| block.axis);
        let rows = self.blocks.into_iter().flat_map(|block| block.rows);
        let rows = rows.map(|row| between_rails(row, width, rung.rail));
        Picture {
            rows: rows.collect(),
            axis,
        }
    }
}

/// A row between the rails, stretched to this width.
fn between_rails(mut row: Vec<Cell>, width: usize, rail: crate::Net) -> Vec<Cell> {
    let more = width.saturating_sub(row.len());
    if let Some(at) = row.iter().position(|cell| cell.stretches) {
        let cell = row[at];
        row.splice(at..at, vec![cell; more]);
    }
    row.resize(width, Cell::BLANK);
    let is_wire = |cell: Option<&Cell>| cell.is_some_and(|cell| cell.ch == '─');
    let left = if is_wire(row.first()) { '├' } else { '│' };
    let right = if is_wire(row.last()) { '┤' } else { '│' };
    row.insert(0, Cell::new(left, Some(rail)));
    row.push(Cell::new(right, None));
    row
}

impl Picture {
    /// A row as text, with what carries power in heavy lines.
    pub fn row(&self, row: usize, power: &Power) -> String {
        let cells = self.rows.get(row).map_or(&[][..], |row| row);
        let cells = cells.iter().filter(|cell| cell.ch != '\0');
        cells.map(|cell| cell.shown(power).0).collect()
    }
}

impl fmt::Display for Picture {
    /// The rung as lines of text, without power.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let none = Power::default();
        for row in 0..self.rows.len() {
            writeln!(f, "{}", self.row(row, &none))?;
        }
        Ok(())
    }
}
