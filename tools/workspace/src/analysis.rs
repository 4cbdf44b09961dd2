//! What is known of a text, each part found when it is asked for first.

use crate::Compilers;
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::ops::Deref;
use std::rc::Rc;
use unoclp_checked::SourceMap;
use unoclp_draw::edit::Document;
use unoclp_draw::{Ladder, Names};
use unoclp_lang::{Colour, Span};
use unoclp_program::used::Used;
use unoclp_program::{Refused, Source, Written, drawn, names, symbols};

/// What is known of a text.
pub struct Analysis {
    written: Written,
    compilers: Rc<dyn Compilers>,
    checked: OnceCell<Option<Result<Rc<Source>, Refused>>>,
    colours: OnceCell<Vec<(Span, Colour)>>,
    ladder: OnceCell<(Ladder, Names)>,
    symbols: OnceCell<BTreeMap<String, String>>,
    document: OnceCell<Document>,
}

impl Analysis {
    pub(crate) fn new(written: Written, compilers: Rc<dyn Compilers>) -> Analysis {
        Analysis {
            written,
            compilers,
            checked: OnceCell::new(),
            colours: OnceCell::new(),
            ladder: OnceCell::new(),
            symbols: OnceCell::new(),
            document: OnceCell::new(),
        }
    }

    /// The text, its name and its board.
    pub fn written(&self) -> &Written {
        &self.written
    }

    /// Its program, or all that is wrong with it; none where it takes a compiler that is not at hand.
    pub fn check(&self) -> Option<&Result<Rc<Source>, Refused>> {
        let check = || Some(self.compilers.check(self.written.clone())?.map(Rc::new));
        self.checked.get_or_init(check).as_ref()
    }

    /// Its program; none where there is none.
    pub fn source(&self) -> Option<&Source> {
        self.check()?.as_ref().ok().map(Rc::as_ref)
    }

    /// The same with all that is known of it, to keep.
    pub fn ready(self: &Rc<Analysis>) -> Option<Ready> {
        let source = self.check()?.as_ref().ok()?.clone();
        Some(Ready {
            analysis: self.clone(),
            source,
        })
    }

    /// What is known of another text of this name, in the same language and for the same board.
    pub fn with_text(&self, text: String) -> Analysis {
        let written = Written {
            bytes: text.into_bytes(),
            ..self.written.clone()
        };
        Analysis::new(written, self.compilers.clone())
    }

    /// The coloured parts of the text, in the order of their places.
    pub fn colours(&self) -> &[(Span, Colour)] {
        let colours = || self.compilers.colours(&self.written);
        self.colours.get_or_init(colours)
    }

    /// Whether no instruction stands in it yet, so that one can draw the first.
    pub fn is_blank(&self) -> bool {
        self.source().is_none() && self.compilers.is_blank(&self.written)
    }

    /// The ladder of its program.
    pub fn ladder(&self) -> Option<&Ladder> {
        Some(&self.drawn(self.source()?).0)
    }

    /// What the symbols of the ladder are called.
    pub fn names(&self) -> Option<&Names> {
        Some(&self.drawn(self.source()?).1)
    }

    /// What the text calls the points of the program: `lamp` after `Q1`.
    pub fn symbols(&self) -> Option<&BTreeMap<String, String>> {
        Some(self.called(self.source()?))
    }

    /// Where its steps stand in the text.
    pub fn map(&self) -> Option<&SourceMap> {
        Some(&self.source()?.map)
    }

    /// Its numeric code, as it stands on a card.
    pub fn code(&self) -> Option<&[u8]> {
        Some(&self.source()?.code)
    }

    /// What it uses of the board.
    pub fn uses(&self) -> Option<&Used> {
        Some(&self.source()?.size.used)
    }

    /// Its ladder as one can change it: of a text without an instruction an empty rung.
    pub fn document(&self) -> Option<&Document> {
        if let Some(document) = self.document.get() {
            return Some(document);
        }
        let document = match self.source() {
            Some(source) => drawn::document(source),
            None if self.is_blank() => drawn::blank(&self.written.text()).unwrap_or_default(),
            None => return None,
        };
        Some(self.document.get_or_init(|| document))
    }

    fn drawn(&self, source: &Source) -> &(Ladder, Names) {
        self.ladder.get_or_init(|| {
            let ladder = Ladder::new(source.program().steps());
            let names = names(&source.map, &ladder);
            (ladder, names)
        })
    }

    fn called(&self, source: &Source) -> &BTreeMap<String, String> {
        let symbols = || symbols(source, &self.drawn(source).1);
        self.symbols.get_or_init(symbols)
    }
}

/// A text that is a program, with all that is known of it.
#[derive(Clone)]
pub struct Ready {
    analysis: Rc<Analysis>,
    source: Rc<Source>,
}

impl Ready {
    /// Its ladder.
    pub fn ladder(&self) -> &Ladder {
        &self.analysis.drawn(&self.source).0
    }

    /// What the symbols of its ladder are called.
    pub fn names(&self) -> &Names {
        &self.analysis.drawn(&self.source).1
    }

    /// What the text calls the points of the program: `lamp` after `Q1`.
    pub fn symbols(&self) -> &BTreeMap<String, String> {
        self.analysis.called(&self.source)
    }
}

impl Deref for Ready {
    type Target = Source;

    fn deref(&self) -> &Source {
        &self.source
    }
}
