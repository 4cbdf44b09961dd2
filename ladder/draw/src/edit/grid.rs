//! Where the nodes of a document stand among each other, as the drawing has them before it is wrapped to a width.

use super::cursor::Cursor;
use super::document::{Document, Element, Id, Node, Series};
use super::operation::Direction;
use unoclp_core::isa::Class;

/// A place that the cursor can be at.
#[derive(Clone, Copy)]
struct Spot {
    id: Id,
    row: usize,
    column: usize,
}

impl Document {
    /// The cursor one further; where nothing is, it stays.
    pub(crate) fn moved(&self, cursor: Cursor, to: Direction) -> Cursor {
        let Some(rung) = self.rung_of(cursor.to) else {
            return cursor;
        };
        let spots = self.spots(rung);
        let here = spots.iter().find(|spot| spot.id == cursor.to).copied();
        let first = spots.first().copied();
        let next = match (here, to) {
            // The rung as a whole, or what has no place of its own.
            (None, Direction::Right) => first.map(|spot| spot.id),
            (None, Direction::Left) => Some(self.rungs[rung].id),
            (Some(here), Direction::Left) => {
                let left = nearest(&spots, |spot| {
                    let away = here.column.checked_sub(spot.column)?.checked_sub(1)?;
                    Some((spot.row != here.row, away, spot.row.abs_diff(here.row)))
                });
                Some(left.map_or(self.rungs[rung].id, |spot| spot.id))
            }
            (Some(here), Direction::Right) => nearest(&spots, |spot| {
                let away = spot.column.checked_sub(here.column)?.checked_sub(1)?;
                Some((spot.row != here.row, away, spot.row.abs_diff(here.row)))
            })
            .map(|spot| spot.id),
            (here, Direction::Up) => here
                .and_then(|here| {
                    nearest(&spots, |spot| {
                        let away = here.row.checked_sub(spot.row)?.checked_sub(1)?;
                        Some((false, away, spot.column.abs_diff(here.column)))
                    })
                })
                .map(|spot| spot.id)
                .or_else(|| self.entered(rung.wrapping_sub(1), here, true)),
            (here, Direction::Down) => here
                .and_then(|here| {
                    nearest(&spots, |spot| {
                        let away = spot.row.checked_sub(here.row)?.checked_sub(1)?;
                        Some((false, away, spot.column.abs_diff(here.column)))
                    })
                })
                .map(|spot| spot.id)
                .or_else(|| self.entered(rung + 1, here, false)),
        };
        next.map_or(cursor, Cursor::at)
    }

    /// Where the cursor comes to in another rung: its last row or its first, as near as can be.
    fn entered(&self, rung: usize, from: Option<Spot>, last: bool) -> Option<Id> {
        let id = self.rungs.get(rung)?.id;
        let Some(from) = from else {
            return Some(id);
        };
        let spots = self.spots(rung);
        let rows = spots.iter().map(|spot| spot.row).max().unwrap_or(0);
        let found = nearest(&spots, |spot| {
            let away = if last { rows - spot.row } else { spot.row };
            Some((false, away, spot.column.abs_diff(from.column)))
        });
        Some(found.map_or(id, |spot| spot.id))
    }

    fn spots(&self, rung: usize) -> Vec<Spot> {
        let mut spots = Vec::new();
        if let Some(rung) = self.rungs.get(rung) {
            series(&rung.series, 0, 0, &mut spots);
        }
        spots
    }
}

/// The spot that has the least distance, of those that have one.
fn nearest(
    spots: &[Spot],
    distance: impl Fn(&Spot) -> Option<(bool, usize, usize)>,
) -> Option<Spot> {
    let near = spots
        .iter()
        .filter_map(|spot| Some((distance(spot)?, *spot)));
    near.min_by_key(|(distance, _)| *distance)
        .map(|(_, spot)| spot)
}

/// The spots of a series from this row and column on; gives the rows and columns that it takes.
fn series(nodes: &Series, row: usize, column: usize, spots: &mut Vec<Spot>) -> (usize, usize) {
    let (mut top, mut right, mut rows, mut widest) = (row, column, 1, column);
    for node in nodes {
        let id = node.id();
        match node {
            Node::Element(element) => {
                spots.push(Spot {
                    id,
                    row: top,
                    column: right,
                });
                right += 1;
                if is_output(element) && node.id() != nodes[nodes.len() - 1].id() {
                    // What follows stands below it.
                    widest = widest.max(right);
                    (top, right) = (row + rows, right - 1);
                    rows += 1;
                }
            }
            Node::Store(_) => {
                spots.push(Spot {
                    id,
                    row: top,
                    column: right,
                });
                right += 1;
            }
            Node::Parallel(parallel) => {
                let (mut below, mut behind) = (top, right);
                for path in &parallel.paths {
                    let (more, width) = self::path(path, below, right, spots);
                    below += more;
                    behind = behind.max(right + width);
                }
                rows = rows.max(below - row);
                right = behind;
            }
            Node::Block(block) => {
                // Its box stands where its path, below, comes to it.
                let below = row + rows;
                let (more, width) = self::path(&block.path, below, column, spots);
                rows += more;
                right = right.max(column + width);
                spots.push(Spot {
                    id,
                    row: top,
                    column: right,
                });
                right += 1;
            }
        }
    }
    (rows, widest.max(right) - column)
}

fn path(
    path: &super::document::Path,
    row: usize,
    column: usize,
    spots: &mut Vec<Spot>,
) -> (usize, usize) {
    if path.series.is_empty() {
        let id = path.id;
        spots.push(Spot { id, row, column });
        return (1, 1);
    }
    series(&path.series, row, column, spots)
}

/// Whether what follows it may stand on a branch of its own.
fn is_output(element: &Element) -> bool {
    matches!(
        element.step.class(),
        Class::Coil | Class::Leave | Class::Timer
    )
}
