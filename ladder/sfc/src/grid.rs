//! Lines of characters: where they meet, the character has an arm for each.

use crate::measure::width;

pub(crate) const UP: u8 = 1;
pub(crate) const DOWN: u8 = 2;
pub(crate) const LEFT: u8 = 4;
pub(crate) const RIGHT: u8 = 8;

/// A cell.
#[derive(Clone, Copy, Default)]
struct Cell {
    arms: u8,
    /// Whether its arms to the sides are double, and those up and down.
    across: bool,
    along: bool,
    sign: Option<char>,
    /// A wide character stands before it.
    taken: bool,
}

/// Rows of cells.
pub(crate) struct Grid {
    columns: usize,
    cells: Vec<Cell>,
}

impl Grid {
    pub(crate) fn new(columns: usize, rows: usize) -> Grid {
        Grid {
            columns,
            cells: vec![Cell::default(); columns * rows],
        }
    }

    fn cell(&mut self, x: usize, y: usize) -> Option<&mut Cell> {
        match x < self.columns {
            true => self.cells.get_mut(y * self.columns + x),
            false => None,
        }
    }

    /// Adds arms to a cell.
    pub(crate) fn arms(&mut self, x: usize, y: usize, arms: u8) {
        if let Some(cell) = self.cell(x, y) {
            cell.arms |= arms;
        }
    }

    /// Makes the arms of a cell double.
    pub(crate) fn double(&mut self, x: usize, y: usize, across: bool, along: bool) {
        if let Some(cell) = self.cell(x, y) {
            cell.across |= across;
            cell.along |= along;
        }
    }

    /// The edge of a box.
    pub(crate) fn edge(
        &mut self,
        (x, y): (usize, usize),
        (columns, rows): (usize, usize),
        double: bool,
    ) {
        let (right, low) = (x + columns - 1, y + rows - 1);
        for column in x..=right {
            let arms = match column {
                _ if column == x => RIGHT,
                _ if column == right => LEFT,
                _ => LEFT | RIGHT,
            };
            for row in [y, low] {
                self.arms(column, row, arms);
                self.double(column, row, double, false);
            }
        }
        for row in y..=low {
            let arms = match row {
                _ if row == y => DOWN,
                _ if row == low => UP,
                _ => UP | DOWN,
            };
            for column in [x, right] {
                self.arms(column, row, arms);
                self.double(column, row, false, double);
            }
        }
    }

    /// Writes a text.
    pub(crate) fn write(&mut self, x: usize, y: usize, text: &str) {
        let mut at = x;
        let mut sign = [0; 4];
        for c in text.chars() {
            let columns = width(c.encode_utf8(&mut sign));
            if columns == 0 {
                continue;
            }
            for taken in 0..columns {
                if let Some(cell) = self.cell(at + taken, y) {
                    (cell.sign, cell.taken) = (Some(c), taken > 0);
                }
            }
            at += columns;
        }
    }

    /// The rows, without spaces at their ends.
    pub(crate) fn text(&self) -> String {
        let mut text = String::new();
        for row in self.cells.chunks(self.columns.max(1)) {
            let signs = row.iter().filter(|cell| !cell.taken);
            let line: String = signs.map(Cell::sign).collect();
            text.push_str(line.trim_end());
            text.push('\n');
        }
        text
    }
}

impl Cell {
    fn sign(&self) -> char {
        if let Some(sign) = self.sign {
            return sign;
        }
        let single = [
            ' ', '│', '│', '│', '─', '┘', '┐', '┤', '─', '└', '┌', '├', '─', '┴', '┬', '┼',
        ];
        let across = [
            ' ', '│', '│', '│', '═', '╛', '╕', '╡', '═', '╘', '╒', '╞', '═', '╧', '╤', '╪',
        ];
        let along = [
            ' ', '║', '║', '║', '─', '╜', '╖', '╢', '─', '╙', '╓', '╟', '─', '╨', '╥', '╫',
        ];
        let both = [
            ' ', '║', '║', '║', '═', '╝', '╗', '╣', '═', '╚', '╔', '╠', '═', '╩', '╦', '╬',
        ];
        let signs = match (self.across, self.along) {
            (false, false) => single,
            (true, false) => across,
            (false, true) => along,
            (true, true) => both,
        };
        signs.get(usize::from(self.arms)).copied().unwrap_or(' ')
    }
}
