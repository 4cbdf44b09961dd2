//! Elements of a drawn body that come and go: contacts, coils, values, variables and blocks, with the wires that follow them.
//! What stands in their way makes room; all else of the file stays as it is.
//!
//! - `sheet`: what is drawn; `new`: what is drawn anew; `signature`: the pins of a new block
//! - `erase`: what is gone; `passage`: what stands for its outputs then

mod erase;
mod new;
mod passage;
mod sheet;
mod signature;

pub use erase::erase;

use crate::alter::attribute;
use crate::bodies::body;
use crate::edges::{append, lead, removed, spliced};
use crate::export::escaped;
use crate::found::Found;
use crate::rows;
use crate::xml::{self, all, first, within};
use new::New;
use roxmltree::Node;
use sheet::{Sheet, connection};
use signature::takes_more;
use std::fmt::Write as _;
use std::ops::Range;

/// Where something new stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Where {
    /// In series, right before an element.
    Before,
    /// In series, right after it.
    After,
    /// In parallel to it; in a block diagram where the same value leads to.
    Beside,
    /// In a network of its own, below all others.
    Below,
}

type Piece = (Range<usize>, String);

/// The room that an element takes, to the next one and to the next row.
const COLUMN: f64 = 80.0;
const ROW: f64 = 60.0;
/// The room of a block with the values before it.
const BLOCK: f64 = 180.0;

/// A project in which something new is drawn in a unit: `contact`, `coil`, `value`, `variable`, or the name of a block or function.
/// None where it cannot stand there. Its number in the file is the largest of its body.
pub fn draw(text: &str, unit: &str, place: Where, at: &str, what: &str) -> Option<String> {
    let tree = xml::parse(text, &mut Found::default())?;
    let root = tree.root_element();
    let sheet = Sheet::of(text, body(root, unit)?)?;
    let new = New::of(&sheet, root, unit, what)?;
    let mut grown = Grown {
        sheet: &sheet,
        pieces: Vec::new(),
        last: sheet.last,
    };
    grown.put(&new, place, at)?;
    let drawn = spliced(text, grown.pieces);
    match &new.instance {
        Some((name, kind)) => rows::add(&drawn, Some(unit), "localVars", name, kind),
        None => Some(drawn),
    }
}

/// A body that grows.
struct Grown<'s, 't, 'a, 'x> {
    sheet: &'s Sheet<'t, 'a, 'x>,
    pieces: Vec<Piece>,
    last: u64,
}

