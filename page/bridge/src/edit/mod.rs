//! A program that a person draws: the one that is open, what is done to it, and what a page shows of it.
//!
//! - `act`: what may be done, as a request gives it
//! - `shown`: what is known of the document that a page has; `view`: what a page shows of it
//!
//! A page keeps the text that a drawing began with and all that was done to it; both together are the drawing again,
//! with all that can be undone. It must not know pointers and keys.

mod act;
mod shown;
mod view;

use crate::draw::Speak;
use crate::given::Given;
use crate::program;
use crate::words::{Both, No, both};
pub use act::Act;
#[cfg(test)]
pub use act::acts;
use serde_json::Value;
use shown::Shown;
use unoclp_core::Board;
use unoclp_draw::Look;
use unoclp_draw::edit::{
    Canvas, Cursor, Direction, Document, Drawn, Editor, Emitted, Operation, Refusal,
};
use unoclp_edit::{Amiss, ask, find, insertion, naming, operations, unfinished};
use unoclp_program::drawn::{self, Lost, WriteAs};
use unoclp_program::{Lang, Written};
use unoclp_workspace::{Analysis, Workspace};
pub use view::View;

/// The drawing that is open.
pub struct Drawing {
    editor: Editor,
    /// What its file is called.
    name: String,
    /// How its text is written.
    form: WriteAs,
    /// The board that it is for.
    board: Board,
    /// The texts that a person has written, and what they say: they stay as they are.
    written: Vec<(Document, Written)>,
    /// What a page has of it.
    shown: Option<Shown>,
    /// How a page has it drawn.
    canvas: Option<Canvas>,
}

/// The widest drawing, columns.
const WIDEST: usize = 400;

impl Drawing {
    /// Opens a text, and does again what was done to it.
    ///
    /// # Errors
    /// Where it has errors, or what was done to it was done to another.
    pub fn open(
        mut base: Given,
        log: Vec<Value>,
        board: Board,
        workspace: &mut Workspace,
    ) -> Result<Drawing, No> {
        let text = program::written(base.text("name")?, base.text("text")?, board)?;
        let form = form(&text.name);
        let version = workspace.set_text(text.clone());
        let editor = Editor::new(document(&*program::known(version, workspace)?)?);
        let mut drawing = Drawing {
            name: text.name.clone(),
            written: vec![(editor.document().clone(), text)],
            editor,
            form,
            board,
            shown: None,
            canvas: None,
        };
        for act in log {
            let act = Given::of(act).ok_or_else(|| crate::given::wrong("log"))?;
            // Whatever there was to ask was asked before it was done.
            let act = match Act::of(act, board)? {
                Act::Edit(fields, _) => Act::Edit(fields, true),
                Act::Name(point, row, _) => Act::Name(point, row, true),
                act => act,
            };
            drawing.act(act, workspace)?;
        }
        Ok(drawing)
    }

    /// Does something to it.
    ///
    /// # Errors
    /// Why not; then nothing has changed.
    pub fn act(&mut self, act: Act, workspace: &Workspace) -> Result<(), No> {
        match act {
            Act::Undo => self.editor.undo().map_err(refused)?,
            Act::Redo => self.editor.redo().map_err(refused)?,
            Act::Out => self.out(),
            Act::Text(text) => self.replace(text, workspace)?,
            Act::Do(operation) => self.editor.apply(&operation).map_err(refused)?,
            Act::Insert(what, place) => {
                let operations = insertion(&what, place)?;
                self.editor.apply_all(&operations).map_err(refused)?;
            }
            Act::Put(what, at, place) => {
                let mut operations = vec![Operation::Select(Cursor::at(at))];
                operations.extend(insertion(&what, place)?);
                self.editor.apply_all(&operations).map_err(refused)?;
            }
            Act::Edit(fields, sure) => {
                let (here, cursor) = (self.here(), self.editor.cursor());
                let operations = operations(here, cursor, fields, sure)?;
                self.editor.apply_all(&operations).map_err(refused)?;
            }
            Act::Name(point, row, sure) => {
                ask(self.here(), point, sure)?;
                let operation = naming(self.editor.document(), point, row)?;
                self.editor.apply(&operation).map_err(refused)?;
            }
            Act::Move(direction) => self.go(direction)?,
        }
        Ok(())
    }

    fn here(&self) -> (&Document, Board) {
        (self.editor.document(), self.board)
    }

