//! Why something is not done, and what could be done instead.

use serde::Serialize;
use unoclp_draw::edit::Refusal;
use unoclp_words::{Both, both};

/// Why something is not done, where a field is wrong with its key and what could stand in it instead.
#[derive(Clone, Debug, Serialize)]
pub struct Amiss {
    /// What is wrong.
    #[serde(flatten)]
    pub told: Both,
    /// The field that is wrong.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field: Option<String>,
    /// What could stand there.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub offers: Vec<Offer>,
}

/// What could stand in a field instead.
#[derive(Clone, Debug, Serialize)]
pub struct Offer {
    /// What the field has then.
    pub value: String,
    /// What a person is told of it.
    pub say: Both,
    /// Whether the person is asked no more.
    pub sure: bool,
}

impl Amiss {
    /// The same as of this field, with offers.
    #[must_use]
    pub fn at(self, field: &str, offers: Vec<Offer>) -> Amiss {
        let field = Some(field.to_owned());
        Amiss {
            field,
            offers,
            ..self
        }
    }
}

impl From<Both> for Amiss {
    fn from(told: Both) -> Amiss {
        Amiss {
            told,
            field: None,
            offers: Vec::new(),
        }
    }
}

impl From<Refusal> for Amiss {
    fn from(refusal: Refusal) -> Amiss {
        both(|lang| crate::refusal(lang, refusal)).into()
    }
}
