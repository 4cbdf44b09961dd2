//! What has been written of a chart, and what is reported about it.

use crate::found::Found;
use crate::text::Text;
use unoclp_lang::{Code, Diagnostic, Span, Word};

/// An expression, and where its pieces are in the file.
pub(super) type Said = Vec<(String, Span)>;

/// A chart as a text.
#[derive(Default)]
pub(crate) struct Chart {
    /// The variables that it needs besides those of its unit, and their types.
    pub variables: Vec<(String, String, Span)>,
    /// Its parts.
    pub text: Text,
}

/// Who a message is about: `Main`, step `S1`.
pub(super) type Who = (String, String);

pub(super) fn tell<const N: usize>(
    found: &mut Found,
    code: Code,
    who: Who,
    at: Span,
    words: [Word; N],
) {
    let who = [Word::from(who)];
    let words: Vec<Word> = who.into_iter().chain(words).collect();
    found.take(Diagnostic::new(code, at, words));
}

/// What a body is written in.
pub(super) fn in_language(language: &str) -> Word {
    (
        format!("code in {language}"),
        format!("código em {language}"),
    )
        .into()
}
