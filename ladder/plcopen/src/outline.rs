//! What a project is made of: its units and their variables, each with its place in the file.

use crate::found::{Found, span};
use crate::project::{Declared, declared};
use crate::types::kind;
use crate::xml::{self, first, text, within};
use roxmltree::Node;
use unoclp_lang::{Code, Span, Told};

/// A project as a tree of units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outline {
    /// What it is called.
    pub name: String,
    /// Its types.
    pub types: Vec<String>,
    /// The variables of its configuration and of its resources.
    pub globals: Vec<Row>,
    /// Its programs, function blocks and functions, in the order of the file.
    pub units: Vec<Unit>,
}

/// A program, a function block or a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unit {
    /// What it is called.
    pub name: String,
    /// `program`, `functionBlock`, `function`.
    pub kind: String,
    /// The language of its body, `LD`; empty where it has none.
    pub language: String,
    /// What a function gives.
    pub gives: Option<String>,
    /// What it is about.
    pub comment: String,
    /// Its variables.
    pub variables: Vec<Row>,
    /// Where it begins in the file.
    pub at: Span,
}

/// A row of a table of variables.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// What it is called.
    pub name: String,
    /// The element that declares it and others: `localVars`.
    pub section: String,
    /// Its type.
    pub kind: String,
    /// What it begins with.
    pub first: Option<String>,
    /// Its place, `%IX0.0`.
    pub place: Option<String>,
    /// Whether it is kept while there is no power.
    pub retained: bool,
    /// Whether it never changes.
    pub constant: bool,
    /// What it is for.
    pub comment: String,
    /// Where it is in the file.
    pub at: Span,
}

/// The outline of a project; what its bodies say is not looked at.
///
/// # Errors
/// Where the text is no project.
pub fn outline(text: &str) -> Result<Outline, Told> {
    let mut found = Found::default();
    let tree = xml::parse(text, &mut found);
    let root = tree.as_ref().map(|tree| tree.root_element());
    let Some(root) = root else {
        return Err(found.finish());
    };
    if root.tag_name().name() != "project" {
        let name = root.tag_name().name().into();
        found.tell(Code::XmlNoProject, root, [name]);
        return Err(found.finish());
    }
    let header = first(root, "contentHeader");
    let named = |of: Node<'_, '_>| of.attribute("name").unwrap_or_default().to_owned();
    Ok(Outline {
        name: header.map_or(String::new(), named),
        types: within(root, "dataType").map(named).collect(),
        globals: within(root, "globalVars").flat_map(rows).collect(),
        units: within(root, "pou").map(unit).collect(),
    })
}

fn unit(node: Node<'_, '_>) -> Unit {
    let named = |attribute| node.attribute(attribute).unwrap_or_default().to_owned();
    let interface = first(node, "interface");
    let sections = interface.into_iter().flat_map(|of| of.children());
    let gives = interface.and_then(|of| first(of, "returnType")).map(kind);
    let body = first(node, "body");
    let body = body.and_then(|body| body.children().find(Node::is_element));
    Unit {
        name: named("name"),
        kind: named("pouType"),
        language: body.map_or(String::new(), |body| body.tag_name().name().to_owned()),
        gives,
        comment: comment(node),
        variables: sections.flat_map(rows).collect(),
        at: span(node),
    }
}

fn rows(section: Node<'_, '_>) -> impl Iterator<Item = Row> {
    declared(section).map(|Declared { node, variable }| Row {
        name: variable.name,
        section: variable.section,
        kind: variable.kind,
        first: variable.initial,
        place: variable.address,
        retained: variable.retain,
        constant: variable.constant,
        comment: comment(node),
        at: variable.at,
    })
}

/// What the documentation of an element says.
fn comment(of: Node<'_, '_>) -> String {
    let written = first(of, "documentation").map_or(String::new(), text);
    written.trim().to_owned()
}
