//! Types and first values, as Structured Text spells them.
//!
//! The elements of a file lie at most as deep as `bounds` lets them, and so does what is spelled here.

use crate::found::span;
use crate::lent::{Lent, is_lent, stands_for};
use crate::text::Text;
use crate::xml::{all, first, text};
use roxmltree::Node;
use std::collections::HashMap;
use unoclp_lang::Span;

/// What the type within this element is called: in capitals where the standard has it.
pub(crate) fn kind(of: Node<'_, '_>) -> String {
    match of.children().find(Node::is_element) {
        Some(kind) => spelled(kind),
        None => text(of).trim().to_uppercase(),
    }
}

/// A type.
fn spelled(kind: Node<'_, '_>) -> String {
    let named = |name| kind.attribute(name).unwrap_or_default();
    let base = || first(kind, "baseType").map_or(String::new(), self::kind);
    match kind.tag_name().name() {
        "derived" => named("name").to_owned(),
        "array" => {
            let dimensions = all(kind, "dimension").map(bounds);
            let bounds: Vec<String> = dimensions.collect();
            format!("ARRAY [{}] OF {}", bounds.join(", "), base())
        }
        "string" | "wstring" => match kind.attribute("length") {
            Some(length) => format!("STRING[{length}]"),
            None => "STRING".to_owned(),
        },
        "subrangeSigned" | "subrangeUnsigned" => {
            let range = first(kind, "range").map_or(String::new(), bounds);
            format!("{}({range})", base())
        }
        "enum" => {
            let values = first(kind, "values").into_iter();
            let values = values.flat_map(|values| all(values, "value"));
            let values: Vec<String> = values.map(value_of_enumeration).collect();
            format!("({})", values.join(", "))
        }
        "struct" => {
            let members = all(kind, "variable").map(|member| {
                let name = member.attribute("name").unwrap_or_default();
                let kind = first(member, "type").map_or(String::new(), self::kind);
                format!("{name} : {kind}{}; ", first_value(member))
            });
            format!("STRUCT {}END_STRUCT", members.collect::<String>())
        }
        name => name.to_uppercase(),
    }
}

/// `1..3`, of a dimension or a range.
fn bounds(of: Node<'_, '_>) -> String {
    let bound = |name| of.attribute(name).unwrap_or_default();
    format!("{}..{}", bound("lower"), bound("upper"))
}

fn value_of_enumeration(of: Node<'_, '_>) -> String {
    let name = of.attribute("name").unwrap_or_default();
    match of.attribute("value").filter(|value| !value.is_empty()) {
        Some(value) => format!("{name} := {value}"),
        None => name.to_owned(),
    }
}

/// ` := 5`, where a variable or a type begins with something.
fn first_value(of: Node<'_, '_>) -> String {
    begins(of).map_or(String::new(), |value| format!(" := {value}"))
}

/// What a variable or a type begins with, as the text of a language has it. A file may leave out the quotes of a STRING.
pub(crate) fn begins(of: Node<'_, '_>) -> Option<String> {
    let value = first(of, "initialValue").and_then(initial)?;
    let kind = first(of, "type").or(first(of, "baseType"));
    let kind = kind.and_then(|of| of.first_element_child());
    let is_quoted = value.len() > 1 && value.starts_with('\'') && value.ends_with('\'');
    if is_quoted || !kind.is_some_and(is_string) {
        return Some(value);
    }
    let text = value.replace('$', "$$").replace('\'', "$'");
    Some(format!("'{text}'"))
}

/// Whether a type is STRING, or that of Beremiz's screens where the project makes no other of its name.
fn is_string(of: Node<'_, '_>) -> bool {
    match of.tag_name().name() {
        "derived" => is_lent(of, "HMI_STRING"),
        own => own.eq_ignore_ascii_case("string"),
    }
}

/// A first value, as the text of a language has it.
fn initial(of: Node<'_, '_>) -> Option<String> {
    let value = of.children().find(Node::is_element)?;
    match value.tag_name().name() {
        "simpleValue" => value.attribute("value").map(str::to_owned),
        "arrayValue" => {
            let values = all(value, "value").filter_map(|value| {
                let times = value.attribute("repetitionValue").filter(|n| *n != "1");
                let own = initial(value)?;
                Some(times.map_or(own.clone(), |times| format!("{times}({own})")))
            });
            let values: Vec<String> = values.collect();
            Some(format!("[{}]", values.join(", ")))
        }
        "structValue" => {
            let values = all(value, "value").filter_map(|value| {
                let member = value.attribute("member")?;
                Some(format!("{member} := {}", initial(value)?))
            });
            let values: Vec<String> = values.collect();
            Some(format!("({})", values.join(", ")))
        }
        _ => Some("?".to_owned()),
    }
}

/// The types that a project makes.
pub(crate) struct Types<'a, 'x> {
    /// Each by its name in capitals.
    by_name: HashMap<String, Node<'a, 'x>>,
    all: Vec<Node<'a, 'x>>,
    lent: Vec<Lent>,
}

impl<'a, 'x: 'a> Types<'a, 'x> {
    pub(crate) fn of(all: &[Node<'a, 'x>], lent: &[Lent]) -> Types<'a, 'x> {
        let name = |node: &Node<'_, '_>| node.attribute("name").unwrap_or_default().to_uppercase();
        Types {
            by_name: all.iter().map(|node| (name(node), *node)).collect(),
            all: all.to_vec(),
            lent: lent.to_vec(),
        }
    }

    /// Writes them down.
    pub(crate) fn write(&self, to: &mut Text) {
        let own = self.all.iter().map(|node| {
            let name = node.attribute("name").unwrap_or_default();
            let kind = first(*node, "baseType").map_or(String::new(), kind);
            let line = format!("  {name} : {kind}{};\n", first_value(*node));
            (line, span(*node))
        });
        let lent = self.lent.iter();
        let lent = lent.map(|own| (format!("  {} : {};\n", own.name, own.kind), own.at));
        let lines: Vec<(String, Span)> = lent.chain(own).collect();
        let (Some((_, one)), Some((_, last))) = (lines.first(), lines.last()) else {
            return;
        };
        to.piece("TYPE\n", *one);
        for (line, at) in &lines {
            to.piece(line, *at);
        }
        to.piece("END_TYPE\n", *last);
    }

    /// What a type is made of, where the project makes it.
    pub(crate) fn base(&self, name: &str) -> Option<String> {
        let name = name.to_uppercase();
        if let Some(kind) = stands_for(&name, &self.lent) {
            return Some(kind.to_owned());
        }
        let node = self.by_name.get(&name)?;
        first(*node, "baseType").map(kind)
    }

    /// The type of a member of a structure.
    pub(crate) fn member(&self, name: &str, member: &str) -> Option<String> {
        let node = self.by_name.get(&name.to_uppercase())?;
        let of = first(first(*node, "baseType")?, "struct")?;
        let mut members = all(of, "variable");
        let is = |node: &Node<'_, '_>| {
            let name = node.attribute("name").unwrap_or_default();
            name.eq_ignore_ascii_case(member)
        };
        first(members.find(is)?, "type").map(kind)
    }
}
