//! The points of the board, by their addresses.

use super::builder::Builder;
use super::named::Traits;
use crate::{Base, Cell, Expr, Index, Place, Root, TypeId, Value};
use std::collections::BTreeSet;
use unoclp_core::Board;
use unoclp_point::{Address, Maker};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_text::points;

/// What the cell of a point holds.
pub fn point_base(point: Address) -> Base {
    match point {
        _ if point.is_bit() => Base::Bool,
        Address::Register(_) => Base::Dint,
        Address::Group(_) | Address::Inputs(_) | Address::Outputs(_) => Base::Usint,
        _ => Base::Int,
    }
}

/// The bits of a point that is eight bits as one number, the lowest first, as far as the board has them.
pub fn bits_of(point: Address, board: Board) -> Vec<Address> {
    let bit: fn(u8) -> Address = match point {
        Address::Group(_) => Address::Marker,
        Address::Inputs(_) => Address::Input,
        Address::Outputs(_) => Address::Output,
        _ => return Vec::new(),
    };
    let first = match point {
        Address::Group(number) => number.saturating_sub(1).saturating_mul(8),
        _ => 0,
    };
    let most = match point {
        Address::Group(_) => board.markers,
        Address::Inputs(_) => board.inputs,
        _ => board.outputs,
    };
    let numbers = (1..=8).map(|number: u8| first.saturating_add(number));
    numbers.filter(|number| *number <= most).map(bit).collect()
}

impl Builder<'_, '_> {
    /// The cell of a point that begins as its variable of this type does.
    pub(super) fn point_with(&mut self, point: Address, ty: TypeId, traits: &Traits) -> u32 {
        let offset = self.point(point);
        let first = self.initial_cells(ty, traits).into_iter().next();
        let first = first.filter(|first| {
            point.is_written()
                && (traits.initial.is_some() || first.initial != Value::zero(first.base))
        });
        if let Some(cell) = self.tree.cells.get_mut(offset as usize) {
            if let Some(first) = first {
                (cell.base, cell.initial) = (first.base, first.initial);
            }
            cell.retain |= traits.retain;
        }
        offset
    }

    /// The cell of a point.
    pub fn point(&mut self, point: Address) -> u32 {
        if let Some(&cell) = self.points.get(&point) {
            return cell;
        }
        let cell = self.tree.cells.len() as u32;
        let base = point_base(point);
        self.tree.cells.push(Cell {
            base,
            initial: Value::zero(base),
            retain: false,
            scratch: false,
        });
        self.tree.points.push((cell, point));
        self.points.insert(point, cell);
        // What is read and written as one number is so bit by bit too.
        for bit in bits_of(point, self.board) {
            self.point(bit);
        }
        cell
    }

    /// Makes the registers of tables, each by its first register and how many it has, in rows. It comes before any of these
    /// registers is asked for by [`Builder::point`].
    pub fn rows(&mut self, tables: &[(u8, u8)]) {
        let all = tables
            .iter()
            .flat_map(|(first, count)| *first..first.saturating_add(*count));
        let registers: BTreeSet<u8> = all.collect();
        for register in registers {
            self.point(Address::Register(register));
        }
    }

    /// The register of a table that a subscript from 0 says; none where they do not stand in a row.
    pub fn in_table(
        &mut self,
        (first, count): (u8, u8),
        subscript: Expr,
        at: Span,
    ) -> Option<Place> {
        let offset = self.point(Address::Register(first));
        for next in 1..count {
            let cell = self.point(Address::Register(first.saturating_add(next)));
            if cell != offset + u32::from(next) {
                return None;
            }
        }
        let index = Index {
            subscript,
            low: 0,
            count: count.into(),
            stride: 1,
        };
        Some(Place {
            root: Root::Static,
            offset,
            indices: vec![index],
            at,
        })
    }

    /// The point that an address like `%IX1` names; what is wrong with it is told.
    pub fn address(&mut self, written: &str, at: Span) -> Option<Address> {
        let maker = Maker::Iec;
        let point = self.address_of(written, maker, at);
        if point.is_none() {
            let help = points::help(written, maker, self.board);
            self.tell(Code::StBadAddress, at, [written.into(), help]);
        }
        point
    }

    /// The point that an address names in a maker's way; none where a program has no such point, which is not told.
    pub fn address_of(&mut self, written: &str, maker: Maker, at: Span) -> Option<Address> {
        let mut key: String = written.to_uppercase().split_whitespace().collect();
        if let Some(moved) = self.moved.get_mut(&key) {
            // The first time that it is named, it is told.
            let (new, is_told) = moved;
            let new = new.clone();
            if !std::mem::replace(is_told, true) {
                let words = [written.into(), new.as_str().into()];
                self.tell(Code::StMoved, at, words);
            }
            key = new;
        }
        let (address, written) = points::variable(&key, maker, self.board)?;
        let here = (Code::StSamePoint, at);
        self.spellings
            .note((address, &written), here, self.text, self.found);
        Some(address)
    }

    /// The point that AT names for a variable of this type; what is wrong with it is told.
    pub fn address_for(&mut self, written: &str, ty: TypeId, at: Span) -> Option<Address> {
        let point = self.address(written, at)?;
        let base = self.tree.types.base(ty);
        let fits = match (base, point.is_bit()) {
            (Some(Base::Bool), bit) => bit,
            (Some(base), false) => {
                base.is_on_board() && !base.is_real()
                    || matches!(point, Address::Register(_)) && base.is_on_board()
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
