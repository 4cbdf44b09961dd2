//! A text of another PLC with its points on this board, for a page.

use crate::answer::answer;
use unoclp_program::Written;

answer! {
    /// A text with free points in the place of those that its board lacks.
    pub struct Adapted as "Adapted" {
        text: String,
        /// Those for which the board has no place left, as the text writes them.
        left: Vec<String>,
    }
}

/// The text with its points on its board; none in a language whose points are names of its own.
pub fn adapt(written: &Written) -> Option<Adapted> {
    let adapted = written.adapted().ok().flatten();
    adapted.map(|adapted| Adapted {
        text: adapted.text,
        left: adapted.left,
    })
}
