//! A text of another PLC with its points on this board, for a page.

use crate::program::{LONGEST, Text};
use crate::words::{self, No, both};
use serde::Serialize;
use unoclp_program::Written;

/// A text with free points in the place of those that its board lacks.
#[derive(Debug, Serialize)]
pub struct Adapted {
    text: String,
    /// Those for which the board has no place left, as the text writes them.
    left: Vec<String>,
}

/// The text with its points on its board; none in a language whose points are names of its own.
///
/// # Errors
/// If it is too long.
pub fn adapt(text: Text) -> Result<Option<Adapted>, No> {
    if text.text.len() > LONGEST {
        return Err(both(|lang| words::too_long(lang, LONGEST)).into());
    }
    let written = Written::new(text.name, text.text.into_bytes(), text.board);
    let adapted = written.adapted().ok().flatten();
    Ok(adapted.map(|adapted| Adapted {
        text: adapted.text,
        left: adapted.left,
    }))
}
