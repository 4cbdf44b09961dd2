//! The elements of a drawing.

use crate::plant::Plant;
use std::borrow::Cow;
use std::fmt::{self, Write};

/// An attribute.
pub(super) type Attribute = (&'static str, Value);

/// What an attribute is: written out only where somebody reads it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Value {
    Text(Cow<'static, str>),
    Number(i32),
    /// A share of 1, below it.
    Hundredths(i32),
    /// Moved by so much.
    Moved(i32, i32),
    /// Turned by so many degrees about a point.
    Turned(i32, [i32; 2]),
    /// A way from one point to another.
    Line([i32; 2], [i32; 2]),
}

impl From<&'static str> for Value {
    fn from(text: &'static str) -> Value {
        Value::Text(text.into())
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Text(text) => f.write_str(text),
            Value::Number(number) => number.fmt(f),
            Value::Hundredths(share) => write!(f, "0.{share:02}"),
            Value::Moved(x, y) => write!(f, "translate({x},{y})"),
            Value::Turned(degrees, [x, y]) => write!(f, "rotate({degrees},{x},{y})"),
            Value::Line([x1, y1], [x2, y2]) => write!(f, "M{x1} {y1}L{x2} {y2}"),
        }
    }
}

/// What an element that changes is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Id {
    /// The time.
    Time,
    /// A drawn line, by its number.
    Drawn(usize),
    /// Something of a part, by its number; the first of that name is 0.
    Of {
        part: usize,
        what: &'static str,
        twin: usize,
    },
}

impl Id {
    /// As a text, where parts are called so.
    fn text<'n>(self, name: impl Fn(usize) -> Option<&'n String>) -> String {
        match self {
            Id::Time => "time".to_owned(),
            Id::Drawn(number) => format!("drawn-{number}"),
            Id::Of { part, what, twin } => {
                let name = name(part).map_or("", String::as_str);
                match twin {
                    0 => format!("{name}-{what}"),
                    twin => format!("{name}-{what}-{twin}"),
                }
            }
        }
    }
}

/// A part of a drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Item {
    /// The begin of a group.
    Open(Element),
    /// The end of the group that was begun last.
    Close,
    /// What stands alone.
    Leaf(Element),
}

/// An element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Element {
    pub tag: &'static str,
    /// Of what changes.
    pub id: Option<Id>,
    pub attributes: Vec<Attribute>,
    pub text: String,
}

/// A drawing, as a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    pub(super) width: i32,
    pub(super) height: i32,
    pub(super) title: String,
    pub(super) items: Vec<Item>,
    /// What its parts are called.
    pub(super) names: Vec<String>,
}

/// What changes of a drawing, at a moment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Live {
    pub(super) items: Vec<Item>,
}

/// What has changed in a drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// The element's.
    pub id: String,
    /// The attribute; none: its text.
    pub attribute: Option<&'static str>,
    /// What that is now.
    pub value: String,
}

impl Picture {
    /// Its width and height.
    pub fn size(&self) -> (u32, u32) {
        (self.width.unsigned_abs(), self.height.unsigned_abs())
    }

    /// As a text in SVG.
    pub fn svg(&self) -> String {
        let (width, height) = (self.width, self.height);
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\" role=\"img\"><title>"
        );
        escaped(&mut text, &self.title);
        let _ = write!(text, "</title><style>{}</style>", super::style::STYLE);
        self.inner(&mut text);
        text.push_str("</svg>\n");
        text
    }

    /// Its elements, to stand within another drawing.
    pub(super) fn inner(&self, text: &mut String) {
        let mut open: Vec<&'static str> = Vec::new();
        for item in &self.items {
            match item {
                Item::Open(element) => {
                    self.head(text, element);
                    text.push('>');
                    open.push(element.tag);
                }
                Item::Close => {
                    if let Some(tag) = open.pop() {
                        let _ = write!(text, "</{tag}>");
                    }
                }
                Item::Leaf(element) => {
                    self.head(text, element);
                    if element.text.is_empty() {
                        text.push_str("/>");
                    } else {
                        text.push('>');
                        escaped(text, &element.text);
                        let _ = write!(text, "</{}>", element.tag);
                    }
                }
            }
        }
    }

    fn head(&self, text: &mut String, element: &Element) {
        let _ = write!(text, "<{}", element.tag);
        if let Some(id) = element.id {
            text.push_str(" id=\"");
            escaped(text, &id.text(|part| self.names.get(part)));
            text.push('"');
        }
        for (name, value) in &element.attributes {
            let _ = write!(text, " {name}=\"");
            escaped(text, &value.to_string());
            text.push('"');
        }
    }

    /// Several in a row below each other, as one drawing.
    pub fn strip(pictures: &[Picture]) -> String {
        let width = pictures
            .iter()
            .map(|picture| picture.width)
            .max()
            .unwrap_or(0);
        let height: i32 = pictures.iter().map(|picture| picture.height).sum();
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\"><style>{}</style>",
            super::style::STYLE
        );
        let mut y = 0;
        for picture in pictures {
            let _ = write!(text, "<g transform=\"translate(0,{y})\">");
            // One drawing has each name once.
            let plain = Picture {
                items: picture.items.iter().map(without_id).collect(),
                ..picture.clone()
            };
            plain.inner(&mut text);
            text.push_str("</g>");
            y += picture.height;
        }
        text.push_str("</svg>\n");
        text
    }
}

impl Live {
    /// What is other in this one than in that one of the same plant.
    pub fn changes(&self, before: &Live, plant: &Plant) -> Vec<Change> {
        let name = |part: usize| plant.parts.get(part).map(|own| &own.name);
        let mut changes = Vec::new();
        for pair in self.items.iter().zip(&before.items) {
            let (Item::Leaf(now) | Item::Open(now), Item::Leaf(was) | Item::Open(was)) = pair
            else {
                continue;
            };
            let Some(id) = now.id else { continue };
            for attribute in &now.attributes {
                if !was.attributes.contains(attribute) {
                    let (name_of, value) = attribute;
                    changes.push(Change {
                        id: id.text(name),
                        attribute: Some(name_of),
                        value: value.to_string(),
                    });
                }
            }
            if now.text != was.text {
                changes.push(Change {
                    id: id.text(name),
                    attribute: None,
                    value: now.text.clone(),
                });
            }
        }
        changes
    }
}

fn without_id(item: &Item) -> Item {
    let plain = |element: &Element| Element {
        id: None,
        ..element.clone()
    };
    match item {
        Item::Open(element) => Item::Open(plain(element)),
        Item::Leaf(element) => Item::Leaf(plain(element)),
        Item::Close => Item::Close,
    }
}

/// A text in which nothing means anything to XML.
fn escaped(into: &mut String, text: &str) {
    for sign in text.chars() {
        match sign {
            '<' => into.push_str("&lt;"),
            '>' => into.push_str("&gt;"),
            '&' => into.push_str("&amp;"),
            '"' => into.push_str("&quot;"),
            '\'' => into.push_str("&#39;"),
            sign if sign.is_control() => into.push(' '),
            sign => into.push(sign),
        }
    }
}
