//! A text in both languages.

use unoclp_words::Lang;

/// A text in both languages; one alone serves for both.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// English.
    pub en: String,
    /// Brazilian Portuguese.
    pub pt: String,
}

impl From<&Text> for unoclp_words::Both {
    fn from(text: &Text) -> unoclp_words::Both {
        unoclp_words::both(|lang| text.text(lang).to_owned())
    }
}

impl Text {
    /// The same in both.
    pub fn same(text: &str) -> Text {
        Text {
            en: text.to_owned(),
            pt: text.to_owned(),
        }
    }

    /// In this language.
    pub fn text(&self, lang: Lang) -> &str {
        match lang {
            Lang::En => &self.en,
            Lang::Pt => &self.pt,
        }
    }
}
