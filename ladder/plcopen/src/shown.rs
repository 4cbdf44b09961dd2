//! A drawn body as an SVG, where its file lays it out; in columns where the file does not say it.
//!
//! Each element has the class of its kind and a `data-id`, its number in the file.

use crate::bodies::body;
use crate::export::escaped;
use crate::found::{Found, span};
use crate::xml::{self, all, first, says, text};
use roxmltree::Node;
use std::collections::HashMap;
use std::fmt::Write as _;
use unoclp_lang::Span;

/// The body of a unit as a person sees it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shown {
    /// Its language: `LD`.
    pub language: String,
    /// Of ST and IL: what is written.
    pub text: String,
    /// Of LD and FBD: how it is drawn.
    pub svg: String,
    /// What is drawn.
    pub elements: Vec<Piece>,
}

/// An element of a drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Its number in the file.
    pub id: String,
    /// The name of its element in the file: `contact`.
    pub kind: String,
    /// Its variable, its expression, the instance of a block.
    pub written: String,
    /// Whether it is negated.
    pub negated: bool,
    /// `rising`, `falling`; else empty.
    pub edge: String,
    /// `set`, `reset`; else empty.
    pub storage: String,
    /// Where it stands in the file.
    pub at: Span,
}

/// The body of a unit; none where there is no such unit, or it has none.
pub fn shown(project: &str, unit: &str) -> Option<Shown> {
    let tree = xml::parse(project, &mut Found::default())?;
    let body = body(tree.root_element(), unit)?;
    let mut shown = Shown {
        language: body.tag_name().name().to_owned(),
        ..Shown::default()
    };
    match &*shown.language {
        "ST" | "IL" => shown.text = text(body),
        "LD" | "FBD" => {
            let elements = elements(body);
            shown.elements = elements.iter().map(piece).collect();
            shown.svg = svg(&elements, unit);
        }
        _ => {}
    }
    Some(shown)
}

/// A point of the drawing.
type Point = (f64, f64);

struct Element<'a, 'x> {
    node: Node<'a, 'x>,
    kind: &'x str,
    at: Point,
    size: Point,
    inputs: Vec<Pin<'a, 'x>>,
    outputs: Vec<Pin<'a, 'x>>,
}

struct Pin<'a, 'x> {
    name: &'a str,
    /// From the element's place.
    at: Point,
    negated: bool,
    node: Node<'a, 'x>,
}

fn piece(element: &Element<'_, '_>) -> Piece {
    let said = |name| element.node.attribute(name).unwrap_or_default().to_owned();
    let none = |word: String| if word == "none" { String::new() } else { word };
    Piece {
        id: said("localId"),
        kind: element.kind.to_owned(),
        written: element.written(),
        negated: says(element.node, "negated"),
        edge: none(said("edge")),
        storage: none(said("storage")),
        at: span(element.node),
    }
}

/// What a number of the file says, within what a drawing is.
fn number(of: Node<'_, '_>, name: &str) -> Option<f64> {
    let number: f64 = of.attribute(name)?.parse().ok()?;
    number
        .is_finite()
        .then_some(number.clamp(-20_000.0, 20_000.0))
}

fn elements<'a, 'x: 'a>(body: Node<'a, 'x>) -> Vec<Element<'a, 'x>> {
    let nodes = body.children().filter(Node::is_element);
    let nodes = nodes.filter(|node| node.attribute("localId").is_some());
    let mut elements: Vec<Element<'_, '_>> = nodes.map(element).collect();
    if elements.windows(2).all(|two| two[0].at == two[1].at) {
        lay_out(&mut elements);
    }
    elements
}

