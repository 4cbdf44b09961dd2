//! Where the things of a document are on its sheet, and where more can be inserted.

use super::document::{Document, Id, Rung};
use super::draw::Drawn;
use super::operation::Place;
use super::table::Table;
use crate::listing::wrapped;
use crate::power::Nets;
use crate::svg_page::{Labels, OnSheet, Shape, tops};
use crate::{Area, Look, Medium, Style, picture};
use std::collections::BTreeMap;
use std::sync::Arc;
use unoclp_checked::Work;
use unoclp_core::isa::Opcode;

/// A document on a sheet, which a page shows and lets a person point at.
#[derive(Clone, Debug)]
pub struct Canvas {
    /// Its width and its height.
    pub size: (f32, f32),
    /// Its rungs, from top to bottom.
    pub rungs: Vec<Strip>,
    /// What all of them were drawn with: how they look, the columns that they might take, those between the rails, the names
    /// of points.
    drawn_with: (Look, usize, usize, Arc<Table>),
}

/// A rung where it stands.
#[derive(Clone, Debug)]
pub struct Strip {
    /// What it is known by.
    pub id: Id,
    /// Its upper edge on the sheet.
    pub top: f32,
    /// The nets before its own, without that of the left rail.
    pub nets: u32,
    /// The steps before its own.
    pub first: usize,
    /// The rung wherever it stands.
    pub drawn: Arc<RungDrawing>,
    /// Whether it was drawn anew.
    pub is_new: bool,
}

/// A rung wherever it stands: places count from its upper edge, nets and steps from its first.
#[derive(Clone, Debug)]
pub struct RungDrawing {
    /// A group of SVG; symbols and the rung have their names as `data-id`.
    pub svg: String,
    /// Its height, with its heading.
    pub height: f32,
    /// Where the rung, its elements and its paths without an element are.
    pub spots: Vec<Spot>,
    /// Where an element can be inserted.
    pub places: Vec<Opening>,
    of: Of,
    /// The columns that it takes between the rails.
    takes: usize,
}

/// All that a drawing of a rung depends on, beside what is the same for all of them.
#[derive(Clone, Debug, PartialEq)]
struct Of {
    rung: Arc<Rung>,
    heading: Vec<String>,
    /// The timers before it, where it has one: they have numbers.
    timers: Option<u8>,
    /// With its first code, where it has one, it has a step more.
    steps: usize,
    begins_at_rail: bool,
}

/// A rung that is to stand on a sheet.
struct Planned<'l> {
    of: Of,
    shown: &'l crate::Rung,
    picture: Picture<'l>,
}

/// How far it is.
enum Picture<'l> {
    /// It was drawn before, in columns that may be others.
    Known(Arc<RungDrawing>),
    /// It is laid out, and not yet as wide as the others.
    Laid(Shape<'l>),
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
    /// Where it is on the rung's drawing.
    pub area: Area,
}

/// The height of the strip below a symbol in which paths beside it begin, of that of its row.
const BESIDE: f32 = 0.3;
/// The width of the strips before and after a symbol, in units of the sheet: half a wire.
const STRIP: f32 = 9.0;

