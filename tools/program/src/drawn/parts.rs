//! What of a document has a place in its text.

use unoclp_draw::edit::{Document, Row};
use unoclp_point::Address;

/// Rows of the symbol table that have a name.
pub(super) fn named(document: &Document) -> impl Iterator<Item = (Address, &Row)> {
    document
        .table()
        .rows()
        .filter(|(_, row)| !row.name.is_empty())
}
