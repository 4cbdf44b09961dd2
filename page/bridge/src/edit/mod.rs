//! A program that a person draws: the one that is open, what is done to it, and what a page shows of it.
//!
//! - `act`: what may be done, as a request gives it
//! - `palette`: the elements that can be inserted
//! - `fields`: what an element has that can be changed, as a form has it
//! - `view`: what a page shows
//!
//! A page keeps the text that a drawing began with and all that was done to it; both together are the drawing again,
//! with all that can be undone. It must not know pointers and keys.

mod act;
mod fields;
mod palette;
mod view;
mod words;

use crate::draw::Speak;
use crate::given::Given;
use crate::program::Text;
use crate::words::{Both, No, both};
use unoclp_core::Board;
use unoclp_draw::edit::{Cursor, Direction, Document, Editor, Operation};
use unoclp_program::Lang;
use unoclp_program::drawn::{self, WriteAs};
use view::View;

pub use act::Act;
pub use palette::palette;
pub use words::no_drawing;

/// The drawing that is open.
pub struct Drawing {
    editor: Editor,
    /// How its text is written.
    form: WriteAs,
    /// The board that it is for.
    board: Board,
    /// The texts that a person has written, and what they say: they stay as they are.
    written: Vec<(Document, String)>,
    /// What a page has of it.
    shown: Option<Shown>,
}

/// A document as a page has it.
struct Shown {
    document: Document,
    width: usize,
    lang: Lang,
    /// None where it is not a program.
    text: Option<String>,
}

/// The widest drawing, columns.
const WIDEST: usize = 400;

impl Drawing {
    /// Opens a text, and does again what was done to it.
    ///
    /// # Errors
    /// Where it has errors, or what was done to it was done to another.
    pub fn open(given: &mut Given) -> Result<Drawing, No> {
        let text = Text::of(&mut given.below("base")?)?;
        let log = given.list("log")?;
        let form = form(&text);
        let (written, board) = (text.text.clone(), text.board);
        let editor = Editor::new(document(text)?);
        let mut drawing = Drawing {
            written: vec![(editor.document().clone(), written)],
            editor,
            form,
            board,
            shown: None,
        };
        for act in log {
            let act = Given::of(act).ok_or_else(|| crate::given::wrong("log"))?;
            // Whatever there was to ask was asked before it was done.
            drawing.act(match Act::of(act)? {
                Act::Edit(fields, _) => Act::Edit(fields, true),
                Act::Name(point, row, _) => Act::Name(point, row, true),
                act => act,
            })?;
        }
        Ok(drawing)
    }

    /// Does something to it.
    ///
    /// # Errors
    /// Why not; then nothing has changed.
    pub fn act(&mut self, act: Act) -> Result<(), No> {
        match act {
            Act::Undo => self.editor.undo().map_err(words::refused)?,
            Act::Redo => self.editor.redo().map_err(words::refused)?,
            Act::Out => self.out(),
            Act::Text(text) => self.replace(text)?,
            Act::Do(operation) => self.editor.apply(&operation).map_err(words::refused)?,
            Act::Insert(what, place) => {
                let operations = palette::insertion(&what, place)?;
                self.editor.apply_all(&operations).map_err(words::refused)?;
            }
            Act::Put(what, at, place) => {
                let mut operations = vec![Operation::Select(Cursor::at(at))];
                operations.extend(palette::insertion(&what, place)?);
                self.editor.apply_all(&operations).map_err(words::refused)?;
            }
            Act::Edit(fields, sure) => {
                let (here, cursor) = (self.here(), self.editor.cursor());
                let operations = fields::operations(here, cursor, fields, sure)?;
                self.editor.apply_all(&operations).map_err(words::refused)?;
            }
            Act::Name(point, row, sure) => {
                fields::ask(self.here(), point, sure)?;
                let operation = fields::naming(self.editor.document(), point, row)?;
                self.editor.apply(&operation).map_err(words::refused)?;
            }
            Act::Move(direction) => self.go(direction)?,
        }
        Ok(())
    }

    fn here(&self) -> (&Document, Board) {
        (self.editor.document(), self.board)
    }

