//! What may be written by name.

use crate::grant::Grant;
use crate::keys::{At, Keys};
use crate::mistake::Wrong;
use crate::points::{Point, own};
use crate::site::Board;
use unoclp_modbus::map::{coil, holding};

const EXAMPLE: &str = "[\"estufa.alvo\"]";
/// As many names as are listed to somebody who looks for one.
const LISTED: usize = 12;

/// Those that the key `write` lists.
pub(crate) fn grants(keys: &Keys<'_>, boards: &[&Board]) -> Vec<Grant> {
    let texts = keys.texts("write", EXAMPLE).into_iter();
    let grants = texts.filter_map(|At { value, place }| match grant(&value, boards) {
        Ok(grant) => Some(grant),
        Err(wrong) => {
            keys.notes.wrong(&place, wrong);
            None
        }
    });
    grants.collect()
}

fn grant(path: &str, boards: &[&Board]) -> Result<Grant, Wrong> {
    let Some((board_name, point_name)) = path.split_once('.') else {
        let given = path.to_owned();
        return Err(Wrong::NoPath { given });
    };
    let is = |board: &&&Board| board.name.eq_ignore_ascii_case(board_name);
    let Some(board) = boards.iter().find(is) else {
        let names: Vec<_> = boards.iter().map(|board| &*board.name).collect();
        return Err(Wrong::NoSuchBoard {
            name: board_name.to_owned(),
            known: names.join(", "),
        });
    };
    let of_program = board.points.named(point_name).cloned();
    let while_kept = board.points.program.filter(|_| of_program.is_some());
    let Some(Point {
        name, kind, write, ..
    }) = of_program.or_else(|| own(&board.points.board, point_name))
    else {
        return Err(Wrong::NoSuchPoint {
            board: board.name.clone(),
            point: point_name.to_owned(),
            known: writable(board),
        });
    };
    if write.is_empty() {
        return Err(Wrong::ReadOnly {
            point: point_name.to_owned(),
            known: writable(board),
        });
    }
    Ok(Grant {
        unit: board.unit,
        name: path.to_owned(),
        point: name,
        kind,
        places: write,
        while_kept,
    })
}

/// The names that can be written, the program's before those that every board has.
fn writable(board: &Board) -> String {
    let named = board.points.named.iter();
    let named = named.filter(|point| !point.write.is_empty());
    let mut names: Vec<&str> = named.map(|point| &*point.name).take(LISTED).collect();
    let own = [
        ('Q', coil::OUTPUTS),
        ('M', coil::MARKERS),
        ('D', holding::REGISTERS),
        ('T', holding::TIMERS),
        ('C', holding::COUNTERS),
    ];
    let own = own.map(|(kind, span)| {
        let last = span.on(&board.points.board).values;
        format!("{kind}1–{kind}{last}")
    });
    names.extend(own.iter().map(|range| &**range));
    names.join(", ")
}
