//! What is at the cursor, and what a person hears of it.

use crate::{Shown, shown, words};
use serde::Serialize;
use unoclp_draw::Symbol;
use unoclp_draw::edit::{Cursor, Document, Drawn, Id, Node, visit};
use unoclp_words::{Both, Lang, both};

/// What is at the cursor.
#[derive(Debug, Serialize)]
pub struct At {
    /// `rung`, `path`, `element`, `branch` or `run`.
    pub what: &'static str,
    /// What a person hears of it.
    pub say: Both,
    /// Its rung, from 1.
    pub rung: usize,
    /// What its rung is about.
    pub comment: String,
    /// What of it can be changed.
    pub fields: Vec<Shown>,
}

impl At {
    /// What is at this cursor, with which all of these are selected.
    pub fn of(document: &Document, drawn: &Drawn, cursor: Cursor, selected: &[Id]) -> At {
        let rung = document.rung_of(cursor.to).unwrap_or(0);
        let comment = document
            .rungs()
            .nth(rung)
            .map(|rung| rung.comment.join("\n"));
        let comment = comment.unwrap_or_default();
        let place = rung + 1;
        let (what, say, fields) = if document.position(cursor.from).is_some() {
            let about = comment.replace('\n', " ");
            let say = both(|lang| words::at_rung(lang, place, &about));
            ("rung", say, Vec::new())
        } else if cursor.from != cursor.to {
            let count = selected.len();
            (
                "run",
                both(|lang| words::at_run(lang, count, place)),
                Vec::new(),
            )
        } else if let Some(element) = document.element(cursor.from) {
            let symbol = symbol(document, drawn, cursor.from);
            let say = both(|lang| words::at_element(lang, described(lang, &symbol), place));
            ("element", say, shown(document, element))
        } else if selected.len() == 1 && is_path(document, cursor.from) {
            ("path", both(|lang| words::at_path(lang, place)), Vec::new())
        } else {
            (
                "branch",
                both(|lang| words::at_branch(lang, place)),
                Vec::new(),
            )
        };
        At {
            what,
            say,
            rung: place,
            comment,
            fields,
        }
    }
}

fn is_path(document: &Document, id: Id) -> bool {
    let mut is = false;
    for rung in document.rungs() {
        visit(&rung.series, &mut |node: &Node| {
            is |= node.paths().iter().any(|path| path.id == id);
        });
    }
    is
}

/// What is drawn for an element: the symbol, and the name of its point.
fn symbol(document: &Document, drawn: &Drawn, id: Id) -> (Option<Symbol>, String) {
    let index = drawn.elements.iter().position(|of| *of == id);
    let element = index.and_then(|index| drawn.ladder.elements.get(index));
    let row = element.and_then(|element| document.table().get(element.point?));
    let name = row.map_or_else(String::new, |row| row.name.clone());
    (element.map(|element| element.symbol.clone()), name)
}

fn described(lang: Lang, (symbol, name): &(Option<Symbol>, String)) -> String {
    let text = match symbol {
        Some(Symbol::Contact {
            closed: false,
            text,
        }) => words::say_open(lang, text),
        Some(Symbol::Contact { closed: true, text }) => words::say_closed(lang, text),
        Some(Symbol::Coil { letter, text }) => words::say_coil(lang, letter, text),
        Some(Symbol::Box { text, .. } | Symbol::Leave { text, .. }) => text.clone(),
        Some(Symbol::Inline(text)) => (*text).to_owned(),
        None => String::new(),
    };
    format!("{text} {name}").trim_end().to_owned()
}
