//! Pieces of a file put into it, byte by byte: all else stays as it is.

use roxmltree::Node;
use std::ops::Range;

/// A text with other bytes in these places, which do not overlap.
pub(crate) fn spliced(text: &str, mut pieces: Vec<(Range<usize>, String)>) -> String {
    pieces.sort_by_key(|(place, _)| place.start);
    let mut to = String::with_capacity(text.len());
    let mut from = 0;
    for (place, new) in pieces {
        to.push_str(text.get(from..place.start).unwrap_or_default());
        to.push_str(&new);
        from = place.end.max(from);
    }
    to.push_str(text.get(from..).unwrap_or_default());
    to
}

/// The name of an element as it is written, with its prefix.
pub(crate) fn tag<'t>(text: &'t str, node: Node<'_, '_>) -> &'t str {
    let all = text.get(node.range()).unwrap_or_default();
    let name = all.strip_prefix('<').unwrap_or_default();
    let end = name.find(|c: char| c.is_whitespace() || matches!(c, '/' | '>'));
    name.get(..end.unwrap_or(name.len())).unwrap_or_default()
}

/// What stands within an element becomes this.
pub(crate) fn content(text: &str, node: Node<'_, '_>, new: &str) -> Option<(Range<usize>, String)> {
    let range = node.range();
    let all = text.get(range.clone())?;
    let last = all.rfind("</");
    match (all.strip_suffix("/>"), last) {
        (Some(begin), _) => {
            let end = format!(">{new}</{}>", tag(text, node));
            Some((range.start + begin.len()..range.end, end))
        }
        (None, Some(last)) => {
            let start = range.start + first_end(all)?;
            Some((start..range.start + last, new.to_owned()))
        }
        (None, None) => None,
    }
}

/// Where the start tag of an element ends: a value in quotes may hold a `>`.
fn first_end(all: &str) -> Option<usize> {
    let mut quote = None;
    for (at, c) in all.char_indices() {
        match (quote, c) {
            (None, '>') => return Some(at + 1),
            (None, '"' | '\'') => quote = Some(c),
            (Some(open), c) if open == c => quote = None,
            _ => {}
        }
    }
    None
}

/// The white space before an element.
pub(crate) fn lead<'t>(text: &'t str, node: Node<'_, '_>) -> &'t str {
    let before = text.get(..node.range().start).unwrap_or_default();
    before.get(before.trim_end().len()..).unwrap_or_default()
}

/// An element more in this one, after the others.
pub(crate) fn append(text: &str, node: Node<'_, '_>, new: &str) -> Option<(Range<usize>, String)> {
    match node.children().rfind(Node::is_element) {
        Some(last) => {
            let at = last.range().end;
            Some((at..at, format!("{}{new}", lead(text, last))))
        }
        None => content(text, node, new),
    }
}

/// No such element any longer, nor the white space before it.
pub(crate) fn removed(text: &str, node: Node<'_, '_>) -> (Range<usize>, String) {
    let range = node.range();
    (
        range.start - lead(text, node).len()..range.end,
        String::new(),
    )
}
