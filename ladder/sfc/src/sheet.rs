//! Where everything of a chart stands, in cells: a character each.

use crate::document::Document;
use crate::look::Look;
use crate::measure::{
    BOX, Column, LEAD, Measure, Measured, Room, box_columns, fields, offsets, table_columns,
};
use crate::outline::Outline;
use std::fmt;
use std::str::FromStr;

/// Between charts beside each other.
const APART: usize = 4;

/// What stands on a sheet, by its numbers in the document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Id {
    /// A step.
    Step(usize),
    /// What a step does: the step, and the number of the action there.
    Does(usize, usize),
    /// A transition.
    Transition(usize),
    /// A jump: the transition before it, and which of its steps.
    Jump(usize, usize),
    /// A mark: this transition waits for the sequence, and first of all for this step.
    Wait(usize, usize),
}

impl fmt::Display for Id {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Id::Step(step) => write!(to, "s{step}"),
            Id::Does(step, nth) => write!(to, "a{step}.{nth}"),
            Id::Transition(transition) => write!(to, "t{transition}"),
            Id::Jump(transition, nth) => write!(to, "j{transition}.{nth}"),
            Id::Wait(transition, step) => write!(to, "w{transition}.{step}"),
        }
    }
}

/// No such id.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoId;

impl FromStr for Id {
    type Err = NoId;

    fn from_str(text: &str) -> Result<Id, NoId> {
        let kind = text.chars().next().ok_or(NoId)?;
        let rest = text.get(kind.len_utf8()..).ok_or(NoId)?;
        let number = |text: &str| text.parse::<usize>().map_err(|_| NoId);
        let two = || {
            let (one, other) = rest.split_once('.').ok_or(NoId)?;
            Ok((number(one)?, number(other)?))
        };
        Ok(match kind {
            's' => Id::Step(number(rest)?),
            't' => Id::Transition(number(rest)?),
            'w' => two().map(|(transition, step)| Id::Wait(transition, step))?,
            'a' => two().map(|(step, nth)| Id::Does(step, nth))?,
            'j' => two().map(|(transition, nth)| Id::Jump(transition, nth))?,
            _ => return Err(NoId),
        })
    }
}

/// A rectangle of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Area {
    /// Its first column.
    pub x: usize,
    /// Its first row.
    pub y: usize,
    /// How many columns.
    pub columns: usize,
    /// How many rows.
    pub rows: usize,
}

/// A chart that has been laid out.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    /// Its columns.
    pub columns: usize,
    /// Its rows.
    pub rows: usize,
    /// What is on it, from top to bottom along the lines.
    pub items: Vec<Item>,
    pub(crate) lines: Vec<Line>,
}

/// Something that stands on a sheet.
#[derive(Clone, Debug)]
pub struct Item {
    /// What it is.
    pub id: Id,
    /// Where.
    pub area: Area,
    pub(crate) shape: Shape,
}

#[derive(Clone, Debug)]
pub(crate) enum Shape {
    Step {
        label: String,
        initial: bool,
    },
    /// A row of a table of actions: its fields, and the columns of the first.
    Does {
        when: String,
        name: String,
        split: Option<usize>,
    },
    Transition {
        axis: usize,
        lines: Vec<String>,
    },
    Jump(String),
    Wait(String),
}

impl Item {
    /// Its middle, in the units of a drawing.
    pub fn middle(&self) -> (f32, f32) {
        let (wide, high) = crate::measure::CELL;
        let Area {
            x,
            y,
            columns,
            rows,
        } = self.area;
        let middle = |from: usize, count: usize| from as f32 + count as f32 / 2.0;
        (middle(x, columns) * wide, (middle(y, rows) + 0.5) * high)
    }
}

/// A line, in halves of cells: it begins and ends in the middle of one.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Line {
    /// In this column, from the first half row to before the last.
    Down {
        column: usize,
        from: usize,
        to: usize,
    },
    /// In this row, from the middle of one column to that of another.
    Across {
        row: usize,
        from: usize,
        to: usize,
        double: bool,
    },
}

impl Sheet {
    /// A chart, as its outline says and in this look.
    pub fn of(document: &Document, outline: &Outline, look: Look) -> Sheet {
        let measure = Measure { document, look };
        let mut sheet = Sheet::default();
        let mut x = 1;
        for column in measure.all(outline) {
            let Room { left, .. } = column.room;
            sheet.column(&column, x + left, 0, None);
            sheet.rows = sheet.rows.max(column.room.rows);
            x += column.room.columns() + APART;
        }
        sheet.columns = (x + 1).saturating_sub(APART);
        sheet
    }

    /// A document with its usual outline, in this look.
    pub fn drawn(document: &Document, look: Look) -> Sheet {
        Sheet::of(document, &Outline::of(document), look)
    }

