//! What of a document has a place in its text.

use unoclp_core::Program;
use unoclp_draw::Ladder;
use unoclp_draw::edit::{Document, Row, Rung};
use unoclp_point::Address;

/// The first step of each rung that has steps, and the rung.
pub(super) fn rungs<'d>(document: &'d Document, program: &Program<'_>) -> Vec<(usize, &'d Rung)> {
    let ladder = Ladder::new(program.steps());
    let starts = ladder.rungs.iter().map(|rung| rung.first);
    // A first rung without a code is none of the program.
    let behind = document.rungs().len().saturating_sub(ladder.rungs.len());
    starts.zip(document.rungs().skip(behind)).collect()
}

/// Rows of the symbol table that have a name.
pub(super) fn named(document: &Document) -> impl Iterator<Item = (Address, &Row)> {
    document
        .table()
        .rows()
        .filter(|(_, row)| !row.name.is_empty())
}
