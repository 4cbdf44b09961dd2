//! A text that stands in a file in both languages, or in one that serves for both.
//!
//! Owns the pair. Must not know what it says.

use super::words::both_languages;
use serde::Deserialize;
use unoclp_program::Lang;

/// A text in both languages: `{ en = "…", pt = "…" }`. In a file one of the two is enough, and so is `"…"`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(try_from = "Written")]
pub struct Both {
    /// English.
    pub en: String,
    /// Brazilian Portuguese.
    pub pt: String,
}

impl From<&Both> for unoclp_words::Both {
    fn from(told: &Both) -> unoclp_words::Both {
        unoclp_words::both(|lang| told.text(lang).to_owned())
    }
}

/// A text as it stands in a file.
#[derive(Deserialize)]
#[serde(untagged)]
enum Written {
    Same(String),
    Pair(Pair),
    Other(serde::de::IgnoredAny),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Pair {
    en: Option<String>,
    pt: Option<String>,
}

impl TryFrom<Written> for Both {
    type Error = String;

    fn try_from(written: Written) -> Result<Both, String> {
        match written {
            Written::Same(text) => Ok(Both::same(&text)),
            Written::Pair(Pair {
                en: Some(en),
                pt: Some(pt),
            }) => Ok(Both { en, pt }),
            Written::Pair(Pair { en, pt }) => en
                .or(pt)
                .map(|text| Both::same(&text))
                .ok_or_else(|| both_languages(Lang::En)),
            Written::Other(_) => Err(both_languages(Lang::En)),
        }
    }
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
