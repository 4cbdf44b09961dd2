//! What a symbol is drawn with.

use super::picture::{Attribute, Element, Item};
use crate::plant::Part;
use crate::run::Run;
use unoclp_words::Lang;

/// Draws a part at its place; what changes is named by the part and by what it is.
pub(crate) struct Brush<'a> {
    pub run: &'a Run<'a>,
    pub number: usize,
    pub part: &'a Part,
    pub lang: Lang,
    pub(super) items: &'a mut Vec<Item>,
    /// What the next element is, if it changes.
    pub(super) live: Option<&'static str>,
    /// Counts elements of the same name.
    pub(super) twin: usize,
}

impl Brush<'_> {
    /// A value of the part.
    pub fn get(&self, value: impl Into<usize>) -> i32 {
        self.run.value(self.number, value.into())
    }

    /// A value of a row of the part.
    pub fn row(&self, value: impl Into<usize>, at: usize) -> i32 {
        self.run.row(self.number, value.into(), at)
    }

    /// Whether a flag of it is set.
    pub fn is(&self, value: impl Into<usize>) -> bool {
        self.get(value) != 0
    }

    /// A number that it was given, or the place of its choice.
    pub fn given(&self, field: impl Into<usize>) -> i32 {
        self.part.number(field.into())
    }

    /// What people call it.
    pub fn label(&self) -> String {
        self.part.label.text(self.lang).to_owned()
    }

    /// The next element changes, and is called so.
    pub fn live(&mut self, name: &'static str) -> &mut Self {
        self.live = Some(name);
        self
    }

    fn add(&mut self, tag: &'static str, class: &str, attributes: Vec<Attribute>, text: String) {
        let element = self.element(tag, class, attributes, text);
        self.items.push(Item::Leaf(element));
    }

    fn element(
        &mut self,
        tag: &'static str,
        class: &str,
        mut attributes: Vec<Attribute>,
        text: String,
    ) -> Element {
        if !class.is_empty() {
            attributes.insert(0, ("class", class.to_owned()));
        }
        let id = self.live.take().map(|name| match self.twin {
            0 => format!("{}-{name}", self.part.name),
            twin => format!("{}-{name}-{twin}", self.part.name),
        });
        Element {
            tag,
            id,
            attributes,
            text,
        }
    }

    /// A group that is moved, turned or hidden as a whole.
    pub fn group(&mut self, attributes: Vec<Attribute>, draw: impl FnOnce(&mut Self)) {
        let element = self.element("g", "", attributes, String::new());
        self.items.push(Item::Open(element));
        draw(self);
        self.items.push(Item::Close);
    }

    /// A group that is moved by so much.
    pub fn moved(&mut self, x: i32, y: i32, draw: impl FnOnce(&mut Self)) {
        self.group(vec![("transform", format!("translate({x},{y})"))], draw);
    }

    /// A group that is turned by so many degrees about a point.
    pub fn turned(&mut self, degrees: i32, [x, y]: [i32; 2], draw: impl FnOnce(&mut Self)) {
        let turn = format!("rotate({degrees},{x},{y})");
        self.group(vec![("transform", turn)], draw);
    }

    /// A group that is there or not.
    pub fn shown(&mut self, is: bool, draw: impl FnOnce(&mut Self)) {
        let display = if is { "inline" } else { "none" };
        self.group(vec![("display", display.to_owned())], draw);
    }

    pub fn rect(&mut self, [x, y, w, h]: [i32; 4], round: i32, class: &str) {
        let of = |name: &'static str, value: i32| (name, value.to_string());
        let mut all = vec![
            of("x", x),
            of("y", y),
            of("width", w.max(0)),
            of("height", h.max(0)),
        ];
        if round > 0 {
            all.push(of("rx", round));
        }
        self.add("rect", class, all, String::new());
    }

    pub fn circle(&mut self, [x, y]: [i32; 2], r: i32, class: &str) {
        let of = |name: &'static str, value: i32| (name, value.to_string());
        self.add(
            "circle",
            class,
            vec![of("cx", x), of("cy", y), of("r", r)],
            String::new(),
        );
    }

    pub fn ellipse(&mut self, [x, y]: [i32; 2], [rx, ry]: [i32; 2], class: &str) {
        let of = |name: &'static str, value: i32| (name, value.to_string());
        let all = vec![of("cx", x), of("cy", y), of("rx", rx), of("ry", ry)];
        self.add("ellipse", class, all, String::new());
    }

    pub fn path(&mut self, d: &str, class: &str) {
        self.add("path", class, vec![("d", d.to_owned())], String::new());
    }

    pub fn line(&mut self, [x1, y1]: [i32; 2], [x2, y2]: [i32; 2], class: &str) {
        self.path(&format!("M{x1} {y1}L{x2} {y2}"), class);
    }

    pub fn text(&mut self, [x, y]: [i32; 2], class: &str, text: impl Into<String>) {
        let all = vec![("x", x.to_string()), ("y", y.to_string())];
        self.add("text", class, all, text.into());
    }

    /// The label below or beside the symbol.
    pub fn name(&mut self, at: [i32; 2]) {
        let label = self.label();
        self.text(at, "label", label);
    }
}

/// The class of a colour, lit or not.
pub(crate) fn colour(name: i32, lit: bool) -> &'static str {
    match (name, lit) {
        (0, true) => "green-on",
        (0, false) => "green-off",
        (1, true) => "red-on",
        (1, false) => "red-off",
        (2, true) => "yellow-on",
        (2, false) => "yellow-off",
        (3, true) => "blue-on",
        (3, false) => "blue-off",
        (_, true) => "white-on",
        (_, false) => "white-off",
    }
}