impl<'a, 'x: 'a> Grown<'_, '_, 'a, 'x> {
    fn put(&mut self, new: &New, place: Where, at: &str) -> Option<()> {
        if place == Where::Below {
            return self.below(new);
        }
        let sheet = self.sheet;
        let node = sheet.element(at)?;
        let kind = node.tag_name().name();
        let is_end = matches!(kind, "rightPowerRail" | "outVariable" | "jump" | "return");
        let is_begin = matches!(kind, "leftPowerRail" | "inVariable" | "continuation");
        let is_beside = matches!(kind, "comment" | "label" | "vendorElement");
        let stands = match (place, new.kind) {
            _ if is_beside => false,
            (Where::After, "inVariable") | (Where::Before, "outVariable") => false,
            (Where::After, "outVariable") => !is_end,
            (Where::After, _) => !is_end && (kind != "coil" || new.kind == "coil"),
            (Where::Before, "inVariable") => kind == "block",
            (Where::Before, _) => !is_begin,
            (Where::Beside, "inVariable") => kind == "block",
            (Where::Beside, _) => !is_begin && !is_end || kind == "outVariable",
            (Where::Below, _) => true,
        };
        if !stands {
            return None;
        }
        let (x, y) = sheet.place(node).unwrap_or((20.0, 20.0));
        let wide = if new.kind == "block" { BLOCK } else { COLUMN };
        let high = 20.0 * new.rows().saturating_sub(1) as f64;
        let own = sheet.power(node);
        match (place, new.kind) {
            (_, "inVariable") => self.input(node, &new.written, (x, y)),
            (Where::After, "outVariable") => {
                let from = vec![connection(at, sheet.output(node, at))];
                self.room(|place| place.1 > y + 30.0, (0.0, ROW));
                self.element(new, &from, (x + 2.0 * COLUMN, y + ROW), node.range().end);
                Some(())
            }
            (Where::After, _) => {
                let output = sheet.output(node, at);
                let from = vec![connection(at, output)];
                self.room(|place| place.0 > x, (wide, 0.0));
                self.room_below(y, high);
                let end = node.range().end;
                let shift = self.width(node);
                let id = self.element(new, &from, (x + shift + wide - COLUMN, y), end);
                for wire in sheet.readers_of(at, output) {
                    let to = connection(&id, new.output());
                    self.pieces.push((wire.range(), to));
                }
                Some(())
            }
            (Where::Before, _) => {
                let own = own?;
                let from = sheet.wires(own);
                self.room(|place| place.0 >= x, (wide, 0.0));
                self.room_below(y, high);
                let id = self.element(new, &from, (x + wide - COLUMN, y), node.range().start);
                self.rewire(own, &connection(&id, new.output()));
                Some(())
            }
            (Where::Beside, _) => {
                let from = own.map_or(Vec::new(), |pin| sheet.wires(pin));
                self.room(|place| place.1 > y + 10.0, (0.0, ROW + high));
                let id = self.element(new, &from, (x, y + ROW), node.range().end);
                if new.kind == "outVariable" {
                    return Some(());
                }
                let mut pins: Vec<Node<'a, 'x>> = Vec::new();
                for wire in sheet.readers_of(at, sheet.output(node, at)) {
                    let pin = wire.parent()?;
                    if !pins.contains(&pin) {
                        pins.push(pin);
                        let more = append(sheet.text, pin, &connection(&id, new.output()))?;
                        self.pieces.push(more);
                    }
                }
                Some(())
            }
            (Where::Below, _) => None,
        }
    }

    /// One more input of a block, with its value.
    fn input(&mut self, block: Node<'a, 'x>, value: &str, (x, y): (f64, f64)) -> Option<()> {
        let sheet = self.sheet;
        let list = first(block, "inputVariables")?;
        let kind = block.attribute("typeName").unwrap_or_default();
        let pins: Vec<Node<'_, '_>> = all(list, "variable").collect();
        let points = pins
            .iter()
            .filter_map(|pin| first(*pin, "connectionPointIn"));
        let open = points.rev().find(|pin| sheet.wires(*pin).is_empty());
        let at = (x - COLUMN, y + 24.0 + 20.0 * pins.len() as f64);
        let (id, value) = self.value(value, at);
        let start = block.range().start;
        let lead = lead(sheet.text, block).to_owned();
        self.pieces.push((start..start, value + &lead));
        let wire = connection(&id, None);
        let piece = match open {
            Some(pin) => append(sheet.text, pin, &wire)?,
            None if !takes_more(kind) => return None,
            None => {
                let last = pins.last()?.attribute("formalParameter")?;
                let number: u32 = last.strip_prefix("IN")?.parse().ok()?;
                let pin = pin(&format!("IN{}", number + 1), &wire);
                append(sheet.text, list, &pin)?
            }
        };
        self.pieces.push(piece);
        Some(())
    }

    /// A network below all others.
    fn below(&mut self, new: &New) -> Option<()> {
        let sheet = self.sheet;
        let nodes = sheet.body.children().filter(Node::is_element);
        let lows = nodes.filter_map(|node| {
            let high = node
                .attribute("height")
                .and_then(|high| high.parse::<f64>().ok());
            Some(sheet.place(node)?.1 + high.unwrap_or(20.0))
        });
        let y = lows.reduce(f64::max).unwrap_or(0.0) + 40.0;
        let mut to = String::new();
        let mut wires = Vec::new();
        if !sheet.is_blocks {
            let id = self.next();
            let _ = write!(
                to,
                "<leftPowerRail localId=\"{id}\" height=\"40\" width=\"10\"><position x=\"20\" y=\"{}\"/><connectionPointOut formalParameter=\"\"><relPosition x=\"10\" y=\"20\"/></connectionPointOut></leftPowerRail>",
                y - 12.0
            );
            wires.push(connection(&id, None));
        } else if new.kind == "outVariable" {
            let (id, value) = self.value("FALSE", (20.0, y));
            to += &value;
            wires.push(connection(&id, None));
        }
        let x = if new.kind == "block" { 200.0 } else { 120.0 };
        // What is new has the largest number.
        let end = (!sheet.is_blocks).then(|| self.next());
        let (id, more) = self.written(new, &wires, (x, y));
        if let Some(end) = end {
            let from = connection(&id, new.output());
            let _ = write!(
                to,
                "<rightPowerRail localId=\"{end}\" height=\"40\" width=\"10\"><position x=\"{}\" y=\"{}\"/><connectionPointIn><relPosition x=\"0\" y=\"20\"/>{from}</connectionPointIn></rightPowerRail>",
                x + 200.0,
                y - 12.0
            );
        }
        to += &more;
        let piece = append(sheet.text, sheet.body, &to)?;
        self.pieces.push(piece);
        Some(())
    }

    /// Puts an element into the file at this byte, with wires to its power; its number.
    fn element(&mut self, new: &New, from: &[String], at: (f64, f64), byte: usize) -> String {
        let (id, written) = self.written(new, from, at);
        self.pieces.push((byte..byte, written));
        id
    }

    /// An element, after the values that it takes; its number is the largest.
    fn written(&mut self, new: &New, from: &[String], (x, y): (f64, f64)) -> (String, String) {
        let wires: String = from.concat();
        let written = escaped(&new.written);
        let mut to = String::new();
        let mut pins = String::new();
        for (row, (name, value)) in new.signature.inputs.iter().enumerate() {
            let is_power = new.signature.power.as_deref() == Some(name);
            let wire = match value {
                _ if is_power && !from.is_empty() => wires.clone(),
                None => String::new(),
                Some(value) => {
                    let at = (x - COLUMN, y + 18.0 + 20.0 * row as f64);
                    let (id, element) = self.value(value, at);
                    to += &element;
                    connection(&id, None)
                }
            };
            pins += &pin(name, &wire);
        }
        let id = self.next();
        let _ = match new.kind {
            "block" => {
                let instance = new.instance.as_ref().map_or(String::new(), |(name, _)| {
                    format!(" instanceName=\"{}\"", escaped(name))
                });
                let outputs = new.signature.outputs.iter();
                let outputs: String = outputs
                    .map(|name| {
                        format!(
                            "<variable formalParameter=\"{}\"><connectionPointOut/></variable>",
                            escaped(name)
                        )
                    })
                    .collect();
                let high = 30 + 20 * new.rows().max(1);
                write!(
                    to,
                    "<block localId=\"{id}\" typeName=\"{written}\"{instance} height=\"{high}\" width=\"90\"><position x=\"{x}\" y=\"{y}\"/><inputVariables>{pins}</inputVariables><inOutVariables/><outputVariables>{outputs}</outputVariables></block>"
                )
            }
            "inVariable" => to.write_str(&in_variable(&id, &written, (x, y))),
            "outVariable" => write!(
                to,
                "<outVariable localId=\"{id}\" height=\"24\" width=\"60\"><position x=\"{x}\" y=\"{y}\"/><connectionPointIn>{wires}</connectionPointIn><expression>{written}</expression></outVariable>"
            ),
            kind => write!(
                to,
                "<{kind} localId=\"{id}\" height=\"15\" width=\"21\"><position x=\"{x}\" y=\"{y}\"/><connectionPointIn><relPosition x=\"0\" y=\"7\"/>{wires}</connectionPointIn><connectionPointOut><relPosition x=\"21\" y=\"7\"/></connectionPointOut><variable>{written}</variable></{kind}>"
            ),
        };
        (id, to)
    }

    fn value(&mut self, expression: &str, at: (f64, f64)) -> (String, String) {
        let id = self.next();
        let value = in_variable(&id, &escaped(expression), at);
        (id, value)
    }

    fn next(&mut self) -> String {
        self.last += 1;
        self.last.to_string()
    }

    /// The only wire of a pin is this one.
    fn rewire(&mut self, pin: Node<'a, 'x>, wire: &str) {
        let mut own = all(pin, "connection");
        match own.next() {
            Some(first) => self.pieces.push((first.range(), wire.to_owned())),
            None => self.pieces.extend(append(self.sheet.text, pin, wire)),
        }
        self.pieces
            .extend(own.map(|other| removed(self.sheet.text, other)));
    }

    fn width(&self, node: Node<'_, '_>) -> f64 {
        let wide = node.attribute("width").and_then(|wide| wide.parse().ok());
        COLUMN.max(wide.unwrap_or(0.0) + 40.0)
    }

    fn room_below(&mut self, y: f64, high: f64) {
        if high > 0.0 {
            self.room(|place| place.1 > y + 10.0, (0.0, high));
        }
    }

    /// Moves the elements that stand there, and lets wires find their ways.
    fn room(&mut self, moves: impl Fn((f64, f64)) -> bool, by: (f64, f64)) {
        let sheet = self.sheet;
        let mut moved = Vec::new();
        for node in sheet.body.children().filter(Node::is_element) {
            let (Some(at), Some(position)) = (sheet.place(node), first(node, "position")) else {
                continue;
            };
            if !moves(at) {
                continue;
            }
            for (name, value, by) in [("x", at.0, by.0), ("y", at.1, by.1)] {
                if by != 0.0 {
                    let piece =
                        attribute(sheet.text, position, name, Some(&(value + by).to_string()));
                    self.pieces.extend(piece);
                }
            }
            moved.extend(node.attribute("localId"));
        }
        let is_moved = |id: Option<&str>| id.is_some_and(|id| moved.contains(&id));
        for node in sheet.body.children().filter(Node::is_element) {
            let is_end = is_moved(node.attribute("localId"));
            for wire in within(node, "connection") {
                if is_end || is_moved(wire.attribute("refLocalId")) {
                    let points = all(wire, "position");
                    self.pieces
                        .extend(points.map(|point| removed(sheet.text, point)));
                }
            }
        }
    }
}

/// A value.
fn in_variable(id: &str, expression: &str, (x, y): (f64, f64)) -> String {
    format!(
        "<inVariable localId=\"{id}\" height=\"24\" width=\"60\"><position x=\"{x}\" y=\"{y}\"/><connectionPointOut/><expression>{expression}</expression></inVariable>"
    )
}

/// An input of a block.
fn pin(name: &str, wires: &str) -> String {
    format!(
        "<variable formalParameter=\"{}\"><connectionPointIn>{wires}</connectionPointIn></variable>",
        escaped(name)
    )
}
