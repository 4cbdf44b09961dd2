//! A project as one text, for who looks for a name in it: its types, its variables, and what each body says, whatever that
//! is written or drawn in. Each name of the text knows its place in the file.
//!
//! The text is read by its words, and never compiled: a contact is its variable and a semicolon, a pin the member of an
//! instance. So a project with mistakes has one too. A name that a drawing or a task gives to a unit is said to do so, since
//! a variable may have the same.

use crate::found::Found;
use crate::project::lists;
use crate::text::Text;
use crate::xml::{self, all, first, within};
use roxmltree::Node;
use std::collections::HashMap;
use unoclp_lang::Span;

/// A project as one text with the words of Structured Text.
pub struct Whole {
    text: Text,
    /// What of the text stands in the file as it is: where there, and where here; in the order of the file.
    copied: Vec<(Span, u32)>,
    units: Vec<u32>,
    programs: Vec<u32>,
}

impl Whole {
    /// That of a project; none of what is none.
    pub fn of(xml: &str) -> Option<Whole> {
        let tree = xml::parse(xml, &mut Found::default())?;
        let root = tree.root_element();
        if root.tag_name().name() != "project" {
            return None;
        }
        let mut writer = Writer {
            xml,
            to: Text::default(),
            units: Vec::new(),
            programs: Vec::new(),
        };
        writer.project(root);
        let Writer {
            to: mut text,
            units,
            programs,
            ..
        } = writer;
        text.unqualified(&lists(root));
        let mut copied = text.copied();
        copied.sort_by_key(|(span, _)| span.start);
        Some(Whole {
            text,
            copied,
            units,
            programs,
        })
    }

    /// Where a name of the text stands for a function or a block that is drawn, by its first byte.
    pub fn units(&self) -> &[u32] {
        &self.units
    }

    /// Where a name of the text stands for a program that a task runs, by its first byte.
    pub fn programs(&self) -> &[u32] {
        &self.programs
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text.text
    }

    /// Where a byte of the file stands in the text; none where the file says something else there.
    pub fn in_text(&self, byte: u32) -> Option<u32> {
        let begun = self.copied.partition_point(|(span, _)| span.start <= byte);
        let (span, at) = self.copied.get(begun.checked_sub(1)?)?;
        (byte <= span.end).then_some(at + byte - span.start)
    }

    /// Where this of the text stands in the file; none where it stands there otherwise.
    pub fn in_file(&self, of: Span) -> Option<Span> {
        let (start, is_copied, from) = self.text.place(of.start);
        let end = start + (of.end - of.start);
        (is_copied && end <= from.end).then_some(Span { start, end })
    }
}

struct Writer<'t> {
    xml: &'t str,
    to: Text,
    units: Vec<u32>,
    programs: Vec<u32>,
}