    /// Another text in place of this one, as a change that can be undone. What it does not say of points stays.
    fn replace(&mut self, text: Written, workspace: &Workspace) -> Result<(), No> {
        let document = document(&workspace.look(text.clone()))?;
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
        self.written.push((self.editor.document().clone(), text));
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
            .map_err(refused)?;
        let document = self.editor.document();
        let is_rung = |id| document.position(id).is_some();
        if direction == Direction::Right && self.editor.cursor() == before {
            let around = document
                .around(before.to)
                .filter(|&around| !is_rung(around));
            if let Some(around) = around {
                let select = Operation::Select(Cursor::at(around));
                self.editor.apply(&select).map_err(refused)?;
            }
        }
        Ok(())
    }

    /// What a page shows of it in so many columns, looking so, under this name of its file; a drawing that it has already is left out.
    pub fn view(
        &mut self,
        name: Option<String>,
        board: Board,
        (width, look, speak): (usize, Look, Speak),
        workspace: &mut Workspace,
    ) -> View {
        let (width, lang) = (width.min(WIDEST), Lang::from(speak));
        self.board = board;
        if let Some(name) = name {
            self.name = name;
        }
        let same = self.shown.take();
        let mut shown = match same
            .filter(|shown| shown.is_of(self.editor.document(), self.board, &self.name))
        {
            Some(shown) => shown,
            None => self.look(workspace),
        };
        let form = (width, look, lang);
        let mut sheet = None;
        if shown.drawn_as != Some(form) {
            let before = self.canvas.as_ref();
            let document = self.editor.document();
            let canvas = view::canvas(document, &shown.drawn, form, before);
            sheet = Some(view::Sheet::of(&canvas));
            self.canvas = Some(canvas);
            shown.drawn_as = Some(form);
        }
        let view = View::of(&self.editor, &shown, sheet);
        self.shown = Some(shown);
        view
    }

    /// What there is to know of it: its codes are made once for its text, its mistakes and its ladder.
    fn look(&self, workspace: &mut Workspace) -> Shown {
        let name = self.name.clone();
        let document = self.editor.document();
        let emitted = Emitted::of(document);
        let mut written = self.written.iter();
        let written = written.find(|(says, _)| says == document);
        let written = written.map(|(_, written)| Written {
            name: name.clone(),
            board: self.board,
            ..written.clone()
        });
        let is_written = written.is_some();
        let (version, mistakes) = match written {
            Some(written) => {
                let version = workspace.set_text(written);
                let analysis = workspace.analysis(version);
                let is_program = analysis.is_some_and(|analysis| analysis.source().is_some());
                let mistakes = match is_program {
                    true => emitted.mistakes(),
                    false => emitted.check(self.board),
                };
                (Some(version), mistakes)
            }
            None => match workspace.set_drawing(&emitted, &name, self.form, self.board) {
                Ok(version) => (Some(version), emitted.mistakes()),
                Err(mistakes) => (None, mistakes),
            },
        };
        let analysis = version.and_then(|version| workspace.analysis(version));
        let text = |version| Some((version, analysis.as_ref()?.written().text()));
        let source = analysis.as_ref().filter(|_| is_written);
        let loses = source.and_then(|analysis| {
            let bytes = drawn::written(&emitted, self.form).into_bytes();
            let drawing = Written {
                bytes,
                ..analysis.written().clone()
            };
            Lost::of(analysis.source()?, &drawing)
        });
        Shown {
            document: document.clone(),
            board: self.board,
            name,
            loses,
            drawn: emitted.drawn(),
            drawn_as: None,
            text: version.and_then(text),
            mistakes,
        }
    }

    /// Its text in a form.
    ///
    /// # Errors
    /// Where it is not yet a program, or there is no such form.
    pub fn text(&self, form: WriteAs) -> Result<String, Both> {
        drawn::text(self.editor.document(), form, self.board).map_err(|_| both(unfinished))
    }

    /// What has these words in it: elements and rungs, from top to bottom.
    pub fn find(&self, words: &str) -> Vec<u32> {
        let document = self.editor.document();
        match &self.shown {
            Some(shown) if shown.document == *document => find(document, &shown.drawn, words),
            _ => find(document, &Drawn::of(document), words),
        }
    }
}

fn refused(refusal: Refusal) -> No {
    Amiss::from(refusal).into()
}

/// How the text of a drawing is written: numeric code where it came from that.
fn form(name: &str) -> WriteAs {
    match name.to_ascii_lowercase().ends_with(".txt") {
        true => WriteAs::Numeric,
        false => WriteAs::Il,
    }
}

/// The document of a text; of one without an instruction, one empty rung.
fn document(analysis: &Analysis) -> Result<Document, No> {
    let document = analysis.document().cloned();
    document.ok_or_else(|| both(crate::words::faulty).into())
}
