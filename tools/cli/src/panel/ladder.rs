//! The ladder diagram of a running program, energised parts with heavy lines: `┣━━┥ I1 ┝━━┤/I2 ├──( Q1 )─┤`.

use super::ON;
use ratatui::style::Style;
use ratatui::text::{Line, Span};
use unoclp_draw::{Cell, Medium, Picture, Power, Style as Drawn};
use unoclp_exercise::live::{Boxes, Flow};
use unoclp_workspace::Ready;

/// The columns before the left rail, for the number of the rung.
const MARGIN: usize = 4;

/// The rungs of a program.
pub struct Rungs {
    program: Ready,
    boxes: Boxes,
}

impl Rungs {
    /// The rungs of this program.
    pub fn new(program: &Ready) -> Rungs {
        Rungs {
            boxes: Boxes::new(program.program()),
            program: program.clone(),
        }
    }

    /// All rungs as lines of text, of this width where that is enough for them.
    /// That of the step that comes next, where there is one, is marked.
    pub fn lines(&self, flow: &Flow, next: Option<usize>, width: usize) -> Vec<Line<'static>> {
        let live = |step: usize| self.boxes.text(step, flow);
        let ladder = self.program.ladder();
        let drawing = ladder.draw(&Drawn {
            width: width.saturating_sub(MARGIN),
            names: self.program.names(),
            medium: Medium::Text(&live),
        });
        let power = ladder.nets.power(&flow.acc);
        let mut lines = Vec::new();
        for (index, picture) in drawing.rungs.iter().enumerate() {
            let head = &ladder.rungs[index];
            let part = head.part.map(unoclp_draw::picture);
            lines.extend(part.map(|part| Line::raw(format!("    {part}:"))));
            let labels = head.labels.iter();
            lines.extend(labels.map(|label| Line::raw(format!("    L{label}:"))));
            let comes =
                next.is_some_and(|step| (head.first..head.first + head.steps).contains(&step));
            lines.extend(rung(index + 1, comes, picture, &power));
        }
        lines
    }
}

/// The lines of a rung, its number before its first wire.
fn rung(number: usize, comes: bool, picture: &Picture, power: &Power) -> Vec<Line<'static>> {
    let line = |(row, cells): (usize, &Vec<Cell>)| {
        let margin = match row == picture.axis {
            true if comes => format!("{number:>3}▶"),
            true => format!("{number:>3} "),
            false => " ".repeat(MARGIN),
        };
        let mut spans = vec![Span::raw(margin)];
        let alike = |one: &Cell, other: &Cell| one.shown(power).1 == other.shown(power).1;
        for cells in cells.chunk_by(alike) {
            let shown = cells.iter().filter(|cell| cell.ch != '\0');
            let text: String = shown.map(|cell| cell.shown(power).0).collect();
            let style = match cells.first().is_some_and(|cell| cell.shown(power).1) {
                true => ON,
                false => Style::new(),
            };
            spans.push(Span::styled(text, style));
        }
        Line::from(spans)
    };
    picture.rows.iter().enumerate().map(line).collect()
}
