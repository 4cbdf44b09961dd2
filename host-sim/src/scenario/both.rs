//! A text that stands in a file in both languages.
//!
//! Owns the pair. Must not know what it says.

use serde::Deserialize;
use unoclp_source::Lang;

/// A text in both languages: `{ en = "…", pt = "…" }`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Both {
    /// English.
    pub en: String,
    /// Brazilian Portuguese.
    pub pt: String,
}

impl Both {
    /// A text that is the same in both.
    pub fn same(text: &str) -> Both {
        Both {
            en: text.to_owned(),
            pt: text.to_owned(),
        }
    }

    /// The text in this language.
    pub fn text(&self, lang: Lang) -> &str {
        match lang {
            Lang::En => &self.en,
            Lang::Pt => &self.pt,
        }
    }
}
