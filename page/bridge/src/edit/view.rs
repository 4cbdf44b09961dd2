//! What a page shows of a drawing.

use super::fields;
use super::words;
use crate::words::{Both, both};
use serde::Serialize;
use unoclp_core::Board;
use unoclp_draw::edit::{Canvas, Cursor, Document, Drawn, Editor, Id, Node, Place, Rung, visit};
use unoclp_draw::{Area, Element, Symbol};
use unoclp_program::Lang;
use unoclp_program::list::title;

/// A rectangle of the drawing: left and upper edge, width, height.
type Rectangle = [f32; 4];

/// What a page shows.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct View {
    /// Left out where it is as it was.
    sheet: Option<Sheet>,
    cursor: [u32; 2],
    /// All that is selected.
    selected: Vec<u32>,
    at: At,
    /// How many changes can be undone, and done again.
    undo: usize,
    redo: usize,
    mistakes: Vec<Told>,
    /// Whether the drawing is a program.
    is_program: bool,
    /// Its text; none where it is not a program.
    text: Option<String>,
    title: String,
    table: Vec<Named>,
    /// Whether there is something to paste.
    copied: bool,
}

/// The drawing.
#[derive(Debug, Serialize)]
struct Sheet {
    svg: String,
    area: Rectangle,
    spots: Vec<(u32, Rectangle)>,
    places: Vec<(u32, &'static str, Rectangle)>,
}

/// What is at the cursor.
#[derive(Debug, Serialize)]
struct At {
    /// `rung`, `path`, `element`, `branch` or `run`.
    what: &'static str,
    /// What a person hears of it.
    say: Both,
    /// Its rung, from 1.
    rung: usize,
    comment: String,
    fields: Vec<fields::Shown>,
}

/// A mistake.
#[derive(Debug, Serialize)]
struct Told {
    at: Option<u32>,
    /// Its rung, from 1.
    rung: usize,
    error: bool,
    message: Both,
}

/// A row of the symbol table.
#[derive(Debug, Serialize)]
struct Named {
    point: String,
    name: String,
    comment: String,
}

impl View {
    /// What there is to show; the drawing of so many columns in a language, if that is wanted.
    pub fn of(
        editor: &Editor,
        board: Board,
        text: Option<String>,
        wanted: Option<(usize, Lang)>,
    ) -> View {
        let (document, cursor) = (editor.document(), editor.cursor());
        let drawn = Drawn::of(document);
        let sheet = wanted.map(|(width, lang)| {
            let title = title(lang);
            let about = document.title().first().cloned().unwrap_or_default();
            let canvas = drawn.canvas(document, width, &|number| title(number, None), &about);
            Sheet::of(canvas)
        });
        let selected = document.within(cursor);
        let mistakes: Vec<Told> = document
            .check(board)
            .into_iter()
            .map(|mistake| Told {
                at: mistake.at.map(|id| id.0),
                rung: mistake
                    .at
                    .and_then(|id| document.rung_of(id))
                    .map_or(0, |at| at + 1),
                error: mistake.what.is_error(),
                message: both(|lang| unoclp_program::edit::wrong(lang, mistake.what)),
            })
            .collect();
        let (undo, redo) = editor.depth();
        let rows = document.table().rows();
        View {
            sheet,
            cursor: [cursor.from.0, cursor.to.0],
            at: At::of(document, &drawn, cursor, &selected),
            selected: selected.into_iter().map(|id| id.0).collect(),
            undo,
            redo,
            is_program: mistakes.iter().all(|told| !told.error),
            mistakes,
            text,
            title: document.title().join("\n"),
            table: rows
                .map(|(point, row)| Named {
                    point: point.to_string(),
                    name: row.name.clone(),
                    comment: row.comment.clone(),
                })
                .collect(),
            copied: editor.state().clip.is_some(),
        }
    }
}

impl Sheet {
    fn of(canvas: Canvas) -> Sheet {
        let rectangle = |area: Area| [area.x, area.y, area.width, area.height];
        let places = canvas.places.into_iter().map(|opening| {
            let place = match opening.place {
                Place::Before => "before",
                Place::Behind => "behind",
                Place::Beside => "beside",
            };
            (opening.at.0, place, rectangle(opening.area))
        });
        let spots = canvas.spots.into_iter();
        Sheet {
            svg: canvas.svg,
            area: rectangle(canvas.area),
            spots: spots
                .map(|spot| (spot.id.0, rectangle(spot.area)))
                .collect(),
            places: places.collect(),
        }
    }
}

impl At {
    fn of(document: &Document, drawn: &Drawn, cursor: Cursor, selected: &[Id]) -> At {
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
            ("element", say, fields::shown(document, element))
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

/// The elements and rungs that have these words in what is drawn of them, in their names or comments.
pub fn find(document: &Document, words: &str) -> Vec<u32> {
    let words = words.trim().to_lowercase();
    if words.is_empty() {
        return Vec::new();
    }
    let has = |text: &str| text.to_lowercase().contains(&words);
    let drawn = Drawn::of(document);
    let Drawn {
        ladder, elements, ..
    } = &drawn;
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
