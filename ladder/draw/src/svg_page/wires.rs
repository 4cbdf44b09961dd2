//! The wires among the cells, as lines.

use super::node::data;
use super::{HALF, x};
use crate::{Cell, Net};
use std::collections::BTreeMap;

/// The wires of a rung: one path for all, or one for each net.
pub(super) struct Wires {
    by_net: bool,
    /// The data of each path, by its net; none: the right rail, or all.
    pub(super) paths: BTreeMap<Option<Net>, String>,
}

impl Wires {
    pub(super) fn new(by_net: bool) -> Wires {
        Wires {
            by_net,
            paths: BTreeMap::new(),
        }
    }

    /// The path that wires of a net belong to.
    fn key(&self, net: Option<Net>) -> Option<Net> {
        net.filter(|_| self.by_net)
    }

    fn add(&mut self, key: Option<Net>, data: &str) {
        self.paths.entry(key).or_default().push_str(data);
    }
}

/// Which ways a line goes from the middle of a cell: left, right, up, down.
pub(super) fn arms(cell: Cell) -> [bool; 4] {
    if cell.element.is_some() {
        return [false; 4];
    }
    match cell.ch {
        '─' => [true, true, false, false],
        '│' => [false, false, true, true],
        '├' => [false, true, true, true],
        '┤' => [true, false, true, true],
        '┬' => [true, true, false, true],
        '└' => [false, true, true, false],
        '┘' => [true, false, true, false],
        _ => [false; 4],
    }
}

pub(super) fn is_line(ch: char) -> bool {
    matches!(ch, '─' | '│' | '├' | '┤' | '┬' | '└' | '┘')
}

/// Whether a cell belongs to a rail and to nothing else.
pub(super) fn is_rail(cell: &Cell) -> bool {
    cell.ch == '│'
}

pub(super) fn is_text(cell: Cell) -> bool {
    cell.element.is_none() && !matches!(cell.ch, ' ' | '→') && !is_line(cell.ch)
}

/// The wires along a row, each as long as it goes on.
pub(super) fn horizontal(row: &[Cell], y: f32, wires: &mut Wires) {
    let mut begun: Option<(f32, Option<Net>)> = None;
    for (column, &cell) in row.iter().enumerate() {
        let [left, right, ..] = arms(cell);
        let (edge, middle) = (x(column as f32), x(column as f32 + 0.5));
        let key = match (cell.net, begun) {
            // The right rail: what comes to it is the wire's.
            (None, Some((_, before))) => before,
            (net, _) => wires.key(net),
        };
        let mut end = |at: f32, begun: &mut Option<(f32, Option<Net>)>| {
            if let Some((from, key)) = begun.take() {
                wires.add(key, &data(&[('M', &[from, y]), ('H', &[at])]));
            }
        };
        if begun.is_some_and(|(_, before)| before != key) {
            end(edge, &mut begun);
        }
        match (left, right) {
            (true, true) => _ = begun.get_or_insert((edge, key)),
            (true, false) => {
                begun.get_or_insert((edge, key));
                end(middle, &mut begun);
            }
            (false, right) => {
                end(edge, &mut begun);
                begun = right.then_some((middle, key));
            }
        }
    }
    if let Some((from, key)) = begun {
        let end = x(row.len() as f32);
        wires.add(key, &data(&[('M', &[from, y]), ('H', &[end])]));
    }
}

/// The wires from a row to the next.
pub(super) fn vertical(row: &[Cell], next: &[Cell], from: f32, to: f32, wires: &mut Wires) {
    for (column, (&above, &below)) in row.iter().zip(next).enumerate() {
        // A wire may also come to a box from below.
        let from = match above.element {
            Some(_) => from + HALF + 2.0,
            None => from,
        };
        if arms(below)[2] && (arms(above)[3] || above.element.is_some()) {
            let key = wires.key(below.net);
            let at = x(column as f32 + 0.5);
            wires.add(key, &data(&[('M', &[at, from]), ('V', &[to])]));
        }
    }
}