fn element<'a, 'x: 'a>(node: Node<'a, 'x>) -> Element<'a, 'x> {
    let kind = node.tag_name().name();
    let place = first(node, "position");
    let at = |name| place.and_then(|place| number(place, name)).unwrap_or(0.0);
    let pins = |name: &'static str| {
        let list = first(node, name).into_iter();
        list.flat_map(|list| all(list, "variable"))
            .collect::<Vec<_>>()
    };
    let (ins, outs) = (pins("inputVariables"), pins("outputVariables"));
    let rows = ins.len().max(outs.len()).max(1) as f64;
    let usual = match kind {
        "block" => (90.0, 30.0 + 20.0 * rows),
        "contact" | "coil" => (21.0, 15.0),
        "leftPowerRail" | "rightPowerRail" => (4.0, 40.0),
        _ => (16.0 + 8.0 * written(node).chars().count() as f64, 24.0),
    };
    let size = |name, usual: f64| {
        number(node, name)
            .filter(|size| *size >= 1.0)
            .unwrap_or(usual)
    };
    let size = (size("width", usual.0), size("height", usual.1));
    let pin = |nth: usize, name: &'a str, of: Node<'a, 'x>, inner: Node<'a, 'x>, x: f64| {
        let relative = first(inner, "relPosition");
        let y = match kind {
            "block" => 34.0 + 20.0 * nth as f64,
            _ => size.1 / 2.0,
        };
        let at = |name, usual| relative.and_then(|of| number(of, name)).unwrap_or(usual);
        Pin {
            name,
            at: (at("x", x), at("y", y)),
            negated: says(of, "negated"),
            node: inner,
        }
    };
    let named = |list: Vec<Node<'a, 'x>>, end: &'static str, x: f64| {
        let pins = list.into_iter().enumerate();
        let pins = pins.filter_map(|(nth, of)| {
            let name = of.attribute("formalParameter").unwrap_or_default();
            Some(pin(nth, name, of, first(of, end)?, x))
        });
        pins.collect::<Vec<_>>()
    };
    let plain = |end: &'static str, x: f64| {
        let pins = all(node, end).enumerate();
        pins.map(|(nth, of)| pin(nth, "", of, of, x))
            .collect::<Vec<_>>()
    };
    let mut inputs = named(ins, "connectionPointIn", 0.0);
    let mut outputs = named(outs, "connectionPointOut", size.0);
    inputs.extend(plain("connectionPointIn", 0.0));
    outputs.extend(plain("connectionPointOut", size.0));
    Element {
        node,
        kind,
        at: (at("x"), at("y")),
        size,
        inputs,
        outputs,
    }
}

fn written(node: Node<'_, '_>) -> String {
    let said = |name| node.attribute(name).unwrap_or_default().to_owned();
    match node.tag_name().name() {
        "block" => said("instanceName"),
        "label" | "jump" => said("label"),
        "connector" | "continuation" => said("name"),
        "comment" => first(node, "content")
            .map_or(String::new(), text)
            .trim()
            .to_owned(),
        _ => {
            let own = first(node, "variable").or_else(|| first(node, "expression"));
            own.map_or(String::new(), text).trim().to_owned()
        }
    }
}

/// The wires that lead to a pin: the element that each comes from, its output there, and the points between.
fn wires<'a, 'x: 'a>(
    pin: &Pin<'a, 'x>,
) -> impl Iterator<Item = (&'a str, &'a str, Vec<Point>)> + use<'a, 'x> {
    all(pin.node, "connection").filter_map(|wire| {
        let from = wire.attribute("refLocalId")?;
        let output = wire.attribute("formalParameter").unwrap_or_default();
        let points = all(wire, "position").map(|at| Some((number(at, "x")?, number(at, "y")?)));
        Some((
            from,
            output,
            points.collect::<Option<Vec<_>>>().unwrap_or_default(),
        ))
    })
}

fn by_id<'a>(elements: &[Element<'a, '_>]) -> HashMap<&'a str, usize> {
    let all = elements.iter().enumerate();
    all.filter_map(|(at, of)| Some((of.node.attribute("localId")?, at)))
        .collect()
}

