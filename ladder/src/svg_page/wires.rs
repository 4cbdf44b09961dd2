//! The wires among the cells, as lines.

use super::{HALF, x};
use crate::Cell;

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
pub(super) fn horizontal(row: &[Cell], y: f32, path: &mut String) {
    let mut begun: Option<f32> = None;
    for (column, &cell) in row.iter().enumerate() {
        let [left, right, ..] = arms(cell);
        let (edge, middle) = (x(column as f32), x(column as f32 + 0.5));
        let mut end = |at: f32, begun: &mut Option<f32>| {
            if let Some(from) = begun.take() {
                path.push_str(&format!("M{from} {y}H{at}"));
            }
        };
        match (left, right) {
            (true, true) => _ = begun.get_or_insert(edge),
            (true, false) => {
                begun.get_or_insert(edge);
                end(middle, &mut begun);
            }
            (false, right) => {
                end(edge, &mut begun);
                begun = right.then_some(middle);
            }
        }
    }
    if let Some(from) = begun {
        path.push_str(&format!("M{from} {y}H{}", x(row.len() as f32)));
    }
}

/// The wires from a row to the next.
pub(super) fn vertical(row: &[Cell], next: &[Cell], from: f32, to: f32, path: &mut String) {
    for (column, (&above, &below)) in row.iter().zip(next).enumerate() {
        // A wire may also come to a box from below.
        let from = match above.element {
            Some(_) => from + HALF + 2.0,
            None => from,
        };
        if arms(below)[2] && (arms(above)[3] || above.element.is_some()) {
            path.push_str(&format!("M{} {from}V{to}", x(column as f32 + 0.5)));
        }
    }
}
