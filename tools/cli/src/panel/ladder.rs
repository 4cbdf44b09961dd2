//! The ladder diagram of a running program, energised parts with heavy lines: `┣━━┥ I1 ┝━━┤/I2 ├──( Q1 )─┤`.

use super::ON;
use super::listing::Marked;
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

    /// All rungs as lines of text, of this width where that is enough for them, with what slow motion marks; and the line,
    /// counted from 0, of the rung that a person points to.
    pub fn lines(
        &self,
        flow: &Flow,
        slow: &Marked,
        width: usize,
    ) -> (Vec<Line<'static>>, Option<usize>) {
        let live = |step: usize| self.boxes.text(step, flow);
        let ladder = self.program.ladder();
        let drawing = ladder.draw(&Drawn {
            width: width.saturating_sub(MARGIN),
            names: self.program.names(),
            medium: Medium::Text(&live),
        });
        let power = ladder.nets.power(&flow.acc);
        let mut lines = Vec::new();
        let mut row = None;
        for (index, picture) in drawing.rungs.iter().enumerate() {
            let head = &ladder.rungs[index];
            let part = head.part.map(unoclp_draw::picture);
            lines.extend(part.map(|part| Line::raw(format!("    {part}:"))));
            let labels = head.labels.iter();
            lines.extend(labels.map(|label| Line::raw(format!("    L{label}:"))));
            let holds = |step: usize| (head.first..head.first + head.steps).contains(&step);
            if slow.cursor.is_some_and(holds) {
                row = Some(lines.len());
            }
            let number = slow.number(&format!("{:>3} ", index + 1), holds);
            lines.extend(rung(number, picture, &power));
        }
        (lines, row)
    }
}

/// The lines of a rung, its number before its first wire.
fn rung(number: Span<'static>, picture: &Picture, power: &Power) -> Vec<Line<'static>> {
    let line = |(row, cells): (usize, &Vec<Cell>)| {
        let margin = match row == picture.axis {
            true => number.clone(),
            false => Span::raw(" ".repeat(MARGIN)),
        };
        let mut spans = vec![margin];
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