/// More columns than this are drawn in the last.
const COLUMNS: usize = 40;

/// Puts each element in the column after those that it reads.
fn lay_out(elements: &mut [Element<'_, '_>]) {
    let by_id = by_id(elements);
    let mut columns = vec![0; elements.len()];
    for _ in 0..COLUMNS {
        let mut moved = false;
        for (at, element) in elements.iter().enumerate() {
            let wires = element.inputs.iter().flat_map(wires);
            let before = wires
                .filter_map(|(from, ..)| by_id.get(from))
                .filter(|from| **from != at);
            let column = before.map(|from| columns[*from] + 1).max().unwrap_or(0);
            if column > columns[at] && column < COLUMNS {
                columns[at] = column;
                moved = true;
            }
        }
        if !moved {
            break;
        }
    }
    let mut low = vec![20.0; COLUMNS];
    for (element, column) in elements.iter_mut().zip(columns) {
        element.at = (20.0 + 150.0 * column as f64, low[column]);
        low[column] += element.size.1 + 30.0;
    }
}

impl Element<'_, '_> {
    fn written(&self) -> String {
        written(self.node)
    }

    fn point(&self, pin: &Pin<'_, '_>) -> Point {
        (self.at.0 + pin.at.0, self.at.1 + pin.at.1)
    }

    fn draw(&self, to: &mut String) {
        let ((x, y), (wide, high)) = (self.at, self.size);
        let id = escaped(self.node.attribute("localId").unwrap_or_default());
        let _ = write!(
            to,
            "<g class=\"piece {}\" data-id=\"{id}\">",
            escaped(self.kind)
        );
        let (middle, base) = (x + wide / 2.0, y + high / 2.0 + 4.5);
        let said = self.written();
        let hit = |to: &mut String| {
            let _ = write!(
                to,
                "<rect class=\"hit\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
                x - 2.0,
                y - 16.0,
                wide + 4.0,
                high + 20.0
            );
        };
        match self.kind {
            "contact" | "coil" => {
                hit(to);
                let edge = match self.node.attribute("edge") {
                    Some("rising") => "P",
                    Some("falling") => "N",
                    _ => "",
                };
                let storage = match self.node.attribute("storage") {
                    Some("set") => "S",
                    Some("reset") => "R",
                    _ if says(self.node, "negated") => "/",
                    _ => edge,
                };
                let (left, right, low) = (middle - 5.0, middle + 5.0, y + high);
                let _ = match self.kind {
                    "contact" => write!(
                        to,
                        "<path d=\"M{left} {y}V{low}M{right} {y}V{low}M{x} {0}H{left}M{right} {0}H{1}\"/>",
                        y + high / 2.0,
                        x + wide
                    ),
                    _ => write!(
                        to,
                        "<path d=\"M{left} {y}Q{0} {1} {left} {low}M{right} {y}Q{2} {1} {right} {low}M{x} {1}H{3}M{4} {1}H{5}\"/>",
                        left - 5.0,
                        y + high / 2.0,
                        right + 5.0,
                        left - 2.5,
                        right + 2.5,
                        x + wide
                    ),
                };
                said_at(to, (middle, base), "middle", storage);
                said_at(to, (middle, y - 4.0), "middle", &said);
            }
            "block" => {
                rect(to, self);
                let name = self.node.attribute("typeName").unwrap_or_default();
                said_at(to, (middle, y + 14.0), "middle", name);
                said_at(to, (middle, y - 4.0), "middle", &said);
                for pin in &self.inputs {
                    said_at(to, (x + 4.0, y + pin.at.1 + 4.0), "start", pin.name);
                }
                for pin in &self.outputs {
                    said_at(to, (x + wide - 4.0, y + pin.at.1 + 4.0), "end", pin.name);
                }
                let round = |pin: &Pin<'_, '_>, by: f64| {
                    let (x, y) = self.point(pin);
                    format!("<circle cx=\"{}\" cy=\"{y}\" r=\"3\"/>", x + by)
                };
                let inputs = self.inputs.iter().filter(|pin| pin.negated);
                to.extend(inputs.map(|pin| round(pin, -3.0)));
                let outputs = self.outputs.iter().filter(|pin| pin.negated);
                to.extend(outputs.map(|pin| round(pin, 3.0)));
            }
            "leftPowerRail" | "rightPowerRail" => rect(to, self),
            "comment" => {
                rect(to, self);
                for (row, line) in said.lines().take(40).enumerate() {
                    said_at(to, (x + 4.0, y + 14.0 + 15.0 * row as f64), "start", line);
                }
            }
            "label" => said_at(to, (x, base), "start", &format!("{said}:")),
            "jump" => said_at(to, (x + 4.0, base), "start", &format!("→ {said}")),
            "return" => said_at(to, (x + 4.0, base), "start", "RETURN"),
            _ => {
                rect(to, self);
                said_at(to, (middle, base), "middle", &said);
            }
        }
        // When it runs, where the file says so.
        let order = self
            .node
            .attribute("executionOrderId")
            .filter(|order| *order != "0");
        if let Some(order) = order {
            said_at(to, (x + wide, y - 4.0), "end order", order);
        }
        to.push_str("</g>");
    }
}

