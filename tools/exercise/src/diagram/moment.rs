//! What passed between a program and its machine about a moment: each point that they are wired by, over time.
//!
//! Owns what is noted, and how it looks. Must not know what went wrong, nor how a machine is drawn.

use super::lanes::Lane;
use super::stroke::{Scale, label, line};
use super::{COLUMN, GAP, INK, MARGIN, PALE, RED, axis, document, drawn_lane};
use crate::scenario::{Both, Course};
use std::collections::BTreeMap;
use svg::node::element::Group;
use unoclp_core::{Millis, Point};
use unoclp_plant::{Plant, Run};
use unoclp_program::Lang;

/// A number that changes all the time is shown as often, ms.
const NUMBERS: u64 = 250;

/// What is noted of a point.
#[derive(Clone, Copy, Debug)]
enum What {
    Input(Point),
    Analogue(u8),
    Output(Point),
    Pwm(u8),
}

/// The points by which a program and its machine are wired, over a time.
#[derive(Clone, Debug)]
pub struct Moment {
    points: Vec<(What, String, Course)>,
    from: Option<Millis>,
    until: Millis,
}

impl Moment {
    /// Nothing has been noted yet of this machine.
    pub fn new(plant: &Plant) -> Moment {
        let [inputs, analogue, outputs] = plant.uses();
        let board = plant.board;
        let input = |number: &u8| {
            let point = Point::new(*number, board.inputs)?;
            Some((What::Input(point), format!("I{number}")))
        };
        let output = |number: &u8| {
            let point = Point::new(*number, board.outputs)?;
            Some((What::Output(point), format!("Q{number}")))
        };
        let pwm = board.pwm_outputs().filter(|_| plant.dims());
        let inputs = inputs.iter().filter_map(input);
        let readings = analogue
            .iter()
            .map(|number| (What::Analogue(*number), format!("A{number}")));
        let duties = pwm.map(|number| (What::Pwm(number), format!("P{number}")));
        let all = inputs
            .chain(readings)
            .chain(outputs.iter().filter_map(output))
            .chain(duties);
        Moment {
            points: all
                .map(|(what, name)| (what, name, Course::new()))
                .collect(),
            from: None,
            until: 0,
        }
    }

    /// Notes how the points are now. Times rise from call to call.
    pub fn note(&mut self, run: &Run<'_>) {
        let now = Millis::try_from(run.now()).unwrap_or(Millis::MAX);
        let is_first = self.from.is_none();
        self.from.get_or_insert(now);
        self.until = now;
        let (inputs, outputs) = (run.inputs(), run.outputs());
        for (what, _, course) in &mut self.points {
            let value = match *what {
                What::Input(point) => i32::from(inputs.points.get(point)),
                What::Output(point) => i32::from(outputs.points.get(point)),
                What::Analogue(number) => {
                    let reading = inputs.analogue.get(usize::from(number));
                    i32::from(reading.copied().unwrap_or_default())
                }
                What::Pwm(number) => {
                    let duty = outputs.pwm.get(usize::from(number));
                    i32::from(duty.copied().unwrap_or_default())
                }
            };
            let is_number = matches!(what, What::Analogue(_) | What::Pwm(_));
            if is_number && !is_first && !run.now().is_multiple_of(NUMBERS) {
                continue;
            }
            if course.last().is_none_or(|last| last.1 != Some(value)) {
                course.push((now, Some(value)));
            }
        }
    }

    /// Where its times are, in units of the picture: the place of the first, and how far it is to the last.
    pub fn plot() -> [f32; 2] {
        [COLUMN.left, COLUMN.plot()]
    }

    /// It as an SVG document, with what went wrong at this time marked; `names` are what is connected to the points. A line
    /// of the class `cursor` stands at its first time, for who moves it.
    pub fn svg(&self, at: Millis, why: &str, names: &BTreeMap<String, Both>, lang: Lang) -> String {
        let (why_lines, below) = COLUMN.lines(why, MARGIN + 10.0, RED);
        let top = below - 10.0;
        let scale = Scale {
            left: COLUMN.left,
            width: COLUMN.plot(),
            from: self.from.unwrap_or(0),
            until: self.until.max(self.from.unwrap_or(0).saturating_add(1)),
        };
        let mut page = Group::new();
        let mut bottom = top;
        let mut rows = Group::new();
        for (what, name, course) in &self.points {
            let lane = Lane {
                label: match names.get(name) {
                    Some(said) => format!("{name} {}", said.text(lang)),
                    None => name.clone(),
                },
                is_bit: matches!(what, What::Input(_) | What::Output(_)),
                expected: None,
                came: course.clone(),
                unmet: Vec::new(),
            };
            let (drawn, below) = drawn_lane(&lane, scale, self.until, bottom, lang, COLUMN);
            rows = rows.add(drawn);
            bottom = below + GAP;
        }
        let x = scale.x(at);
        page = page
            .add(why_lines)
            .add(axis(scale, top, bottom, lang))
            .add(rows)
            .add(line(x, top, x, bottom, RED).set("stroke-dasharray", "5 3"))
            .add(
                line(COLUMN.left, top, COLUMN.left, bottom, INK)
                    .set("class", "cursor")
                    .set("stroke-width", 1.5),
            );
        if self.points.is_empty() {
            page = page.add(label(MARGIN, bottom, "–", PALE));
        }
        document(page, (COLUMN.width, bottom + 20.0 + MARGIN), why)
    }
}
