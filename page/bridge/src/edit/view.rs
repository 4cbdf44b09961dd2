//! What a page shows of a drawing.

use super::shown::Shown;
use crate::answer::answer;
use crate::words::{Both, both};
use serde::{Serialize, Serializer};
use unoclp_draw::edit::{self, Canvas, Document, Drawn, Editor, Place, Strip};
use unoclp_draw::{Area, Look};
use unoclp_edit::{At, wrong};
use unoclp_program::Lang;
use unoclp_program::list::title;

/// A rectangle of a rung's drawing: left and upper edge, width, height.
#[derive(Debug)]
struct Rectangle([f32; 4]);

/// Nearly all are whole, and there are thousands of them.
impl Serialize for Rectangle {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let whole = self.0.map(|value| value as i32);
        let is_whole = whole
            .iter()
            .zip(self.0)
            .all(|(&whole, value)| whole as f32 == value);
        match is_whole {
            true => whole.serialize(serializer),
            false => self.0.serialize(serializer),
        }
    }
}

#[cfg(test)]
impl crate::answer::Typed for Rectangle {
    fn name() -> String {
        "Rectangle".to_owned()
    }
}

answer! {
    /// What a page shows.
    pub struct View as "Drawn" {
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
        /// The version of its text, and that; none where it is not a program.
        version: Option<u32>,
        text: Option<String>,
        /// What a change loses of the text that a person has written; none: nothing.
        loses: Option<Both>,
        title: String,
        table: Vec<Named>,
        /// Whether there is something to paste.
        copied: bool,
    }
}

answer! {
    /// The drawing.
    pub struct Sheet as "DrawnSheet" {
        width: f32,
        height: f32,
        rungs: Vec<Rung>,
    }
}

answer! {
    /// A rung where it stands: its upper edge, and how many nets and steps there are before its own.
    struct Rung as "RungDrawn" {
        id: u32,
        top: f32,
        nets: u32,
        first: usize,
        /// Left out where it is as it was.
        drawn: Option<RungDrawing>,
    }
}

answer! {
    /// A rung wherever it stands.
    struct RungDrawing as "RungDrawing" {
        svg: String,
        places: Vec<(u32, &'static str, Rectangle)> => "readonly (readonly [number, Place, Rectangle])[]",
    }
}

answer! {
    /// A mistake.
    struct Told as "Mistake" {
        at: Option<u32>,
        /// Its rung, from 1.
        rung: usize,
        error: bool,
        message: Both,
    }
}

answer! {
    /// A row of the symbol table.
    struct Named as "Named" {
        point: String,
        name: String,
        comment: String,
    }
}

impl View {
    /// What there is to show.
    pub(super) fn of(editor: &Editor, shown: &Shown, sheet: Option<Sheet>) -> View {
        let (document, cursor) = (editor.document(), editor.cursor());
        let selected = document.within(cursor);
        let mistakes: Vec<Told> = shown
            .mistakes
            .iter()
            .map(|mistake| Told {
                at: mistake.at.map(|id| id.0),
                rung: mistake
                    .at
                    .and_then(|id| document.rung_of(id))
                    .map_or(0, |at| at + 1),
                error: mistake.what.is_error(),
                message: both(|lang| wrong(lang, mistake.what)),
            })
            .collect();
        let (undo, redo) = editor.depth();
        let rows = document.table().rows();
        let text = shown.text.as_ref();
        View {
            sheet,
            cursor: [cursor.from.0, cursor.to.0],
            at: At::of(document, &shown.drawn, cursor, &selected),
            selected: selected.into_iter().map(|id| id.0).collect(),
            undo,
            redo,
            is_program: mistakes.iter().all(|told| !told.error),
            mistakes,
            version: text.map(|(version, _)| version.0),
            text: text.map(|(_, text)| text.clone()),
            loses: shown
                .loses
                .as_ref()
                .map(|lost| both(|lang| lost.text(lang))),
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

/// The drawing of a document, of so many columns, in a language; a page has the one before.
pub fn canvas(
    document: &Document,
    drawn: &Drawn,
    (width, look, lang): (usize, Look, Lang),
    before: Option<&Canvas>,
) -> Canvas {
    let title = title(lang);
    drawn.canvas(
        document,
        (look, width),
        &|number| title(number, None),
        before,
    )
}

impl Sheet {
    pub(super) fn of(canvas: &Canvas) -> Sheet {
        let (width, height) = canvas.size;
        let rung = |strip: &Strip| Rung {
            id: strip.id.0,
            top: strip.top,
            nets: strip.nets,
            first: strip.first,
            drawn: strip.is_new.then(|| RungDrawing::of(&strip.drawn)),
        };
        Sheet {
            width,
            height,
            rungs: canvas.rungs.iter().map(rung).collect(),
        }
    }
}

impl RungDrawing {
    fn of(drawn: &edit::RungDrawing) -> RungDrawing {
        let places = drawn.places.iter().map(|opening| {
            let place = match opening.place {
                Place::Before => "before",
                Place::Behind => "behind",
                Place::Beside => "beside",
            };
            let Area {
                x,
                y,
                width,
                height,
            } = opening.area;
            (opening.at.0, place, Rectangle([x, y, width, height]))
        });
        RungDrawing {
            svg: drawn.svg.clone(),
            places: places.collect(),
        }
    }
}