fn rect(to: &mut String, of: &Element<'_, '_>) {
    let ((x, y), (wide, high)) = (of.at, of.size);
    let _ = write!(
        to,
        "<rect x=\"{x}\" y=\"{y}\" width=\"{wide}\" height=\"{high}\"/>"
    );
}

fn said_at(to: &mut String, (x, y): Point, class: &str, said: &str) {
    if !said.is_empty() {
        let _ = write!(
            to,
            "<text class=\"{class}\" x=\"{x}\" y=\"{y}\">{}</text>",
            escaped(said)
        );
    }
}

fn svg(elements: &[Element<'_, '_>], title: &str) -> String {
    let by_id = by_id(elements);
    let mut path = String::new();
    for element in elements {
        for pin in &element.inputs {
            for (from, output, points) in wires(pin) {
                let Some(from) = by_id.get(from).map(|at| &elements[*at]) else {
                    continue;
                };
                let mut outputs = from.outputs.iter();
                let output = outputs
                    .find(|pin| pin.name == output)
                    .or(from.outputs.first());
                let Some(output) = output else { continue };
                let ((x, y), (end_x, end_y)) = (from.point(output), element.point(pin));
                let _ = match points.len() > 2 {
                    true => {
                        // The file has them from the input back to the output.
                        let _ = write!(path, "M{end_x} {end_y}");
                        points
                            .iter()
                            .try_for_each(|(x, y)| write!(path, "L{x} {y}"))
                    }
                    false => write!(path, "M{x} {y}H{}V{end_y}H{end_x}", (x + end_x) / 2.0),
                };
            }
        }
    }
    let edge = |of: fn(&Element<'_, '_>) -> f64, pick: fn(f64, f64) -> f64| {
        elements.iter().map(of).reduce(pick).unwrap_or(0.0)
    };
    let (left, top) = (
        edge(|of| of.at.0, f64::min) - 20.0,
        edge(|of| of.at.1, f64::min) - 30.0,
    );
    let right = edge(|of| of.at.0 + of.size.0, f64::max) + 30.0;
    let low = edge(|of| of.at.1 + of.size.1, f64::max) + 30.0;
    let (wide, high) = (right - left, low - top);
    let mut to = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"drawn\" role=\"img\" aria-label=\"{}\" width=\"{wide}\" height=\"{high}\" \
         viewBox=\"{left} {top} {wide} {high}\"><path class=\"wires\" d=\"{path}\"/>",
        escaped(title)
    );
    elements.iter().for_each(|element| element.draw(&mut to));
    to.push_str("</svg>");
    to
}
