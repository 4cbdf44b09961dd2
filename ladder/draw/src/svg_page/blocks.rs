//! A rung as a block diagram on a page.
//!
//! Beside what `screen` names, wires and values of points that are seen whatever the power is say in `data-says` what they
//! show: a point, or a gate of points in front of its inputs, `|2 I1 !I2`.

use super::area::Area;
use super::named::named;
use super::node::{Node, data};
use super::page::{Font, Page, of_net};
use super::{AXIS, COLUMN, GAP, HALF, MARGIN};
use crate::blocks::{Graph, Kind, Placed, Vertex};
use crate::face::Face;
use crate::{Element, Ladder, NARROWEST, Rung, Style, Symbol};
use unicode_width::UnicodeWidthStr;

/// A rung as blocks, laid out.
pub(crate) struct Diagram<'l> {
    graph: Graph<'l>,
    placed: Placed,
    /// By their vertices.
    faces: Vec<Words>,
    /// The left edge of each column, and the end of its widest block; of all, the right edge.
    lefts: Vec<f32>,
    ends: Vec<f32>,
    pub(crate) width: f32,
}

/// What a block says.
struct Words {
    name: Option<String>,
    text: String,
    notes: Vec<String>,
    width: f32,
}

/// A row: names stand above a block, values below.
const ROW: f32 = 46.0;
/// Between a block and those after it, without the wires that go down there.
const BETWEEN: f32 = 30.0;
/// Between wires that go down side by side.
const TRACK: f32 = 8.0;
/// The radius of the sign that negates.
const BUBBLE: f32 = 4.0;
/// The least width of a gate.
const GATE: f32 = 36.0;
/// A line of a note.
const NOTE: f32 = 17.0;

impl<'l> Diagram<'l> {
    /// All rungs, and the columns that they take.
    pub(super) fn all(ladder: &'l Ladder, style: &Style<'_>) -> (Vec<Diagram<'l>>, usize) {
        let rungs = ladder.rungs.iter();
        let all: Vec<_> = rungs
            .map(|rung| Diagram::new(ladder, rung, style))
            .collect();
        let columns = all.iter().map(Diagram::columns).max();
        (all, columns.unwrap_or(0).max(NARROWEST))
    }

    /// A rung as blocks.
    pub(crate) fn new(ladder: &'l Ladder, rung: &Rung, style: &Style<'_>) -> Diagram<'l> {
        let graph = Graph::of(ladder, rung);
        let words = graph.vertices.iter();
        let faces: Vec<Words> = words
            .map(|vertex| Words::of(vertex, ladder, style))
            .collect();
        let rows = |at: usize| {
            let notes: &Words = &faces[at];
            1 + (notes.notes.len() as f32 * NOTE / ROW).ceil() as usize
        };
        let placed = Placed::of(&graph, &rows);
        let mut widths = vec![0.0_f32; placed.columns.len()];
        for (spot, words) in placed.spots.iter().zip(&faces) {
            let width = &mut widths[spot.column];
            *width = width.max(words.width);
        }
        let (mut lefts, mut ends) = (Vec::new(), Vec::new());
        let mut x = MARGIN;
        for (width, down) in widths.iter().zip(&placed.columns) {
            lefts.push(x);
            ends.push(x + width);
            x += width + BETWEEN + *down as f32 * TRACK;
        }
        Diagram {
            width: ends.last().copied().unwrap_or(MARGIN) + MARGIN,
            graph,
            placed,
            faces,
            lefts,
            ends,
        }
    }

    /// The columns that it takes between the rails of a ladder.
    pub(crate) fn columns(&self) -> usize {
        ((self.width - 2.0 * MARGIN) / COLUMN).ceil().max(0.0) as usize
    }

    fn y(&self, top: f32, row: usize) -> f32 {
        top + row as f32 * ROW + AXIS
    }

    /// The left and the right edge of a block: values end where their column does.
    fn edges(&self, at: usize) -> (f32, f32) {
        let (column, width) = (self.placed.spots[at].column, self.faces[at].width);
        match self.graph.vertices[at].kind {
            Kind::Value(_) | Kind::Named(_) => (self.ends[column] - width, self.ends[column]),
            _ => (self.lefts[column], self.lefts[column] + width),
        }
    }
}