    /// What is known by this id, where it stands.
    pub fn area(&self, id: Id) -> Option<Area> {
        let item = self.items.iter().find(|item| item.id == id)?;
        Some(item.area)
    }

    /// Draws parts below each other, a line from `enter` to the first; where the line leaves the last.
    fn column(
        &mut self,
        column: &Column<'_>,
        axis: usize,
        mut y: usize,
        mut enter: Option<usize>,
    ) -> Option<usize> {
        for (part, room) in &column.parts {
            if let Some(from) = enter {
                self.down(axis, from, 2 * y + 1);
            }
            enter = self.part(part, axis, y, room.rows);
            y += room.rows + 1;
        }
        enter
    }

    fn down(&mut self, column: usize, from: usize, to: usize) {
        if from < to {
            self.lines.push(Line::Down { column, from, to });
        }
    }

    fn part(&mut self, part: &Measured<'_>, axis: usize, y: usize, rows: usize) -> Option<usize> {
        match part {
            Measured::Step {
                number,
                label,
                initial,
                does,
            } => {
                let columns = box_columns(label);
                let (label, initial) = (label.clone(), *initial);
                let area = Area {
                    x: axis - columns / 2,
                    y,
                    columns,
                    rows: BOX,
                };
                self.put(Id::Step(*number), area, Shape::Step { label, initial });
                if !does.is_empty() {
                    self.does(*number, does, area);
                }
                Some(2 * (y + BOX - 1) + 1)
            }
            Measured::Transition { number, lines } => {
                let longest = lines.iter().map(|line| crate::measure::width(line)).max();
                let area = Area {
                    x: axis - 2,
                    y,
                    columns: 6 + longest.unwrap_or(0),
                    rows,
                };
                let lines = lines.clone();
                self.put(
                    Id::Transition(*number),
                    area,
                    Shape::Transition { axis, lines },
                );
                Some(2 * y + 1)
            }
            Measured::Jump(transition, nth, label) => {
                let area = mark(axis, y, label);
                self.put(
                    Id::Jump(*transition, *nth),
                    area,
                    Shape::Jump(label.clone()),
                );
                None
            }
            Measured::Wait(transition, step, label) => {
                let area = mark(axis, y, label);
                self.put(
                    Id::Wait(*transition, *step),
                    area,
                    Shape::Wait(label.clone()),
                );
                None
            }
            Measured::Fork { fork, branches } => {
                let axes: Vec<usize> = offsets(branches).iter().map(|off| axis + off).collect();
                let below = y + rows - 1;
                let double = fork.simultaneous;
                let last = axes.last().copied().unwrap_or(axis);
                self.across(y, axis, last, double);
                let mut joined: Option<usize> = None;
                for ((branch, column), axis) in fork.branches.iter().zip(branches).zip(axes) {
                    let from = 2 * y + 1;
                    let left = match column.parts.is_empty() {
                        true => Some(from),
                        false => self.column(column, axis, y + 2, Some(from)),
                    };
                    if let (true, Some(left)) = (branch.joins, left) {
                        self.down(axis, left, 2 * below + 1);
                        joined = Some(axis);
                    }
                }
                let last = joined?;
                self.across(below, axis, last, double);
                Some(2 * below + 1)
            }
        }
    }

    fn across(&mut self, row: usize, from: usize, to: usize, double: bool) {
        let beyond = usize::from(double);
        self.lines.push(Line::Across {
            row,
            from: from.saturating_sub(beyond),
            to: to + beyond,
            double,
        });
    }

    /// The table of actions beside the box of a step.
    fn does(&mut self, step: usize, does: &[(String, String)], beside: Area) {
        let (x, row) = (beside.x + beside.columns, beside.y + 1);
        self.lines.push(Line::Across {
            row,
            from: x - 1,
            to: x + LEAD,
            double: false,
        });
        let columns = table_columns(does);
        let (first, _) = fields(does);
        for (nth, (when, name)) in does.iter().enumerate() {
            let area = Area {
                x: x + LEAD,
                y: beside.y + 2 * nth,
                columns,
                rows: BOX,
            };
            let shape = Shape::Does {
                when: when.clone(),
                name: name.clone(),
                split: (first > 0).then_some(first + 3),
            };
            self.put(Id::Does(step, nth), area, shape);
        }
    }

    fn put(&mut self, id: Id, area: Area, shape: Shape) {
        self.items.push(Item { id, area, shape });
    }
}

/// The cells of a mark and its name.
fn mark(x: usize, y: usize, label: &str) -> Area {
    Area {
        x,
        y,
        columns: crate::measure::width(label) + 2,
        rows: 1,
    }
}
