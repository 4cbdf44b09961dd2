//! A chart of characters.

use crate::document::Document;
use crate::grid::{DOWN, Grid, LEFT, RIGHT, UP};
use crate::live::{Live, seconds};
use crate::measure::width;
use crate::sheet::{Id, Item, Line, Shape, Sheet};

/// A chart as a text. What is live, if anything, has a dot.
pub fn picture(document: &Document, sheet: &Sheet, live: Option<&Live>) -> String {
    let mut grid = Grid::new(sheet.columns, sheet.rows);
    for line in &sheet.lines {
        draw(*line, &mut grid);
    }
    for item in &sheet.items {
        put(item, document, live, &mut grid);
    }
    grid.text()
}

fn draw(line: Line, grid: &mut Grid) {
    match line {
        Line::Down { column, from, to } => {
            for half in from..to {
                let arm = if half % 2 == 0 { UP } else { DOWN };
                grid.arms(column, half / 2, arm);
            }
        }
        Line::Across {
            row,
            from,
            to,
            double,
        } => {
            for column in from..=to {
                let left = if column > from { LEFT } else { 0 };
                let right = if column < to { RIGHT } else { 0 };
                grid.arms(column, row, left | right);
                grid.double(column, row, double, false);
            }
        }
    }
}

fn put(item: &Item, document: &Document, live: Option<&Live>, grid: &mut Grid) {
    let area = item.area;
    let (x, y) = (area.x, area.y);
    match &item.shape {
        Shape::Step { label, initial } => {
            grid.edge((x, y), (area.columns, area.rows), *initial);
            let before = (area.columns - width(label)) / 2;
            grid.write(x + before, y + 1, label);
            let Id::Step(step) = item.id else { return };
            let state = live.and_then(|live| live.steps.get(step));
            if let Some(state) = state.filter(|state| state.active) {
                grid.write(x + 1, y + 1, "●");
                // The table of several actions would be in the way.
                let does = document.steps.get(step).map_or(0, |step| step.does.len());
                if let Some(time) = state.time.filter(|_| does < 2) {
                    grid.write(x + area.columns / 2 + 2, y + area.rows, &seconds(time));
                }
            }
        }
        Shape::Does { when, name, split } => {
            grid.edge((x, y), (area.columns, area.rows), false);
            let mut from = x + 2;
            if let Some(split) = *split {
                grid.write(from, y + 1, when);
                for (row, arms) in [(y, DOWN), (y + 1, UP | DOWN), (y + 2, UP)] {
                    grid.arms(x + split, row, arms);
                }
                from = x + split + 2;
            }
            grid.write(from, y + 1, name);
        }
        Shape::Transition { axis, lines } => {
            for column in axis - 2..=axis + 2 {
                let left = if column > axis - 2 { LEFT } else { 0 };
                let right = if column < axis + 2 { RIGHT } else { 0 };
                grid.arms(column, y, left | right);
            }
            let Id::Transition(transition) = item.id else {
                return;
            };
            if live.is_some_and(|live| live.may_fire(document, transition)) {
                grid.write(axis - 2, y, "●");
            }
            for (row, line) in lines.iter().enumerate() {
                grid.write(axis + 4, y + row, line);
            }
        }
        Shape::Jump(label) => {
            grid.write(x, y, "▼");
            grid.write(x + 2, y, label);
        }
        Shape::Wait(label) => {
            grid.write(x, y, "▽");
            grid.write(x + 2, y, label);
        }
    }
}