impl Words {
    fn of(vertex: &Vertex, ladder: &Ladder, style: &Style<'_>) -> Words {
        let element = match &vertex.kind {
            Kind::Value(index) | Kind::Box(index) | Kind::Output(index) => Some(*index),
            Kind::Gate(..) | Kind::Named(_) | Kind::Store(_) => None,
        };
        let element = element.and_then(|index| ladder.elements.get(index));
        let Some(element) = element else {
            let (text, least) = match &vertex.kind {
                Kind::Gate(sign, _) => ((*sign).to_owned(), GATE),
                Kind::Named(name) | Kind::Store(name) => (name.clone(), 0.0),
                _ => (String::new(), 0.0),
            };
            let width = (text.width() as f32 * COLUMN + 8.0).max(least);
            return Words {
                name: None,
                text,
                notes: Vec::new(),
                width,
            };
        };
        let face = Face::new(element, style.names, style.medium);
        let text = match &element.symbol {
            Symbol::Contact { text, .. } => text.clone(),
            Symbol::Inline(text) => (*text).to_owned(),
            Symbol::Coil { letter, text } => match letter {
                ' ' | '/' => text.clone(),
                letter => format!("{letter} {text}"),
            },
            Symbol::Box { text, .. } => match (&element.pins, element.point) {
                (Some(pins), Some(point)) => format!("{} {point}", pins.title),
                (Some(pins), None) => pins.title.to_owned(),
                (None, _) => text.clone(),
            },
            Symbol::Leave { text, .. } => text.clone(),
        };
        let notes = face.notes.iter().map(|note| note.width() + 2);
        let texts = [text.width() + 2].into_iter().chain(notes);
        let texts = texts.chain(face.name.iter().map(|name| name.width()));
        let pins = element.pins.iter();
        let texts = texts.chain(pins.map(|pins| pins.before() + pins.behind() + 2));
        Words {
            width: texts.max().unwrap_or(0) as f32 * COLUMN,
            name: face.name,
            text,
            notes: face.notes,
        }
    }
}

