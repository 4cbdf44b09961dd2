//! Rectangles of characters that are put beside each other along a wire.

use crate::power::{Net, Power};
use unicode_width::UnicodeWidthChar;

/// A character of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The character, with light lines. NUL right after one that is two columns wide.
    pub ch: char,
    /// The net that it belongs to; none for names, notes and blanks.
    pub net: Option<Net>,
    /// The index of the element whose symbol it is part of.
    pub element: Option<usize>,
    /// Whether this column is repeated until the row is as long as it shall be.
    pub(crate) stretches: bool,
}

impl Cell {
    pub(crate) const BLANK: Cell = Cell::new(' ', None);

    pub(crate) const fn new(ch: char, net: Option<Net>) -> Cell {
        Cell {
            ch,
            net,
            element: None,
            stretches: false,
        }
    }

    pub(crate) const fn wire(net: Net) -> Cell {
        Cell::new('─', Some(net))
    }

    /// The character as it is drawn with this power, and whether it carries some.
    pub fn shown(self, power: &Power) -> (char, bool) {
        let on = self.net.is_some_and(|net| power.at(net));
        (if on { self.heavy() } else { self.ch }, on)
    }

    /// The character with heavy lines. Of contacts only the wire is heavy.
    fn heavy(self) -> char {
        match self.ch {
            '├' if self.element.is_some() => '┝',
            '┤' if self.element.is_some() => '┥',
            '─' => '━',
            '│' => '┃',
            '┌' => '┏',
            '┐' => '┓',
            '└' => '┗',
            '┘' => '┛',
            '┬' => '┳',
            '┴' => '┻',
            '├' => '┣',
            '┤' => '┫',
            other => other,
        }
    }
}

/// Rows of cells, one of which is in line with the wire.
#[derive(Clone, Debug, Default)]
pub(crate) struct Block {
    pub(crate) rows: Vec<Vec<Cell>>,
    /// The row of the wire.
    pub(crate) axis: usize,
    /// Cells of the longest row.
    pub(crate) width: usize,
}

impl Block {
    /// A block of one row.
    pub(crate) fn row(cells: Vec<Cell>) -> Block {
        Block {
            width: cells.len(),
            rows: vec![cells],
            axis: 0,
        }
    }

    /// A wire of this length.
    pub(crate) fn wire(length: usize, net: Net) -> Block {
        Block::row(vec![Cell::wire(net); length])
    }

    /// Text that belongs to a net.
    pub(crate) fn text(text: &str, net: Net) -> Block {
        Block::row(cells(text, Some(net), None))
    }

    /// Puts another block after this one, the wires in line.
    pub(crate) fn append(&mut self, other: Block) {
        if self.rows.is_empty() {
            *self = other;
            return;
        }
        let above = other.axis.saturating_sub(self.axis);
        self.rows.splice(0..0, vec![Vec::new(); above]);
        self.axis += above;
        let top = self.axis - other.axis;
        if self.rows.len() < top + other.rows.len() {
            self.rows.resize(top + other.rows.len(), Vec::new());
        }
        for (row, more) in self.rows[top..].iter_mut().zip(other.rows) {
            row.resize(self.width, Cell::BLANK);
            row.extend(more);
        }
        self.width += other.width;
    }

    /// Makes all rows as long as the longest.
    pub(crate) fn square(&mut self) {
        for row in &mut self.rows {
            row.resize(self.width, Cell::BLANK);
        }
    }

    /// Makes the block this wide, by wire in line with its own.
    pub(crate) fn lengthen(&mut self, width: usize, net: Net) {
        if let Some(more @ 1..) = width.checked_sub(self.width) {
            self.append(Block::wire(more, net));
        }
    }

    /// Puts another block below this one; gives the row of its wire.
    pub(crate) fn stack(&mut self, other: Block) -> usize {
        let axis = self.rows.len() + other.axis;
        if self.rows.is_empty() {
            self.axis = axis;
        }
        self.rows.extend(other.rows);
        self.width = self.width.max(other.width);
        axis
    }

    /// The cell of a row, which is made long enough.
    pub(crate) fn set(&mut self, row: usize, column: usize, cell: Cell) {
        if let Some(row) = self.rows.get_mut(row) {
            if row.len() <= column {
                row.resize(column + 1, Cell::BLANK);
            }
            row[column] = cell;
        }
        self.width = self.width.max(column + 1);
    }
}

/// The cells of a text.
pub(crate) fn cells(text: &str, net: Option<Net>, element: Option<usize>) -> Vec<Cell> {
    let mut cells = Vec::new();
    for ch in text.chars() {
        let width = ch.width().unwrap_or(0);
        let cell = |ch| Cell {
            element,
            ..Cell::new(ch, net)
        };
        if width > 0 {
            cells.push(cell(ch));
        }
        if width > 1 {
            cells.push(cell('\0'));
        }
    }
    cells
}
