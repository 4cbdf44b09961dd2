//! What a board's names make: how a point of it is written, and the panel that it has without a file.

use crate::grant::Grant;
use crate::panel::{Item, Look, Panel, plain};
use crate::points::{Point, Points};
use crate::site::{Board, Line};
use unoclp_modbus::map::Width;

/// How a point of a board is written; none where it cannot be.
pub(crate) fn grant(board: &Board, point: &Point, is_named: bool) -> Option<Grant> {
    (!point.write.is_empty()).then(|| Grant {
        unit: board.unit,
        name: format!("{}.{}", board.name, point.name),
        point: point.name.clone(),
        kind: point.kind,
        places: point.write.clone(),
        while_kept: board.points.program.filter(|_| is_named),
    })
}

/// The panel of a board that its names make: a lamp for each bit, a number for each value. What the program never
/// computes cannot be known here, so nothing of it writes.
fn made(board: &Board) -> Panel {
    let Points { named, .. } = &board.points;
    let item = |point: Point| Item {
        look: match point.read.width {
            Width::Bit => Look::Lamp,
            _ => Look::Value,
        },
        board: board.name.clone(),
        label: plain(&point.name),
        point: point.name,
        unit: String::new(),
        range: [0.0, 100.0],
        at: None,
        size: [1, 1],
        grant: None,
    };
    Panel {
        name: board.name.clone(),
        title: plain(&board.name),
        columns: 4,
        drawing: None,
        items: board
            .points
            .recorded(!named.is_empty())
            .into_iter()
            .map(item)
            .collect(),
        binds: Vec::new(),
        is_made: true,
    }
}

/// The panels that boards have without a file: of each board whose name no file's panel has.
pub(crate) fn made_for(lines: &[Line], panels: &[Panel]) -> Vec<Panel> {
    let boards = lines.iter().flat_map(|line| &line.boards);
    let is_free = |board: &&Board| {
        !panels
            .iter()
            .any(|panel| panel.name.eq_ignore_ascii_case(&board.name))
    };
    boards.filter(is_free).map(made).collect()
}
