//! The text of a file as a tree, within bounds.

use crate::bounds::{LARGEST, beyond};
use crate::broken::reason;
use crate::found::Found;
use roxmltree::{Document, Error, Node, ParsingOptions};
use unoclp_lang::{Code, Span};

/// The most nodes of a tree: a tag takes at least four bytes.
const MOST_NODES: u32 = (LARGEST / 4) as u32;

/// The tree of a text. A document type is refused, and with it all entities but those of XML itself.
pub(crate) fn parse<'t>(text: &'t str, found: &mut Found) -> Option<Document<'t>> {
    if let Some((at, what)) = beyond(text) {
        found.tell_at(Code::XmlTooLarge, at, [what]);
        return None;
    }
    let options = ParsingOptions {
        allow_dtd: false,
        nodes_limit: MOST_NODES,
        ..ParsingOptions::default()
    };
    let error = match Document::parse_with_options(text, options) {
        Ok(document) => return Some(document),
        Err(error) => error,
    };
    let start = place(text, &error) as u32;
    let span = Span { start, end: start };
    found.tell_at(Code::XmlBroken, span, [reason(&error)]);
    None
}

/// The byte at which a text is no XML.
fn place(text: &str, error: &Error) -> usize {
    match error {
        Error::DtdDetected => return text.find("<!DOCTYPE").unwrap_or(0),
        // The last byte of what is written.
        Error::UnclosedRootNode | Error::UnexpectedEndOfStream => {
            let last = text.trim_end().char_indices().next_back();
            return last.map_or(0, |(at, _)| at);
        }
        _ => {}
    }
    let place = error.pos();
    let before = (place.row as usize).saturating_sub(1);
    let start: usize = text.split_inclusive('\n').take(before).map(str::len).sum();
    let line = text.lines().nth(before).unwrap_or_default().chars();
    let column = line.take((place.col as usize).saturating_sub(1));
    let column: usize = column.map(char::len_utf8).sum();
    (start + column).min(text.len())
}

/// The elements within one, with this name.
pub(crate) fn all<'a, 'x>(
    of: Node<'a, 'x>,
    name: &'static str,
) -> impl Iterator<Item = Node<'a, 'x>> {
    of.children()
        .filter(move |child| child.is_element() && child.tag_name().name() == name)
}

/// The elements with this name, however deep they are in one: CODESYS keeps those of an application beside its tasks.
pub(crate) fn within<'a, 'x: 'a>(
    of: Node<'a, 'x>,
    name: &'static str,
) -> impl Iterator<Item = Node<'a, 'x>> {
    of.descendants()
        .filter(move |node| node.is_element() && node.tag_name().name() == name)
}

/// The first of those right within it.
pub(crate) fn first<'a, 'x>(of: Node<'a, 'x>, name: &'static str) -> Option<Node<'a, 'x>> {
    all(of, name).next()
}

/// The text within an element and all that it holds.
pub(crate) fn text(of: Node<'_, '_>) -> String {
    let texts = of.descendants().filter(Node::is_text);
    texts.filter_map(|node| node.text()).collect()
}

/// Whether an attribute says `true`.
pub(crate) fn says(of: Node<'_, '_>, attribute: &str) -> bool {
    matches!(of.attribute(attribute), Some("true" | "1"))
}
