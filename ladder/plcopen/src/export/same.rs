//! What is written is read again, and must be the same program.

use super::lost::Lost;
use unoclp_core::Board;
use unoclp_core::isa::Opcode;
use unoclp_draw::edit::{Document, Id};

/// What is not read again as it was.
pub(crate) fn not_read(document: &Document, text: &str, board: Board) -> Vec<Lost> {
    let made = crate::import(text, board).document;
    let own = instructions(document);
    let read = made.as_ref().map(instructions).unwrap_or_default();

    let pairs = own.iter().zip(&read);
    let alike = pairs.take_while(|(one, other)| one.1 == other.1).count();
    if made.is_some() && alike == own.len() && alike == read.len() {
        return Vec::new();
    }
    let at = own.get(alike).or(own.last()).map_or(Id(0), |(id, _)| *id);
    vec![Lost {
        at,
        rung: document.rung_of(at).map_or(1, |rung| rung + 1),
        what: "( … )".to_owned(),
        is_blocks: false,
    }]
}

/// Whether this project comes to the codes of a document.
pub(crate) fn says(text: &str, document: &Document, board: Board) -> bool {
    let made = crate::import(text, board).program;
    let read = made.as_ref().map(|(checked, _)| {
        let steps = checked.program().steps();
        steps.flat_map(|step| step.codes()).collect::<Vec<i32>>()
    });
    let own = document.codes();
    let own = own.ok().and_then(|own| own.get(1..).map(<[i32]>::to_vec));
    read.is_some() && read == own
}

/// The instructions of a document. A new rung says nothing where one begins by itself, nor does one on which nothing
/// stands.
fn instructions(document: &Document) -> Vec<(Id, Vec<i32>)> {
    let begins = |lines: &[i32]| lines == [Opcode::NewRung.row().code];
    let mut said: Vec<(Id, Vec<i32>)> = Vec::new();
    for (id, lines) in document.instructions().unwrap_or_default() {
        if begins(&lines) {
            said.pop_if(|(_, before)| begins(before));
        }
        if !begins(&lines) || !said.is_empty() {
            said.push((id, lines));
        }
    }
    said.pop_if(|(_, last)| begins(last));
    said
}
