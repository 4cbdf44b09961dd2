//! What a text is opened with.

use unoclp_lang::{Colour, Dialect, Span, declared};
use unoclp_program::{Refused, Source, Written, WrittenIn};

/// What a text is opened with: all that compiles, or as much of it as there is at hand.
pub trait Compilers {
    /// Compiles and checks a text; none where it takes a compiler that is not at hand.
    fn check(&self, written: Written) -> Option<Result<Source, Refused>>;

    /// The coloured parts of a text, in the order of their places.
    fn colours(&self, written: &Written) -> Vec<(Span, Colour)>;

    /// Whether no instruction stands in a text yet, so that one can draw the first.
    fn is_blank(&self, written: &Written) -> bool {
        written.bytes.iter().all(u8::is_ascii_whitespace)
    }
}

/// All compilers.
#[derive(Clone, Copy, Debug, Default)]
pub struct All {
    /// Whose Instruction List each text is; none: what it looks like.
    pub dialect: Option<Dialect>,
}

impl Compilers for All {
    fn check(&self, written: Written) -> Option<Result<Source, Refused>> {
        Some(written.check(self.dialect))
    }

    fn colours(&self, written: &Written) -> Vec<(Span, Colour)> {
        written.colours()
    }

    fn is_blank(&self, written: &Written) -> bool {
        let text = written.text();
        let is_list = matches!(written.language, Ok(WrittenIn::Il));
        text.trim().is_empty() || (is_list && declared(&text).is_blank)
    }
}