impl Page<'_> {
    /// A rung under its heading, as blocks. What comes next is below it, with a gap between.
    pub(super) fn headed_blocks(&mut self, heading: &[String], diagram: &Diagram<'_>) {
        self.heading(heading);
        let top = self.y;
        let mut order = 0;
        for (at, vertex) in diagram.graph.vertices.iter().enumerate() {
            self.inputs(diagram, at, top);
            let is_counted = !matches!(vertex.kind, Kind::Value(_) | Kind::Named(_));
            order += usize::from(is_counted);
            self.block(diagram, at, top, is_counted.then_some(order));
        }
        self.y = top + diagram.placed.rows.max(1) as f32 * ROW;
        self.y += GAP;
    }

    /// The wires to a block, and the signs that negate at its inputs.
    fn inputs(&mut self, diagram: &Diagram<'_>, at: usize, top: f32) {
        let (vertices, placed) = (&diagram.graph.vertices, &diagram.placed);
        let (left, _) = diagram.edges(at);
        let element = match vertices[at].kind {
            Kind::Output(index) => self.ladder.elements.get(index),
            _ => None,
        };
        let ends_negated = element.is_some_and(|element| {
            matches!(
                element.symbol,
                Symbol::Coil { letter: '/', .. } | Symbol::Leave { inverted: true, .. }
            )
        });
        for (pin, route) in vertices[at].inputs.iter().zip(&placed.spots[at].routes) {
            let from = &vertices[pin.from];
            let source = &placed.spots[pin.from];
            let (_, right) = diagram.edges(pin.from);
            let (start, end) = (diagram.y(top, source.row), diagram.y(top, route.row));
            let negated = pin.negated != ends_negated;
            let stop = if negated { left - 2.0 * BUBBLE } else { left };
            let way = match route.down {
                None => data(&[('M', &[right, end]), ('H', &[stop])]),
                Some(track) => {
                    let x = diagram.ends[source.column] + 10.0 + track as f32 * TRACK;
                    data(&[
                        ('M', &[right, start]),
                        ('H', &[x]),
                        ('V', &[end]),
                        ('H', &[stop]),
                    ])
                }
            };
            self.wire_from(way, from);
            if negated {
                let (x, r) = (left - 2.0 * BUBBLE, BUBBLE);
                self.line(
                    format!("M{x} {end}a{r} {r} 0 1 0 8 0a{r} {r} 0 1 0 -8 0"),
                    1.6,
                );
            }
        }
    }

    /// A wire that shows what a block gives.
    fn wire_from(&mut self, way: String, from: &Vertex) {
        let Some(rung) = self.screen else {
            return self.wire(way, Some(from.net));
        };
        let class = of_net("wire", rung.net(from.net));
        let wire = Node::path().set("d", way).set("class", class);
        self.add(match &from.says {
            Some(says) => wire.set("data-says", &**says),
            None => wire,
        });
    }

    fn block(&mut self, diagram: &Diagram<'_>, at: usize, top: f32, order: Option<usize>) {
        let vertex = &diagram.graph.vertices[at];
        let (words, spot) = (&diagram.faces[at], &diagram.placed.spots[at]);
        let (left, right) = diagram.edges(at);
        let (above, below) = (
            diagram.y(top, spot.row) - HALF - 2.0,
            diagram.y(top, spot.last()) + HALF + 2.0,
        );
        let outer = std::mem::take(&mut self.group);
        self.shape(vertex, words, (left, right, above, below));
        if let (Some(order), Kind::Gate(..) | Kind::Box(_) | Kind::Output(_)) =
            (order, &vertex.kind)
        {
            self.text(right + 2.0, above + 2.0, &order.to_string(), &Font::ORDER);
        }
        let index = match vertex.kind {
            Kind::Value(index) | Kind::Box(index) | Kind::Output(index) => Some(index),
            Kind::Gate(_, index) => index,
            Kind::Named(_) | Kind::Store(_) => None,
        };
        let element = index.and_then(|index| self.ladder.elements.get(index));
        if let Some(pins) = element.and_then(|element| element.pins.as_ref()) {
            let middle = (left + right) / 2.0;
            self.text(middle - 4.0, below + 13.0, &pins.preset, &Font::PRESET);
            self.text(middle + 4.0, below + 13.0, "", &Font::COUNT);
        }
        let inner = std::mem::replace(&mut self.group, outer);
        let (Some(rung), Some(index), Some(element)) = (self.screen, index, element) else {
            return self.add(inner);
        };
        let area = Area {
            x: left,
            y: above - 16.0,
            width: right - left,
            height: below - above + 20.0,
        };
        let value = element.pins.is_none().then_some(below + 11.0);
        let mut named = named(element, rung, inner, area, value);
        if let Some(says) = &vertex.says {
            named = named.set("data-says", &**says);
        }
        if let Some(ids) = self.ids {
            named = named.set("data-id", ids(index));
            self.areas.push((index, area));
        }
        self.add(named);
    }

    /// The outline of a block, and what it says.
    fn shape(
        &mut self,
        vertex: &Vertex,
        words: &Words,
        (left, right, above, below): (f32, f32, f32, f32),
    ) {
        let middle = (left + right) / 2.0;
        let centre = above + HALF + 2.0;
        let font = match vertex.kind {
            Kind::Box(_) => &Font::BOXED,
            _ => &Font::LETTER,
        };
        match vertex.kind {
            Kind::Value(_) | Kind::Named(_) => {
                self.text(middle, centre + 4.5, &words.text, &Font::POINT);
                self.line(data(&[('M', &[left, below]), ('H', &[right])]), 1.0);
            }
            Kind::Gate(..) | Kind::Box(_) | Kind::Output(_) | Kind::Store(_) => {
                let edge = self
                    .edge()
                    .set("stroke-width", 1.6)
                    .set("x", left)
                    .set("y", above)
                    .set("width", right - left)
                    .set("height", below - above);
                self.add(edge);
                self.text(middle, centre + 4.5, &words.text, font);
            }
        }
        if let Some(name) = &words.name {
            self.text(middle, above - 4.0, name, &Font::POINT);
        }
        for (index, note) in words.notes.iter().enumerate() {
            let y = below + 12.0 + index as f32 * NOTE;
            self.text(left + COLUMN, y, note, &Font::NOTE);
        }
    }
}

impl Element {
    /// Whether it conducts whatever stands before it.
    pub(crate) fn is_condition(&self) -> bool {
        self.role == crate::element::Role::Condition
    }
}
