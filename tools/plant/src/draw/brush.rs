//! What a symbol is drawn with.

use super::picture::{Attribute, Element, Id, Item, Value};
use crate::plant::Part;
use crate::run::Run;
use std::borrow::Cow;
use unoclp_words::Lang;

/// Draws a part at its place; what changes is named by the part and by what it is.
pub(crate) struct Brush<'a> {
    pub run: &'a Run<'a>,
    pub number: usize,
    pub part: &'a Part,
    pub lang: Lang,
    pub(super) items: &'a mut Vec<Item>,
    /// What never changes is left out.
    pub(super) live_only: bool,
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

    /// Whether the next element is left out.
    fn skips(&self) -> bool {
        self.live_only && self.live.is_none()
    }

    fn add(
        &mut self,
        tag: &'static str,
        class: impl Into<Cow<'static, str>>,
        attributes: &[Attribute],
        text: String,
    ) {
        if self.skips() {
            return;
        }
        let element = self.element(tag, class, attributes, text);
        self.items.push(Item::Leaf(element));
    }

    fn element(
        &mut self,
        tag: &'static str,
        class: impl Into<Cow<'static, str>>,
        more: &[Attribute],
        text: String,
    ) -> Element {
        let class = class.into();
        let mut attributes = Vec::with_capacity(1 + more.len());
        if !class.is_empty() {
            attributes.push(("class", Value::Text(class)));
        }
        attributes.extend_from_slice(more);
        let (part, twin) = (self.number, self.twin);
        let id = self.live.take().map(|what| Id::Of { part, what, twin });
        Element {
            tag,
            id,
            attributes,
            text,
        }
    }

    /// A group that is moved, turned or hidden as a whole.
    pub fn group(&mut self, attributes: &[Attribute], draw: impl FnOnce(&mut Self)) {
        if self.skips() {
            return draw(self);
        }
        let element = self.element("g", "", attributes, String::new());
        self.items.push(Item::Open(element));
        draw(self);
        if !self.live_only {
            self.items.push(Item::Close);
        }
    }

    /// A group that is moved by so much.
    pub fn moved(&mut self, x: i32, y: i32, draw: impl FnOnce(&mut Self)) {
        self.group(&[("transform", Value::Moved(x, y))], draw);
    }

    /// A group that is turned by so many degrees about a point.
    pub fn turned(&mut self, degrees: i32, about: [i32; 2], draw: impl FnOnce(&mut Self)) {
        self.group(&[("transform", Value::Turned(degrees, about))], draw);
    }

    /// A group that is there or not.
    pub fn shown(&mut self, is: bool, draw: impl FnOnce(&mut Self)) {
        self.group(&[display(is)], draw);
    }

    pub fn rect(
        &mut self,
        [x, y, w, h]: [i32; 4],
        round: i32,
        class: impl Into<Cow<'static, str>>,
    ) {
        let all = [
            ("x", Value::Number(x)),
            ("y", Value::Number(y)),
            ("width", Value::Number(w.max(0))),
            ("height", Value::Number(h.max(0))),
            ("rx", Value::Number(round)),
        ];
        let count = if round > 0 { 5 } else { 4 };
        self.add(
            "rect",
            class,
            all.get(..count).unwrap_or(&all),
            String::new(),
        );
    }

    pub fn circle(&mut self, [x, y]: [i32; 2], r: i32, class: impl Into<Cow<'static, str>>) {
        let all = [
            ("cx", Value::Number(x)),
            ("cy", Value::Number(y)),
            ("r", Value::Number(r)),
        ];
        self.add("circle", class, &all, String::new());
    }

    pub fn ellipse(
        &mut self,
        [x, y]: [i32; 2],
        [rx, ry]: [i32; 2],
        class: impl Into<Cow<'static, str>>,
    ) {
        let all = [
            ("cx", Value::Number(x)),
            ("cy", Value::Number(y)),
            ("rx", Value::Number(rx)),
            ("ry", Value::Number(ry)),
        ];
        self.add("ellipse", class, &all, String::new());
    }

    pub fn path(&mut self, d: impl Into<Cow<'static, str>>, class: impl Into<Cow<'static, str>>) {
        let all = [("d", Value::Text(d.into()))];
        self.add("path", class, &all, String::new());
    }

    pub fn line(&mut self, from: [i32; 2], to: [i32; 2], class: impl Into<Cow<'static, str>>) {
        let all = [("d", Value::Line(from, to))];
        self.add("path", class, &all, String::new());
    }

    pub fn text(
        &mut self,
        [x, y]: [i32; 2],
        class: impl Into<Cow<'static, str>>,
        text: impl Into<String>,
    ) {
        if self.skips() {
            return;
        }
        let all = [("x", Value::Number(x)), ("y", Value::Number(y))];
        self.add("text", class, &all, text.into());
    }

    /// The label below or beside the symbol.
    pub fn name(&mut self, at: [i32; 2]) {
        if self.skips() {
            return;
        }
        let label = self.label();
        self.text(at, "label", label);
    }
}

/// Whether something is there.
pub(super) fn display(is: bool) -> Attribute {
    ("display", if is { "inline" } else { "none" }.into())
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
