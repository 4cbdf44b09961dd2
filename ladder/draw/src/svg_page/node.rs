//! An element of SVG, written as it is made: a drawing of 100 rungs has 5,000, and is drawn at each key.
//!
//! Attributes are sorted, and an element within another begins a line, so that files can be compared.

use std::fmt::Write;

/// An element with its attributes, and the text of all that stands within.
pub(super) struct Node {
    tag: &'static str,
    /// The values of the attributes, one after another.
    values: String,
    /// The attributes, each with the end of its value.
    attributes: Vec<(&'static str, usize)>,
    within: String,
    /// Whether words stand within, and no elements.
    is_bare: bool,
}

impl Default for Node {
    fn default() -> Node {
        Node::group()
    }
}

impl Node {
    fn new(tag: &'static str) -> Node {
        Node {
            tag,
            values: String::new(),
            attributes: Vec::new(),
            within: String::new(),
            is_bare: false,
        }
    }

    /// Words, which are escaped.
    fn of_words(tag: &'static str, words: &str) -> Node {
        let mut node = Node::new(tag);
        node.is_bare = true;
        escape(words, &['&', '<', '>'], &mut node.within);
        node
    }

    pub(super) fn group() -> Node {
        Node::new("g")
    }

    pub(super) fn path() -> Node {
        Node::new("path")
    }

    pub(super) fn rectangle() -> Node {
        Node::new("rect")
    }

    pub(super) fn text(words: &str) -> Node {
        Node::of_words("text", words)
    }

    pub(super) fn title(words: &str) -> Node {
        Node::of_words("title", words)
    }

    pub(super) fn document() -> Node {
        Node::new("svg").set("xmlns", "http://www.w3.org/2000/svg")
    }

    /// It with this attribute.
    pub(super) fn set(mut self, name: &'static str, value: impl Value) -> Node {
        self.unset(name);
        value.write(&mut self.values);
        self.attributes.push((name, self.values.len()));
        self
    }

    fn unset(&mut self, name: &str) {
        let Some(at) = self.attributes.iter().position(|(own, _)| *own == name) else {
            return;
        };
        let (_, end) = self.attributes.remove(at);
        let begin = at
            .checked_sub(1)
            .map_or(0, |before| self.attributes[before].1);
        self.values.replace_range(begin..end, "");
        for (_, behind) in &mut self.attributes[at..] {
            *behind -= end - begin;
        }
    }

    /// It with this within, after what it has already.
    pub(super) fn with(mut self, node: Node) -> Node {
        self.add(node);
        self
    }

    /// Puts this within, after what it has already.
    pub(super) fn add(&mut self, node: Node) {
        self.within.push('\n');
        node.write(&mut self.within);
    }

    fn write(self, to: &mut String) {
        let begins = std::iter::once(0).chain(self.attributes.iter().map(|(_, end)| *end));
        let values = begins.zip(&self.attributes);
        let mut sorted: Vec<(&str, &str)> = values
            .map(|(begin, &(name, end))| (name, &self.values[begin..end]))
            .collect();
        sorted.sort_unstable();
        to.push('<');
        to.push_str(self.tag);
        for (name, value) in sorted {
            to.extend([" ", name, "=\"", value, "\""]);
        }
        if self.within.is_empty() && !self.is_bare {
            return to.push_str("/>");
        }
        to.push('>');
        to.push_str(&self.within);
        if !self.is_bare {
            to.push('\n');
        }
        to.extend(["</", self.tag, ">"]);
    }

    /// The text of it.
    pub(super) fn written(self) -> String {
        let mut text = String::new();
        self.write(&mut text);
        text
    }
}

/// The value of an attribute.
pub(super) trait Value {
    fn write(&self, to: &mut String);
}

impl Value for &str {
    fn write(&self, to: &mut String) {
        escape(self, &QUOTED, to);
    }
}

impl Value for String {
    fn write(&self, to: &mut String) {
        escape(self, &QUOTED, to);
    }
}

impl Value for f32 {
    fn write(&self, to: &mut String) {
        number(*self, to);
    }
}

impl Value for u32 {
    fn write(&self, to: &mut String) {
        digits(*self, to);
    }
}

impl Value for usize {
    fn write(&self, to: &mut String) {
        digits(u32::try_from(*self).unwrap_or(u32::MAX), to);
    }
}

/// A rectangle.
impl Value for (f32, f32, f32, f32) {
    fn write(&self, to: &mut String) {
        let (x, y, width, height) = *self;
        for (index, value) in [x, y, width, height].into_iter().enumerate() {
            if index > 0 {
                to.push(' ');
            }
            number(value, to);
        }
    }
}

/// What stands otherwise in a value.
const QUOTED: [char; 5] = ['&', '<', '>', '"', '\''];

/// A number as short as it can be. Nearly all are halves, which take no division of fractions.
pub(super) fn number(value: f32, to: &mut String) {
    let halves = value * 2.0;
    if halves.fract() == 0.0 && (0.0..=1e6).contains(&halves) {
        let halves = halves as u32;
        digits(halves / 2, to);
        if halves % 2 == 1 {
            to.push_str(".5");
        }
    } else {
        let _ = write!(to, "{value}");
    }
}

/// A whole number: there are 25,000 of them in a drawing of 100 rungs.
pub(super) fn digits(value: u32, to: &mut String) {
    if value > 9 {
        digits(value / 10, to);
    }
    to.push(char::from(b'0' + (value % 10) as u8));
}

/// The data of a path: letters, each followed by numbers.
pub(super) fn data(parts: &[(char, &[f32])]) -> String {
    let mut data = String::new();
    for (letter, numbers) in parts {
        data.push(*letter);
        for (index, value) in numbers.iter().enumerate() {
            if index > 0 {
                data.push(' ');
            }
            number(*value, &mut data);
        }
    }
    data
}

fn escape(text: &str, signs: &[char], to: &mut String) {
    for part in text.split_inclusive(signs) {
        let plain = part.trim_end_matches(signs);
        to.push_str(plain);
        to.push_str(match part[plain.len()..].chars().next() {
            Some('&') => "&amp;",
            Some('<') => "&lt;",
            Some('>') => "&gt;",
            Some('"') => "&quot;",
            Some(_) => "&apos;",
            None => "",
        });
    }
}

#[cfg(test)]
mod tests {
    use super::{Node, number};

    #[test]
    fn elements_stand_in_lines_and_attributes_in_order() {
        let text = Node::text("a < b & \"c\"")
            .set("y", 2.5_f32)
            .set("x", 3.0_f32)
            .set("x", 1.0_f32);
        let group = Node::group().with(text).with(Node::path().set("d", "M1 2"));
        let document = Node::document().set("viewBox", (0.0, 0.0, 1.5, 2.0));
        assert_eq!(
            document.with(group).with(Node::text("")).written(),
            "<svg viewBox=\"0 0 1.5 2\" xmlns=\"http://www.w3.org/2000/svg\">\n<g>\n\
             <text x=\"1\" y=\"2.5\">a &lt; b &amp; \"c\"</text>\n<path d=\"M1 2\"/>\n</g>\n<text></text>\n</svg>"
        );
    }

    #[test]
    fn a_number_is_as_short_as_it_can_be() {
        for value in [0.0, 0.5, 1.0, 7.25, -3.5, -4.0, 12345.5, 0.1, 1e9_f32] {
            let mut text = String::new();
            number(value, &mut text);
            assert_eq!(text, value.to_string());
        }
    }
}
