//! A project of another PLC with its points on this board.

use crate::found::Found;
use crate::xml;
use roxmltree::{Document, Node};
use std::ops::Range;
use unoclp_core::Board;
use unoclp_lang::{Adapted, TextLanguage, adapt_at, written_points};

/// The project with a free point of this board in the place of each that the board lacks, and a table of what went where as a
/// comment; none where the text is no XML. Comments and documentation stay as they are.
pub fn adapt(text: &str, board: Board) -> Option<Adapted> {
    let tree = xml::parse(text, &mut Found::default())?;
    let adapted = adapt_at(text, &points(text, &tree), board);
    let table = adapted.table();
    if table.is_empty() {
        return Some(adapted);
    }
    let head = format!("<!-- unoclp adapt, {}:\n{table}-->\n", board.name);
    // What says that this is XML stays first.
    let declared = adapted
        .text
        .find("?>")
        .filter(|_| text.starts_with("<?xml"));
    let (first, rest) = adapted.text.split_at(declared.map_or(0, |at| at + 2));
    let line = if first.is_empty() { "" } else { "\n" };
    Some(Adapted {
        text: format!("{first}{line}{head}{}", rest.trim_start()),
        ..adapted
    })
}

/// Where a project writes points: in its declarations, at its elements, in its texts.
fn points(text: &str, tree: &Document<'_>) -> Vec<Range<usize>> {
    let mut points = Vec::new();
    for node in tree.descendants() {
        for attribute in node.attributes() {
            if matches!(attribute.name(), "address" | "value") {
                within(text, attribute.range_value(), TextLanguage::St, &mut points);
            }
        }
        if node.is_text()
            && let Some(language) = language(node)
        {
            within(text, node.range(), language, &mut points);
        }
    }
    points.sort_by_key(|place| place.start);
    points
}

/// In which language a piece of text is; none of one that is not part of the program.
fn language(of: Node<'_, '_>) -> Option<TextLanguage> {
    let parent = of.parent()?.tag_name().name();
    if matches!(parent, "variable" | "expression") {
        return Some(TextLanguage::St);
    }
    // A body holds a paragraph, or its text at once.
    let names = of.ancestors().skip(1).take(2);
    let mut names = names.map(|node| node.tag_name().name());
    names.find_map(|name| match name {
        "ST" => Some(TextLanguage::St),
        "IL" => Some(TextLanguage::Il),
        _ => None,
    })
}

fn within(text: &str, at: Range<usize>, language: TextLanguage, points: &mut Vec<Range<usize>>) {
    let piece = text.get(at.clone()).unwrap_or_default();
    let begin = "<![CDATA[";
    let skipped = if piece.starts_with(begin) {
        begin.len()
    } else {
        0
    };
    let places = written_points(piece.get(skipped..).unwrap_or_default(), language);
    let from = at.start + skipped;
    points.extend(
        places
            .into_iter()
            .map(|place| from + place.start..from + place.end),
    );
}
