//! Answers as texts.

use serde::Serialize;

/// As JSON. What is answered has no keys but texts, and so always is.
pub fn json(answer: impl Serialize) -> String {
    serde_json::to_string(&answer).unwrap_or_default()
}
