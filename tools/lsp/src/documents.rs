//! The texts that are open in an editor.

use crate::lines::Places;
use lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams, Uri,
};
use std::collections::HashMap;
use std::rc::Rc;
use unoclp_core::Board;
use unoclp_program::{Written, WrittenIn};
use unoclp_workspace::{All, Analysis, Workspace};

/// All of them, and what is known of each.
pub(crate) struct Documents {
    board: Board,
    workspace: Workspace,
    open: HashMap<String, Document>,
}

struct Document {
    places: Rc<Places>,
    version: i32,
    /// What the editor says it is written in: `st`.
    language: String,
}

/// A text that is open, and what is known of it.
pub(crate) struct Open {
    /// Where its bytes stand.
    pub places: Rc<Places>,
    /// How often it has changed, as the editor counts.
    pub version: i32,
    /// What is known of it.
    pub analysis: Rc<Analysis>,
}

/// The longest text that is looked at, bytes: no program is that long.
const LONGEST: usize = 1 << 20;

impl Documents {
    /// None yet, for this board.
    pub fn new(board: Board) -> Documents {
        Documents {
            board,
            workspace: Workspace::new(Rc::new(All::default())),
            open: HashMap::new(),
        }
    }

    /// A text is opened.
    pub fn open(&mut self, told: DidOpenTextDocumentParams) -> Option<Uri> {
        let document = told.text_document;
        self.set(
            &document.uri,
            document.text,
            document.version,
            document.language_id,
        );
        Some(document.uri)
    }

    /// A text changes.
    pub fn change(&mut self, told: DidChangeTextDocumentParams) -> Option<Uri> {
        let uri = told.text_document.uri;
        let document = self.open.remove(uri.as_str())?;
        let language = document.language;
        let mut text = document.places.text().to_owned();
        for change in told.content_changes {
            match change.range {
                Some(range) => {
                    let places = Places::new(text);
                    let span = places.span(range);
                    text = places.text().to_owned();
                    text.replace_range(span.range(), &change.text);
                }
                None => text = change.text,
            }
        }
        self.set(&uri, text, told.text_document.version, language);
        Some(uri)
    }

    /// A text is closed.
    pub fn close(&mut self, told: DidCloseTextDocumentParams) -> Option<Uri> {
        let uri = told.text_document.uri;
        self.open.remove(uri.as_str()).map(|_| uri)
    }

    /// One that is open.
    pub fn get(&mut self, uri: &Uri) -> Option<Open> {
        let document = self.open.get(uri.as_str())?;
        let text = document.places.text();
        let bytes = text.as_bytes()[..floor(text, LONGEST)].to_vec();
        let name = name(uri);
        let written = Written::new(name, bytes, self.board);
        // Where neither the name nor the text tells, the editor may know.
        let known = written.language.is_ok();
        let said = WrittenIn::named(&document.language).filter(|_| !known);
        Some(Open {
            places: document.places.clone(),
            version: document.version,
            analysis: self.workspace.open(written.or_in(said)),
        })
    }

    fn set(&mut self, uri: &Uri, text: String, version: i32, language: String) {
        let places = Rc::new(Places::new(text));
        let document = Document {
            places,
            version,
            language,
        };
        self.open.insert(uri.as_str().to_owned(), document);
    }
}

/// The last byte at or before this one at which a character begins.
fn floor(text: &str, mut at: usize) -> usize {
    at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// What a file is called: what stands after the last slash.
fn name(uri: &Uri) -> String {
    let path = uri.as_str().split(['?', '#']).next().unwrap_or_default();
    path.rsplit('/').next().unwrap_or_default().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answers::Answers;
    use crate::problems::problems;
    use serde_json::json;
    use unoclp_checked::Work;
    use unoclp_lang::Lang;

    const TEXT: &str =
        "PROGRAM p\nVAR\n  lamp AT %QX0.0 : BOOL;\nEND_VAR\nlamp := TRUE;\nEND_PROGRAM\n";

    #[test]
    fn a_change_is_compiled_once_however_much_is_asked_of_it() {
        let mut documents = Documents::new(Board::UNO);
        let id = json!({ "uri": "file:///a.st", "languageId": "st", "version": 1, "text": TEXT });
        let told = json!({ "textDocument": id });
        let uri = documents.open(serde_json::from_value(told).unwrap());
        let uri = uri.unwrap();
        problems(&documents.get(&uri).unwrap(), Lang::En);
        for (version, value) in [(2, "FALSE"), (3, "TRUE ")] {
            let line = json!({ "start": { "line": 4, "character": 8 }, "end": { "line": 4, "character": if version == 2 { 12 } else { 13 } } });
            let change = json!({
                "textDocument": { "uri": "file:///a.st", "version": version },
                "contentChanges": [{ "range": line, "text": value }],
            });
            let before = Work::done();
            documents.change(serde_json::from_value(change).unwrap());
            let wrong = problems(&documents.get(&uri).unwrap(), Lang::En);
            assert!(wrong.is_empty(), "{wrong:?}");
            let place = json!({
                "textDocument": { "uri": "file:///a.st" },
                "position": { "line": 4, "character": 2 },
                "context": { "includeDeclaration": true, "diagnostics": [], "triggerKind": 1 },
                "range": line,
                "options": { "tabSize": 2, "insertSpaces": true },
            });
            let mut answers = Answers {
                documents: &mut documents,
                lang: Lang::En,
            };
            for asked in [
                "completion",
                "hover",
                "definition",
                "references",
                "documentHighlight",
                "documentSymbol",
                "prepareRename",
                "codeAction",
            ] {
                let answer = answers.answer(&format!("textDocument/{asked}"), place.clone());
                assert!(answer.is_ok(), "{asked}: {answer:?}");
            }
            assert_eq!(Work::since(before).compiles, 1, "one didChange");
        }
    }
}
