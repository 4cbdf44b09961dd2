//! Rows of a table of variables that come, go, or are kept while there is no power.

use crate::alter::{attribute, is_named, kind_written, sections};
use crate::edges::{append, lead, removed, spliced, tag};
use crate::export::escaped;
use crate::found::Found;
use crate::project::declared;
use crate::xml::{self, all, first, says, within};
use roxmltree::Node;

/// A project with one more variable of this unit, in the section of this name; of none, with one more global variable. None
/// where there is no such unit.
pub fn add(
    text: &str,
    unit: Option<&str>,
    section: &str,
    name: &str,
    kind: &str,
) -> Option<String> {
    let tree = xml::parse(text, &mut Found::default())?;
    let root = tree.root_element();
    let new = format!(
        "<variable name=\"{}\"><type>{}</type></variable>",
        escaped(name),
        kind_written(kind)
    );
    let is_plain = |of: &Node<'_, '_>| !says(*of, "retain") && !says(*of, "constant");
    let mut own = sections(root, unit)?
        .into_iter()
        .filter(|of| of.is_element() && of.tag_name().name() == section);
    let piece = match (own.rfind(is_plain), unit) {
        (Some(section), _) => append(text, section, &new)?,
        (None, Some(unit)) => {
            let pou = within(root, "pou").find(|pou| is_named(*pou, unit))?;
            let interface = first(pou, "interface")?;
            append(text, interface, &format!("<{section}>{new}</{section}>"))?
        }
        (None, None) => return None,
    };
    Some(spliced(text, vec![piece]))
}

/// A project without this variable; who uses it says so.
pub fn remove(text: &str, unit: Option<&str>, variable: &str) -> Option<String> {
    let tree = xml::parse(text, &mut Found::default())?;
    let node = row(tree.root_element(), unit, variable)?;
    Some(spliced(text, vec![removed(text, node)]))
}

/// A project in which a variable is kept while there is no power, or is not.
pub fn retain(text: &str, unit: Option<&str>, variable: &str, is: bool) -> Option<String> {
    let tree = xml::parse(text, &mut Found::default())?;
    let root = tree.root_element();
    let node = row(root, unit, variable)?;
    let section = node.parent()?;
    if says(section, "retain") == is {
        return Some(text.to_owned());
    }
    let retain = is.then_some("true");
    if all(section, "variable").count() == 1 {
        let piece = attribute(text, section, "retain", retain)?;
        return Some(spliced(text, vec![piece]));
    }
    let is_like = |of: &Node<'_, '_>| {
        of.tag_name() == section.tag_name()
            && says(*of, "retain") == is
            && says(*of, "constant") == says(section, "constant")
            && of.attribute("name") == section.attribute("name")
    };
    let own = text.get(node.range())?;
    let other = sections(root, unit)?.into_iter().find(is_like);
    let piece = match other {
        Some(other) => append(text, other, own)?,
        None => {
            let name = tag(text, section);
            let says = retain.map_or(String::new(), |is| format!(" retain=\"{is}\""));
            let at = section.range().end;
            let new = format!("{}<{name}{says}>{own}</{name}>", lead(text, section));
            (at..at, new)
        }
    };
    Some(spliced(text, vec![removed(text, node), piece]))
}

fn row<'a, 'x: 'a>(root: Node<'a, 'x>, unit: Option<&str>, name: &str) -> Option<Node<'a, 'x>> {
    let mut rows = sections(root, unit)?.into_iter().flat_map(declared);
    Some(rows.find(|row| is_named(row.node, name))?.node)
}
