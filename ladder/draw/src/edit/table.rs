//! The symbol table: what the points of a program are called, and what they are for.

use crate::Names;
use std::collections::BTreeMap;
use unoclp_point::Address;

/// What points are called, and what they are for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table(BTreeMap<Address, Row>);

/// What a point is called, and what it is for; either may be empty, but not both.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// Its name.
    pub name: String,
    /// What it is for.
    pub comment: String,
}

impl Table {
    /// A table of names alone.
    pub fn of(names: Names) -> Table {
        let mut table = Table::default();
        for (point, name) in names {
            let comment = String::new();
            table.set(point, Row { name, comment });
        }
        table
    }

    /// What is said of a point.
    pub fn get(&self, point: Address) -> Option<&Row> {
        self.0.get(&point)
    }

    /// The point with this name.
    pub fn point(&self, name: &str) -> Option<Address> {
        let named = |row: &Row| row.name == name;
        self.0
            .iter()
            .find_map(|(point, row)| named(row).then_some(*point))
    }

    /// Its rows, in the order of the points.
    pub fn rows(&self) -> impl Iterator<Item = (Address, &Row)> {
        self.0.iter().map(|(point, row)| (*point, row))
    }

    /// The names, for a drawing.
    pub fn names(&self) -> Names {
        let named = self.0.iter().filter(|(_, row)| !row.name.is_empty());
        named
            .map(|(point, row)| (*point, row.name.clone()))
            .collect()
    }

    /// Says this of a point, in place of what was said; an empty row says nothing.
    pub(crate) fn set(&mut self, point: Address, row: Row) {
        if row == Row::default() {
            self.0.remove(&point);
        } else {
            self.0.insert(point, row);
        }
    }

    /// Gives the rows to other points; those to none are lost.
    pub(crate) fn renamed(&self, to: impl Fn(Address) -> Option<Address>) -> Table {
        let rows = self.0.iter();
        Table(
            rows.filter_map(|(point, row)| Some((to(*point)?, row.clone())))
                .collect(),
        )
    }
}
