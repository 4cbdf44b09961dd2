//! The body of a unit, changed in the file: its text, its chart, an element of its drawing. All else stays as it is.

use crate::alter::{attribute, is_named};
use crate::edges::{content, removed, spliced};
use crate::export::{chart_body, escaped};
use crate::found::Found;
use crate::project::Project;
use crate::text::Text;
use crate::xml::{self, all, first, within};
use roxmltree::Node;
use std::ops::Range;
use unoclp_sfc::Document;

/// What is changed of an element of a drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Touch {
    /// Its variable, its expression, the instance of a block, the name of a label or a jump.
    Written(String),
    /// Whether a contact or a coil is negated.
    Negated(bool),
    /// The edge of a contact or a coil: `rising`, `falling`, `none`.
    Edge(String),
    /// What a coil does: `set`, `reset`, `none`.
    Storage(String),
}

fn unit<'a, 'x: 'a>(root: Node<'a, 'x>, name: &str) -> Option<Node<'a, 'x>> {
    within(root, "pou").find(|pou| is_named(*pou, name))
}

/// The body of a unit: the element of its language.
pub(crate) fn body<'a, 'x: 'a>(root: Node<'a, 'x>, name: &str) -> Option<Node<'a, 'x>> {
    let body = first(unit(root, name)?, "body")?;
    body.children().find(Node::is_element)
}

/// A project in which a unit in ST or IL has this body.
pub fn write_body(text: &str, unit: &str, new: &str) -> Option<String> {
    let tree = xml::parse(text, &mut Found::default())?;
    let body = body(tree.root_element(), unit)?;
    if !matches!(body.tag_name().name(), "ST" | "IL") {
        return None;
    }
    let within = body.children().find(Node::is_element).unwrap_or(body);
    let piece = content(text, within, &escaped(new))?;
    Some(spliced(text, vec![piece]))
}

/// The charts of a project.
#[derive(Default)]
pub struct Charts {
    /// One for each unit that is one.
    pub documents: Vec<Document>,
    text: Text,
}

impl Charts {
    /// Those of a project, as far as its bodies can be read.
    pub fn of(text: &str) -> Charts {
        let mut found = Found::default();
        let Some(tree) = xml::parse(text, &mut found) else {
            return Charts::default();
        };
        let Some(project) = Project::read(tree.root_element(), &mut found) else {
            return Charts::default();
        };
        let text = crate::body::as_text(text, &project, &mut found);
        Charts {
            documents: Document::all(&text.text),
            text,
        }
    }

    /// What of the file has become a part of a chart, by the place that [`Document::places`] says.
    pub fn in_file(&self, place: Range<usize>) -> Vec<Range<usize>> {
        let spans = self.text.spans(place).into_iter();
        spans.map(|span| span.range()).collect()
    }
}

/// The charts of a project, one for each unit that is one, as far as its bodies can be read.
pub fn charts(text: &str) -> Vec<Document> {
    Charts::of(text).documents
}

/// What a chart has beside its text: it could not say it again.
const DRAWN: [&str; 7] = ["contact", "coil", "block", "inVariable", "LD", "FBD", "IL"];

/// A project in which a unit has this chart. Its steps stand where they are drawn. None where parts of the chart are drawn
/// themselves, as the conditions of transitions are.
pub fn write_chart(text: &str, chart: &Document) -> Option<String> {
    let tree = xml::parse(text, &mut Found::default())?;
    let unit = unit(tree.root_element(), &chart.unit)?;
    let own = first(unit, "body")?;
    let is_drawn = |node: Node<'_, '_>| DRAWN.contains(&node.tag_name().name());
    if first(own, "SFC").is_none() || unit.descendants().any(is_drawn) {
        return None;
    }
    let mut body = chart_body(chart).trim().to_owned();
    if unit.lookup_namespace_uri(Some("xhtml")).is_none() {
        body = body.replace(
            "<xhtml:p>",
            "<xhtml:p xmlns:xhtml=\"http://www.w3.org/1999/xhtml\">",
        );
    }
    let mut pieces = vec![(own.range(), body)];
    let beside = ["actions", "transitions"].into_iter();
    let beside = beside.flat_map(|name| all(unit, name));
    pieces.extend(beside.map(|node| removed(text, node)));
    Some(spliced(text, pieces))
}

/// A project in which an element of a drawn unit, by its number in the file, is another.
pub fn touch(text: &str, unit: &str, element: &str, touch: &Touch) -> Option<String> {
    let tree = xml::parse(text, &mut Found::default())?;
    let body = body(tree.root_element(), unit)?;
    let mut elements = body.children().filter(Node::is_element);
    let node = elements.find(|node| node.attribute("localId") == Some(element))?;
    let kind = node.tag_name().name();
    let is_possible = match touch {
        Touch::Written(_) => true,
        Touch::Negated(_) => matches!(kind, "contact" | "coil" | "inVariable" | "outVariable"),
        Touch::Edge(_) => matches!(kind, "contact" | "coil"),
        Touch::Storage(_) => kind == "coil",
    };
    if !is_possible {
        return None;
    }
    let says = |is: bool| is.then_some("true");
    let other = |word: &str| Some(word.to_owned()).filter(|word| !matches!(&**word, "none" | ""));
    let piece = match touch {
        Touch::Written(new) => match kind {
            "block" => attribute(text, node, "instanceName", Some(new)),
            "label" | "jump" => attribute(text, node, "label", Some(new)),
            _ => {
                let own = first(node, "variable").or_else(|| first(node, "expression"))?;
                content(text, own, &escaped(new))
            }
        },
        Touch::Negated(is) => attribute(text, node, "negated", says(*is)),
        Touch::Edge(edge) => attribute(text, node, "edge", other(edge).as_deref()),
        Touch::Storage(storage) => attribute(text, node, "storage", other(storage).as_deref()),
    };
    Some(spliced(text, vec![piece?]))
}