impl Writer<'_> {
    fn project(&mut self, root: Node<'_, '_>) {
        for own in within(root, "dataType") {
            self.add("TYPE ");
            self.attribute(own, "name");
            if let Some(base) = first(own, "baseType") {
                self.add(" : ");
                self.kind(base);
            }
            self.first_value(own);
            self.add(";\nEND_TYPE\n");
        }
        within(root, "globalVars").for_each(|section| self.section(section));
        within(root, "pou").for_each(|pou| self.unit(pou));
        for instance in within(root, "pouInstance") {
            // In CODESYS a program has one instance, and both have one name.
            let names = ["typeName", "type", "name"];
            let said = |name: &&str| {
                instance
                    .attribute(*name)
                    .is_some_and(|said| !said.is_empty())
            };
            if let Some(name) = names.iter().find(|name| said(name)) {
                self.programs.push(self.here());
                self.said(instance, name);
            }
        }
        within(root, "task").for_each(|task| self.said(task, "single"));
    }

    fn unit(&mut self, pou: Node<'_, '_>) {
        let [begin, end] = match pou.attribute("pouType") {
            Some("function") => ["FUNCTION ", "END_FUNCTION\n"],
            Some("functionBlock") => ["FUNCTION_BLOCK ", "END_FUNCTION_BLOCK\n"],
            _ => ["PROGRAM ", "END_PROGRAM\n"],
        };
        self.add(begin);
        self.attribute(pou, "name");
        let interface = first(pou, "interface");
        if let Some(gives) = interface.and_then(|of| first(of, "returnType")) {
            self.add(" : ");
            self.kind(gives);
        }
        self.add("\n");
        let sections = interface.into_iter().flat_map(|of| of.children());
        sections.for_each(|section| self.section(section));
        let parts = pou.children().filter(Node::is_element);
        for part in parts.filter(|part| part.tag_name().name() != "interface") {
            let blocks = within(part, "block");
            let blocks = blocks.filter_map(|block| Some((block.attribute("localId")?, block)));
            self.body(part, &blocks.collect());
        }
        self.add(end);
    }

    fn section(&mut self, section: Node<'_, '_>) {
        let word = match section.tag_name().name() {
            "inputVars" => "VAR_INPUT\n",
            "outputVars" => "VAR_OUTPUT\n",
            "inOutVars" => "VAR_IN_OUT\n",
            "externalVars" => "VAR_EXTERNAL\n",
            "globalVars" => "VAR_GLOBAL\n",
            _ => "VAR\n",
        };
        let mut variables = all(section, "variable").peekable();
        if variables.peek().is_none() {
            return;
        }
        self.add(word);
        variables.for_each(|variable| self.variable(variable));
        self.add("END_VAR\n");
    }

    /// A variable, or a member of a structure.
    fn variable(&mut self, variable: Node<'_, '_>) {
        self.attribute(variable, "name");
        if variable.has_attribute("address") {
            self.add(" AT ");
            self.attribute(variable, "address");
        }
        self.add(" : ");
        if let Some(kind) = first(variable, "type") {
            self.kind(kind);
        }
        self.first_value(variable);
        self.add(";\n");
    }

    /// The type within this element.
    fn kind(&mut self, of: Node<'_, '_>) {
        let Some(kind) = of.children().find(Node::is_element) else {
            return;
        };
        match kind.tag_name().name() {
            "derived" => self.attribute(kind, "name"),
            "enum" => {
                self.add("(");
                within(kind, "value").for_each(|value| {
                    self.attribute(value, "name");
                    self.add(", ");
                });
                self.add(")");
            }
            "struct" => {
                self.add("STRUCT\n");
                all(kind, "variable").for_each(|member| self.variable(member));
                self.add("END_STRUCT");
            }
            // Its bounds say no name.
            "array" => {
                self.add("ARRAY [0..0] OF ");
                first(kind, "baseType")
                    .into_iter()
                    .for_each(|of| self.kind(of));
            }
            "subrangeSigned" | "subrangeUnsigned" | "pointer" => {
                first(kind, "baseType")
                    .into_iter()
                    .for_each(|of| self.kind(of));
            }
            name => self.add(&name.to_uppercase()),
        }
    }

    fn first_value(&mut self, of: Node<'_, '_>) {
        if let Some(value) = first(of, "initialValue") {
            self.add(" := ");
            self.value(value);
        }
    }

    /// The value within this element.
    fn value(&mut self, of: Node<'_, '_>) {
        let Some(value) = of.children().find(Node::is_element) else {
            return;
        };
        match value.tag_name().name() {
            "arrayValue" => {
                self.add("[");
                all(value, "value").for_each(|value| {
                    self.value(value);
                    self.add(", ");
                });
                self.add("]");
            }
            "structValue" => {
                self.add("(");
                all(value, "value").enumerate().for_each(|(at, value)| {
                    self.add(if at > 0 { ", " } else { "" });
                    self.attribute(value, "member");
                    self.add(" := ");
                    self.value(value);
                });
                self.add(")");
            }
            _ => self.attribute(value, "value"),
        }
    }

    /// What a body says of names: `blocks` by the numbers that its wires have.
    fn body(&mut self, of: Node<'_, '_>, blocks: &HashMap<&str, Node<'_, '_>>) {
        match of.tag_name().name() {
            "documentation" | "comment" | "addData" => return,
            "ST" | "IL" => return self.inner(of, "\n;\n"),
            "expression" => {
                return self.inner(
                    of,
                    if is_in(of, "outVariable") {
                        " := 0;\n"
                    } else {
                        ";\n"
                    },
                );
            }
            "variable" => match of.has_attribute("formalParameter") {
                true => {
                    let block = of.parent().and_then(|part| part.parent());
                    block.into_iter().for_each(|block| self.pin(block, of));
                }
                false => {
                    return self.inner(of, if is_in(of, "coil") { " := 0;\n" } else { ";\n" });
                }
            },
            "block" => {
                self.units.push(self.here());
                self.said(of, "typeName");
                self.said(of, "instanceName");
            }
            "connection" => {
                let block = of.attribute("refLocalId").and_then(|id| blocks.get(id));
                block.into_iter().for_each(|block| self.pin(*block, of));
            }
            "reference" => self.said(of, "name"),
            "action" => {
                self.said(of, "indicator");
                self.said(of, "duration");
            }
            _ => {}
        }
        of.children().for_each(|child| self.body(child, blocks));
    }

    /// A pin of a block, which an element names.
    fn pin(&mut self, block: Node<'_, '_>, named: Node<'_, '_>) {
        let name = |name| block.attribute(name).filter(|name| !name.is_empty());
        if named.attribute("formalParameter").is_none_or(str::is_empty) {
            return;
        }
        match (name("instanceName"), name("typeName")) {
            (Some(instance), _) => {
                self.add(&format!("{instance}."));
                self.said(named, "formalParameter");
            }
            (None, Some(function)) => {
                self.units.push(self.here());
                self.add(&format!("{function}("));
                self.attribute(named, "formalParameter");
                self.add(" := 0);\n");
            }
            (None, None) => {}
        }
    }

    /// What an attribute says, as a statement.
    fn said(&mut self, of: Node<'_, '_>, name: &str) {
        if of.attribute(name).is_some_and(|value| !value.is_empty()) {
            self.attribute(of, name);
            self.add(";\n");
        }
    }

    /// The byte at which the next name will stand.
    fn here(&self) -> u32 {
        self.to.text.len() as u32
    }

    fn add(&mut self, text: &str) {
        self.to.piece(text, Span::default());
    }

    /// What an attribute says.
    fn attribute(&mut self, of: Node<'_, '_>, name: &str) {
        let mut attributes = of.attributes();
        if let Some(own) = attributes.find(|own| own.name() == name) {
            self.to.copy(self.xml, own.range_value());
        }
    }

    /// All that is written within an element, and this after it.
    fn inner(&mut self, of: Node<'_, '_>, after: &str) {
        self.to.copy(self.xml, of.range());
        self.add(after);
    }
}

/// Whether an element stands right within one of this name.
fn is_in(of: Node<'_, '_>, name: &str) -> bool {
    of.parent().is_some_and(|of| of.tag_name().name() == name)
}
