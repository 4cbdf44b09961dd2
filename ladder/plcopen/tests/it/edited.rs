//! What is drawn at random, operation by operation, is exported and imported again as the same codes, or refused.

#[path = "../../../draw/tests/it/edit/operations.rs"]
mod operations;

use crate::round_trip::comes_back;
use operations::operation;
use unoclp_core::Board;
use unoclp_draw::edit::{Document, Editor};
use unoclp_testing::{Random, held, rounds};

/// Each on a document of its own, looked at again and again as it grows.
const RUNS: u32 = 400;
const OPERATIONS: usize = 100;
const EVERY: usize = 5;

/// Whether a board takes it.
fn compiles(document: &Document) -> bool {
    let mistakes = document.check(Board::UNO);
    !mistakes.iter().any(|mistake| mistake.what.is_error())
}

#[test]
fn edited_documents_come_back() {
    let (mut same, mut lost) = (0, 0);
    let mut run = |seed: u32| {
        let random = &mut Random(seed.into());
        let mut editor = Editor::new(Document::new());
        for count in 1..=OPERATIONS {
            // What is refused leaves the document as it is.
            let _ = editor.apply(&operation(random, editor.document()));
            if count % EVERY == 0 && compiles(editor.document()) {
                match comes_back(editor.document()) {
                    true => same += 1,
                    false => lost += 1,
                }
            }
        }
    };
    (0..rounds(RUNS)).for_each(|seed| held(|| run(seed)));
    println!("{same} same, {lost} refused");
    assert!(lost < same + same / 10, "{same} same, {lost} refused");
}