    /// Another text in place of this one, as a change that can be undone. What it does not say of points stays.
    fn replace(&mut self, text: Text) -> Result<(), No> {
        let written = text.text.clone();
        let document = document(text)?;
        let table = self.editor.document().table();
        let rows = table.rows().filter_map(|(point, row)| {
            let mut row = row.clone();
            if let Some(new) = document.table().get(point) {
                row.name.clone_from(&new.name);
            }
            let taken = document.table().point(&row.name);
            taken
                .is_none_or(|other| other == point)
                .then_some((point, row))
        });
        let rows: Vec<_> = rows.collect();
        self.editor.replace(document.with_rows(rows));
        self.written.push((self.editor.document().clone(), written));
        Ok(())
    }

    /// Selects what stands around the cursor.
    fn out(&mut self) {
        let cursor = self.editor.cursor();
        if let Some(around) = self.editor.document().around(cursor.from) {
            // What stands around is there, and so can be selected.
            let _ = self.editor.apply(&Operation::Select(Cursor::at(around)));
        }
    }

    /// Moves the cursor; at the right end of a branch the branch itself is next.
    fn go(&mut self, direction: Direction) -> Result<(), No> {
        let before = self.editor.cursor();
        let document = self.editor.document();
        let is_branch = document.rung_of(before.to) == document.rung_of(before.from)
            && document.within(before).len() > 1;
        if direction == Direction::Right && is_branch && document.position(before.to).is_none() {
            return Ok(());
        }
        self.editor
            .apply(&Operation::Move(direction))
            .map_err(words::refused)?;
        let document = self.editor.document();
        let is_rung = |id| document.position(id).is_some();
        if direction == Direction::Right && self.editor.cursor() == before {
            let around = document
                .around(before.to)
                .filter(|&around| !is_rung(around));
            if let Some(around) = around {
                let select = Operation::Select(Cursor::at(around));
                self.editor.apply(&select).map_err(words::refused)?;
            }
        }
        Ok(())
    }

    /// What a page shows of it; a drawing that it has already is left out.
    ///
    /// # Errors
    /// Where the width is none.
    pub fn view(&mut self, given: &mut Given) -> Result<View, No> {
        let width = given.columns("width")?.min(WIDEST);
        let lang = Lang::from(Speak::of(given)?);
        let document = self.editor.document();
        let same = self
            .shown
            .take()
            .filter(|shown| shown.document == *document);
        let is_drawn = matches!(&same, Some(shown) if shown.width == width && shown.lang == lang);
        let text = match same {
            Some(shown) => shown.text,
            None => self.text_now(),
        };
        let wanted = (!is_drawn).then_some((width, lang));
        let view = View::of(&self.editor, self.board, text.clone(), wanted);
        self.shown = Some(Shown {
            document: self.editor.document().clone(),
            width,
            lang,
            text,
        });
        Ok(view)
    }

    /// Its text: as a person has written it, else as it is drawn; none where it is not a program.
    fn text_now(&self) -> Option<String> {
        let document = self.editor.document();
        let mut written = self.written.iter();
        let written = written.find(|(says, _)| says == document);
        let written = written.map(|(_, text)| text.clone());
        written.or_else(|| drawn::text(document, self.form, self.board).ok())
    }

    /// Its text in a form.
    ///
    /// # Errors
    /// Where it is not yet a program, or there is no such form.
    pub fn text(&self, form: &str) -> Result<String, Both> {
        let form = match form {
            "numeric" => WriteAs::Numeric,
            "il" => WriteAs::Il,
            other => return Err(crate::given::wrong(other)),
        };
        drawn::text(self.editor.document(), form, self.board).map_err(|_| both(words::unfinished))
    }

    /// What has these words in it: elements and rungs, from top to bottom.
    pub fn find(&self, words: &str) -> Vec<u32> {
        view::find(self.editor.document(), words)
    }
}

/// How the text of a drawing is written: numeric code where it came from that.
fn form(text: &Text) -> WriteAs {
    match text.name.to_ascii_lowercase().ends_with(".txt") {
        true => WriteAs::Numeric,
        false => WriteAs::Il,
    }
}

/// The document of a text; of one without an instruction, one empty rung.
fn document(text: Text) -> Result<Document, No> {
    match text.is_blank() {
        true => Ok(drawn::blank(&text.text).unwrap_or_default()),
        false => Ok(drawn::document(&text.program()?)),
    }
}
