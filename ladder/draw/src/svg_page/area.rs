//! Where something stands on a sheet.

use super::{AXIS, TEXT_ROW, WIRE_ROW, x};

/// A rectangle of a sheet, in its units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Its left edge.
    pub x: f32,
    /// Its upper edge.
    pub y: f32,
    /// Its width.
    pub width: f32,
    /// Its height.
    pub height: f32,
}

impl Area {
    /// That of a symbol between two columns, whose wire is at this height.
    pub(super) fn of_symbol((from, to): (usize, usize), wire: f32) -> Area {
        let (left, right) = (x(from as f32), x(to as f32));
        Area {
            x: left,
            y: wire - AXIS,
            width: right - left,
            height: WIRE_ROW,
        }
    }

    /// That of a box with pins, from its address in the row above to its last row of pins.
    pub(super) fn of_box(columns: (usize, usize), wire: f32, last: f32) -> Area {
        let symbol = Area::of_symbol(columns, wire);
        let y = symbol.y - TEXT_ROW + 2.0;
        Area {
            y,
            height: last + TEXT_ROW / 2.0 - y,
            ..symbol
        }
    }
}
