//! Where the things of a document are on its sheet, and where more can be inserted.

use super::document::Rung;
use super::document::{Document, Id};
use super::draw::Drawn;
use super::operation::Place;
use crate::{Area, Labels, Sheet, picture, to_sheet};
use unoclp_core::isa::Opcode;

/// A document on a sheet, which a page shows and lets a person point at.
#[derive(Clone, Debug)]
pub struct Canvas {
    /// The drawing as an SVG element; symbols and rungs have their names as `data-id`.
    pub svg: String,
    /// All of it.
    pub area: Area,
    /// Where rungs, elements and paths without an element are.
    pub spots: Vec<Spot>,
    /// Where an element can be inserted.
    pub places: Vec<Opening>,
}

/// Where something is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// What is there.
    pub id: Id,
    /// Where.
    pub area: Area,
}

/// A place where an element can be inserted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opening {
    /// At which rung, element or path.
    pub at: Id,
    /// How it goes there.
    pub place: Place,
    /// Where it is on the sheet.
    pub area: Area,
}

/// The height of the strip below a symbol in which paths beside it begin, of that of its row.
const BESIDE: f32 = 0.3;
/// The width of the strips before and after a symbol, in units of the sheet: half a wire.
const STRIP: f32 = 9.0;

impl Drawn {
    /// The document that this is the ladder of, on a sheet of so many columns. `title` says what the rung with this
    /// number, from 1, is called; `label` what the drawing is to who cannot see it.
    pub fn canvas(
        &self,
        document: &Document,
        width: usize,
        title: &dyn Fn(usize) -> String,
        label: &str,
    ) -> Canvas {
        let names = document.table().names();
        let drawing = self.draw(width, &names);
        let heading = |index: usize| match document.rungs().nth(index) {
            Some(rung) => heading(rung, title(index + 1), document),
            None => Vec::new(),
        };
        let labels = Labels {
            elements: &|index| self.elements[index].0,
            rungs: &|index| self.rungs[index].0,
            heading: &heading,
            drawing: label,
        };
        let Sheet {
            svg,
            area,
            elements,
            rungs,
        } = to_sheet(&drawing, &labels);
        let rungs = self.rungs.iter().zip(rungs);
        let mut spots: Vec<Spot> = rungs.map(|(&id, area)| Spot { id, area }).collect();
        let mut places = Vec::new();
        let empty = document
            .rungs()
            .zip(&spots)
            .filter(|(rung, _)| rung.series.is_empty());
        places.extend(empty.map(|(_, spot)| Opening {
            at: spot.id,
            place: Place::Behind,
            area: spot.area,
        }));
        let ifs: Vec<Id> = document.rungs().filter_map(Rung::last_if).collect();
        let mut before = None;
        for (index, area) in elements {
            let id = self.elements[index];
            // A timer and the coil that it drives are one: what goes after goes after the coil.
            let goes_on = before == Some(id);
            if goes_on {
                places.pop();
            }
            before = Some(id);
            spots.push(Spot { id, area });
            places.extend(openings(id, area, !goes_on, !ifs.contains(&id)));
        }
        Canvas {
            svg,
            area,
            spots,
            places,
        }
    }
}

/// What stands above a rung: its title and what it is about, and the code and the labels that it begins with.
fn heading(rung: &Rung, title: String, document: &Document) -> Vec<String> {
    let mut lines = vec![title];
    if let Some((first, more)) = rung.comment.split_first() {
        lines[0] += &format!(": {first}");
        lines.extend(more.iter().cloned());
    }
    let part = match rung.begin {
        super::document::Begin::Else => Some(Opcode::Else),
        super::document::Begin::EndIf => Some(Opcode::EndIf),
        super::document::Begin::Rung | super::document::Begin::NewRung => None,
    };
    lines.extend(part.map(|part| format!("{}:", picture(part))));
    lines.extend(rung.labels.iter().map(|&label| {
        let point = unoclp_point::Address::Label(label);
        let name = document.table().get(point).map_or("", |row| &row.name);
        format!("{point}: {name}").trim_end().to_owned()
    }));
    lines
}

/// The places at a symbol: before it unless that is taken; beside it and after it unless it ends its rung.
fn openings(at: Id, area: Area, before: bool, goes_on: bool) -> impl Iterator<Item = Opening> {
    let height = area.height * (1.0 - BESIDE);
    let strip = |x| Area {
        x,
        y: area.y,
        width: STRIP,
        height,
    };
    let beside = Area {
        y: area.y + height,
        height: area.height * BESIDE,
        ..area
    };
    let open = move |place, area| Opening { at, place, area };
    let before = before.then(|| open(Place::Before, strip(area.x - STRIP)));
    let beside = goes_on.then(|| open(Place::Beside, beside));
    let behind = goes_on.then(|| open(Place::Behind, strip(area.x + area.width)));
    before.into_iter().chain(beside).chain(behind)
}