impl Drawn {
    /// The document that this is the ladder of, on a sheet of so many columns, which blocks need not keep to. `title` says what the rung with this
    /// number, from 1, is called. A rung that is as it was `before` is not drawn again.
    pub fn canvas(
        &self,
        document: &Document,
        (look, width): (Look, usize),
        title: &dyn Fn(usize) -> String,
        before: Option<&Canvas>,
    ) -> Canvas {
        Work::note(|work| work.drawings += 1);
        let names = document.table().names();
        let style = Style {
            width,
            names: &names,
            medium: Medium::Screen,
        };
        let before = before.filter(|before| {
            let (known, columns, _, table) = &before.drawn_with;
            *known == look && *columns == width && *table == document.table
        });
        let known = before.iter().flat_map(|before| &before.rungs);
        let known: BTreeMap<Id, &Strip> = known.map(|strip| (strip.id, strip)).collect();
        let lay = |shown| Shape::new(&self.ladder, shown, look, &style);
        let rungs = document.rungs.iter().zip(&self.ladder.rungs);
        let rungs = (1..).zip(rungs).map(|(number, (rung, shown))| {
            let lines = heading(rung, title(number), document);
            let lines = lines.iter().flat_map(|line| wrapped(line, style.limit()));
            let of = Of::new(rung, shown, lines.collect());
            let known = known.get(&rung.id).filter(|strip| strip.drawn.of == of);
            let picture = match known {
                Some(strip) => Picture::Known(strip.drawn.clone()),
                None => Picture::Laid(lay(shown)),
            };
            Planned { of, shown, picture }
        });
        let rungs: Vec<Planned<'_>> = rungs.collect();
        let widths = rungs.iter().map(|rung| match &rung.picture {
            Picture::Known(drawn) => drawn.takes,
            Picture::Laid(shape) => shape.columns(),
        });
        let between = style.between_rails(widths);
        let fits = before.is_some_and(|before| before.drawn_with.2 == between);
        let draw = |of, shown, shape| Arc::new(self.drawing(of, shown, shape, between));
        let strips = rungs.into_iter().map(|Planned { of, shown, picture }| {
            let (id, first) = (of.rung.id, shown.first);
            let (drawn, is_new) = match picture {
                Picture::Known(drawn) if fits => (drawn, false),
                Picture::Known(_) => (draw(of, shown, lay(shown)), true),
                Picture::Laid(shape) => (draw(of, shown, shape), true),
            };
            Strip {
                id,
                top: 0.0,
                nets: shown.nets,
                first,
                drawn,
                is_new,
            }
        });
        let mut rungs: Vec<Strip> = strips.collect();
        let heights = rungs.iter().map(|strip| strip.drawn.height);
        let (tops, size) = tops(heights, between);
        for (strip, top) in rungs.iter_mut().zip(tops) {
            strip.top = top;
        }
        Canvas {
            size,
            rungs,
            drawn_with: (look, width, between, document.table.clone()),
        }
    }

    /// A rung in so many columns between the rails.
    fn drawing(
        &self,
        of: Of,
        shown: &crate::Rung,
        shape: Shape<'_>,
        between: usize,
    ) -> RungDrawing {
        let (rung, takes) = (of.rung.id, shape.columns());
        let labels = Labels {
            elements: &|index| self.elements[index].0,
            rung: rung.0,
            heading: &of.heading,
        };
        let sheet = OnSheet::new(&self.ladder, shown, shape, between, &labels);
        let mut spots = vec![Spot {
            id: rung,
            area: sheet.area,
        }];
        let mut places = Vec::new();
        if of.rung.series.is_empty() {
            places.push(Opening {
                at: rung,
                place: Place::Behind,
                area: sheet.area,
            });
        }
        let last = of.rung.last_if();
        let mut before = None;
        for (index, area) in sheet.elements {
            let id = self.elements[index];
            // A timer and the coil that it drives are one: what goes after goes after the coil.
            let goes_on = before == Some(id);
            if goes_on {
                places.pop();
            }
            before = Some(id);
            spots.push(Spot { id, area });
            places.extend(openings(id, area, !goes_on, last != Some(id)));
        }
        RungDrawing {
            svg: sheet.svg,
            height: sheet.area.height,
            spots,
            places,
            of,
            takes,
        }
    }
}

impl Of {
    fn new(rung: &Arc<Rung>, shown: &crate::Rung, heading: Vec<String>) -> Of {
        let timers = &shown.timers;
        Of {
            rung: rung.clone(),
            heading,
            timers: (!timers.is_empty()).then_some(timers.start),
            steps: shown.steps,
            begins_at_rail: shown.rail == Nets::RAIL,
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
