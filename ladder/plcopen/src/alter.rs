//! A row of a table of variables, changed in the file; everything else in the file stays the same, byte for byte.

use crate::export::escaped;
use crate::found::Found;
use crate::project::declared;
use crate::xml::{self, first, within};
use roxmltree::Node;
use std::ops::Range;

/// What is changed of a variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// Its type.
    Kind(String),
    /// What it begins with; none: what its type does.
    First(Option<String>),
    /// Its place; none: one that is free.
    Place(Option<String>),
    /// What it is for; empty: nothing is said.
    Comment(String),
}

/// A project with this change of a variable of this unit; of none, of a global variable. Letters of both cases are alike. None
/// where there is no such variable, or no project.
pub fn alter(text: &str, unit: Option<&str>, variable: &str, change: &Change) -> Option<String> {
    let tree = xml::parse(text, &mut Found::default())?;
    let root = tree.root_element();
    let mut rows = sections(root, unit)?.into_iter().flat_map(declared);
    let node = rows.find(|row| is_named(row.node, variable))?.node;
    let (place, new) = edit(text, node, change)?;
    let mut changed = text.to_owned();
    changed.replace_range(place, &new);
    Some(changed)
}

/// The elements that declare the variables of a unit; of none, the global ones.
pub(crate) fn sections<'a, 'x: 'a>(
    root: Node<'a, 'x>,
    unit: Option<&str>,
) -> Option<Vec<Node<'a, 'x>>> {
    Some(match unit {
        Some(unit) => {
            let pou = within(root, "pou").find(|pou| is_named(*pou, unit))?;
            first(pou, "interface")?.children().collect()
        }
        None => within(root, "globalVars").collect(),
    })
}

/// Whether an element has this name, in letters of either case.
pub(crate) fn is_named(node: Node<'_, '_>, name: &str) -> bool {
    let own = node.attribute("name").unwrap_or_default();
    own.to_uppercase() == name.to_uppercase()
}

/// Which bytes become which.
fn edit(text: &str, node: Node<'_, '_>, change: &Change) -> Option<(Range<usize>, String)> {
    match change {
        Change::Place(place) => attribute(text, node, "address", place.as_deref()),
        Change::Kind(kind) => {
            let kind = kind_written(kind);
            element(text, node, "type", Some(&format!("<type>{kind}</type>")))
        }
        Change::First(value) => {
            let value = value.as_ref().map(|value| {
                let value = escaped(value);
                format!("<initialValue><simpleValue value=\"{value}\"/></initialValue>")
            });
            element(text, node, "initialValue", value.as_deref())
        }
        Change::Comment(comment) => {
            let comment = (!comment.is_empty()).then(|| {
                let comment = escaped(comment);
                format!(
                    "<documentation><xhtml:p xmlns:xhtml=\"http://www.w3.org/1999/xhtml\">{comment}</xhtml:p></documentation>"
                )
            });
            element(text, node, "documentation", comment.as_deref())
        }
    }
}

/// The element of a type.
pub(crate) fn kind_written(kind: &str) -> String {
    match is_elementary(kind) {
        true => format!("<{}/>", kind.to_uppercase()),
        false => format!("<derived name=\"{}\"/>", escaped(kind)),
    }
}

/// Whether a type is of the standard, and has an element of its name.
fn is_elementary(kind: &str) -> bool {
    let kind = kind.to_uppercase();
    unoclp_lang::typed::Base::named(&kind).is_some() || matches!(&*kind, "STRING" | "WSTRING")
}

/// An attribute with another value, or without it.
pub(crate) fn attribute(
    text: &str,
    node: Node<'_, '_>,
    name: &str,
    value: Option<&str>,
) -> Option<(Range<usize>, String)> {
    let mut attributes = node.attributes();
    let own = attributes.find(|attribute| attribute.name() == name);
    match (own, value) {
        (Some(own), Some(value)) => Some((own.range_value(), escaped(value))),
        (Some(own), None) => {
            let Range { start, end } = own.range();
            let before = text.get(..start)?;
            let start = before.trim_end().len();
            Some((start..end, String::new()))
        }
        (None, Some(value)) => {
            // After the name of the element.
            let start = node.range().start;
            let tag = text.get(start..)?;
            let end = tag.find(|c: char| c.is_whitespace() || matches!(c, '/' | '>'))?;
            let at = start + end;
            Some((at..at, format!(" {name}=\"{}\"", escaped(value))))
        }
        (None, None) => Some((node.range().start..node.range().start, String::new())),
    }
}

/// The order in which the form has the elements of a variable.
const ORDER: [&str; 4] = ["type", "initialValue", "addData", "documentation"];

/// An element within a variable as another one, or without it.
fn element(
    text: &str,
    node: Node<'_, '_>,
    name: &'static str,
    new: Option<&str>,
) -> Option<(Range<usize>, String)> {
    let new = new.unwrap_or_default().to_owned();
    if let Some(own) = first(node, name) {
        return Some((own.range(), new));
    }
    if new.is_empty() {
        return Some((node.range().start..node.range().start, new));
    }
    let rank = |name: &str| ORDER.iter().position(|own| *own == name).unwrap_or(0);
    let elements = node.children().filter(Node::is_element);
    let mut before = elements.filter(|other| rank(other.tag_name().name()) < rank(name));
    match before.next_back() {
        Some(before) => {
            let at = before.range().end;
            Some((at..at, new))
        }
        None => {
            // A variable without a type has an end of its own, or none.
            let all = text.get(node.range())?;
            let end = all.strip_suffix("/>").map(str::len);
            let at = node.range().start;
            match end {
                Some(end) => {
                    let tag = node.tag_name().name();
                    Some((at + end..node.range().end, format!(">{new}</{tag}>")))
                }
                None => {
                    let start = at + all.find('>')? + 1;
                    Some((start..start, new))
                }
            }
        }
    }
}
