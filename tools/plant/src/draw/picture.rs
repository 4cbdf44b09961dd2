//! The elements of a drawing.

use std::fmt::Write;

/// An attribute.
pub(super) type Attribute = (&'static str, String);

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
    pub id: Option<String>,
    pub attributes: Vec<Attribute>,
    pub text: String,
}

/// A drawing: as a text, or as what has changed since another of the same plant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    pub(super) width: i32,
    pub(super) height: i32,
    pub(super) title: String,
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
                    head(text, element);
                    text.push('>');
                    open.push(element.tag);
                }
                Item::Close => {
                    if let Some(tag) = open.pop() {
                        let _ = write!(text, "</{tag}>");
                    }
                }
                Item::Leaf(element) => {
                    head(text, element);
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

    /// What is other in this one than in that one.
    pub fn changes(&self, before: &Picture) -> Vec<Change> {
        let mut changes = Vec::new();
        for pair in self.items.iter().zip(&before.items) {
            let (Item::Leaf(now) | Item::Open(now), Item::Leaf(was) | Item::Open(was)) = pair
            else {
                continue;
            };
            let Some(id) = &now.id else { continue };
            for (attribute, value) in &now.attributes {
                let same = was
                    .attributes
                    .iter()
                    .any(|(name, held)| name == attribute && held == value);
                if !same {
                    changes.push(Change {
                        id: id.clone(),
                        attribute: Some(attribute),
                        value: value.clone(),
                    });
                }
            }
            if now.text != was.text {
                changes.push(Change {
                    id: id.clone(),
                    attribute: None,
                    value: now.text.clone(),
                });
            }
        }
        changes
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

fn head(text: &mut String, element: &Element) {
    let _ = write!(text, "<{}", element.tag);
    if let Some(id) = &element.id {
        text.push_str(" id=\"");
        escaped(text, id);
        text.push('"');
    }
    for (name, value) in &element.attributes {
        let _ = write!(text, " {name}=\"");
        escaped(text, value);
        text.push('"');
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
