//! What of a drawing has some words in it.

use unoclp_draw::edit::{Document, Drawn, Rung};
use unoclp_draw::{Element, Symbol};

/// The elements and rungs that have these words in what is drawn of them, in their names or comments.
pub fn find(document: &Document, drawn: &Drawn, words: &str) -> Vec<u32> {
    let words = words.trim().to_lowercase();
    if words.is_empty() {
        return Vec::new();
    }
    let has = |text: &str| text.to_lowercase().contains(&words);
    let Drawn {
        ladder, elements, ..
    } = drawn;
    let names = document.table();
    let mut found: Vec<u32> = Vec::new();
    let about = |rung: &&Rung| rung.comment.iter().any(|line| has(line));
    found.extend(document.rungs().filter(about).map(|rung| rung.id.0));
    for (element, id) in ladder.elements.iter().zip(elements) {
        let row = element.point.and_then(|point| names.get(point));
        let is = has(text(element)) || row.is_some_and(|row| has(&row.name) || has(&row.comment));
        if is && !found.contains(&id.0) {
            found.push(id.0);
        }
    }
    found
}

fn text(element: &Element) -> &str {
    match &element.symbol {
        Symbol::Contact { text, .. } | Symbol::Coil { text, .. } => text,
        Symbol::Box { text, .. } | Symbol::Leave { text, .. } => text,
        Symbol::Inline(text) => text,
    }
}
