//! What a project cannot say.

use unoclp_draw::edit::Id;
use unoclp_lang::{Code, Diagnostic, Lang, Span};

/// What of a document no project can say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lost {
    /// The element, or the rung.
    pub at: Id,
    /// The number of its rung, from 1.
    pub rung: usize,
    /// What it is.
    pub what: String,
    /// Whether it is a block diagram that cannot.
    pub is_blocks: bool,
}

impl Lost {
    /// Why there is no project, with its number.
    pub fn text(&self, lang: Lang) -> String {
        let words = vec![self.rung.to_string().into(), self.what.as_str().into()];
        let code = match self.is_blocks {
            true => Code::XmlNoBlocks,
            false => Code::XmlLost,
        };
        let told = Diagnostic::new(code, Span::default(), words);
        format!("{}: {}", told.code, told.message(lang))
    }
}
