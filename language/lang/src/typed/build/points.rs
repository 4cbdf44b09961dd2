//! The points of the board, by their addresses.

use super::builder::Builder;
use super::named::Traits;
use crate::address::{Address, parse};
use crate::diagnostics::{Code, Span};
use crate::dialect::Dialect;
use crate::typed::{Base, Cell, Initial, Point, TypeId, Value};
use unoclp_core::Profile;
use unoclp_core::isa::{ANALOGUE, MARKERS, REGISTERS, SYSTEM_MARKERS};

fn point_base(point: Point) -> Base {
    match point {
        Point::Register(_) => Base::Dint,
        _ => Base::Int,
    }
}

impl Builder<'_, '_> {
    /// The cell of a point that begins so.
    pub(super) fn point_with(&mut self, point: Point, traits: &Traits) -> u32 {
        let offset = self.point(point);
        if let Some(cell) = self.tree.cells.get_mut(offset as usize) {
            if let Some(Initial::Value(value)) = traits.initial.as_deref() {
                cell.initial = value.clone();
            }
            cell.retain |= traits.retain;
        }
        offset
    }

    /// The cell of a point.
    pub fn point(&mut self, point: Point) -> u32 {
        if let Some(&cell) = self.points.get(&point) {
            return cell;
        }
        let cell = self.tree.cells.len() as u32;
        let base = if point.is_bit() {
            Base::Bool
        } else {
            point_base(point)
        };
        self.tree.cells.push(Cell {
            base,
            initial: Value::zero(base),
            retain: false,
            scratch: false,
        });
        self.tree.points.push((cell, point));
        self.points.insert(point, cell);
        cell
    }

    /// The point that an address like `%IX1` names; what is wrong with it is told.
    pub fn address(&mut self, written: &str, at: Span) -> Option<Point> {
        let key: String = written.split_whitespace().collect();
        let within = |n: u32, first: u32, last: u8| (first..=u32::from(last)).contains(&n);
        let board = Profile::UNO;
        let point = match parse(&key.to_uppercase(), Dialect::Iec) {
            Some(Address::Input(n)) => Some(Point::Input(n)).filter(|_| within(n, 1, board.inputs)),
            Some(Address::Output(n)) => {
                Some(Point::Output(n)).filter(|_| within(n, 1, board.outputs))
            }
            Some(Address::Marker(n)) => Some(Point::Marker(n)).filter(|_| within(n, 1, MARKERS)),
            Some(Address::System(n)) => {
                Some(Point::System(n)).filter(|_| within(n, 1, SYSTEM_MARKERS))
            }
            Some(Address::Analogue(n)) => {
                Some(Point::Analogue(n)).filter(|_| within(n, 0, ANALOGUE - 1))
            }
            Some(Address::Pwm(n)) => Some(Point::Pwm(n)).filter(|_| [1, 4].contains(&n)),
            Some(Address::Register(n)) => {
                Some(Point::Register(n)).filter(|_| within(n, 1, REGISTERS))
            }
            _ => None,
        };
        if point.is_none() {
            self.tell(Code::StBadAddress, at, [written.into()]);
        }
        point
    }

    /// The point that AT names for a variable of this type; what is wrong with it is told.
    pub fn address_for(&mut self, written: &str, ty: TypeId, at: Span) -> Option<Point> {
        let point = self.address(written, at)?;
        let base = self.tree.types.base(ty);
        let fits = match (base, point.is_bit()) {
            (Some(Base::Bool), bit) => bit,
            (Some(base), false) => {
                base.is_on_board() && !base.is_real()
                    || matches!(point, Point::Register(_)) && base.is_on_board()
            }
            _ => false,
        };
        if fits {
            return Some(point);
        }
        let (is, takes) = match point.is_bit() {
            true => (("a bit", "um bit"), "BOOL"),
            false => (("a number", "um número"), "INT"),
        };
        let ty = self.tree.types.name(ty);
        let words = [written.into(), is.into(), ty.into(), takes.into()];
        self.tell(Code::StAddressType, at, words);
        None
    }
}
