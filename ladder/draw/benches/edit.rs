//! What the ladder editor does at each step, of a document of 100 rungs: check it, make codes of it, draw it, change it.
//! A page in WebAssembly has 5 ms for the check. `cargo bench -p unoclp-draw` measures it, and counts what it allocates.

use divan::{AllocProfiler, Bencher, black_box};
use unoclp_core::Board;
use unoclp_draw::edit::{
    Along, Coil, Cursor, Document, Draft, Drawn, Editor, Operation, Place, Row, State, apply,
};
use unoclp_draw::{Look, Names};
use unoclp_point::Address;

#[global_allocator]
static ALLOCATOR: AllocProfiler = AllocProfiler::system();

const RUNGS: usize = 100;

fn main() {
    divan::main();
}

/// Rungs of four contacts, one of them beside another, and a coil.
fn document() -> Document {
    let mut editor = Editor::new(Document::new());
    let contact = |number, closed| Draft::contact(Some(Address::Input(number)), closed).unwrap();
    for rung in 0..RUNGS {
        let marker = Address::Marker(1 + (rung % 64) as u8);
        let coil = Draft::coil(Some(marker), Coil::Normal).unwrap();
        let operations = [
            Operation::Insert(coil, Place::Behind),
            Operation::Insert(contact(1, false), Place::Before),
            Operation::Insert(contact(2, true), Place::Behind),
            Operation::Insert(contact(3, false), Place::Behind),
            Operation::Insert(contact(4, false), Place::Beside),
            Operation::InsertRung(Along::Forth),
        ];
        for operation in &operations[..operations.len() - usize::from(rung + 1 == RUNGS)] {
            editor.apply(operation).unwrap();
        }
    }
    editor.document().clone()
}

#[divan::bench]
fn check(bencher: Bencher<'_, '_>) {
    let document = document();
    assert_eq!(document.rungs().len(), RUNGS);
    bencher.bench_local(|| black_box(&document).check(Board::UNO));
}

#[divan::bench]
fn codes(bencher: Bencher<'_, '_>) {
    let document = document();
    bencher.bench_local(|| black_box(&document).codes());
}

#[divan::bench]
fn draw(bencher: Bencher<'_, '_>) {
    let document = document();
    bencher.bench_local(|| {
        let drawn = Drawn::of(black_box(&document));
        drawn.draw(80, &Names::new()).rungs.len()
    });
}

#[divan::bench]
fn canvas(bencher: Bencher<'_, '_>) {
    let document = document();
    let title = |number: usize| number.to_string();
    bencher.bench_local(|| {
        Drawn::of(black_box(&document))
            .canvas(&document, (Look::Ladder, 80), &title, None)
            .rungs
            .len()
    });
}

#[divan::bench]
fn insert_a_contact(bencher: Bencher<'_, '_>) {
    let mut state = State::new(document());
    let rung = state.document.rungs().nth(RUNGS / 2).unwrap().id;
    state.cursor = Cursor::at(rung);
    let contact = Draft::contact(Some(Address::Input(1)), false).unwrap();
    let insert = Operation::Insert(contact, Place::Before);
    bencher.bench_local(|| apply(black_box(&state), &insert));
}

#[divan::bench]
fn name_a_point(bencher: Bencher<'_, '_>) {
    let state = State::new(document());
    let row = Row {
        name: "start".to_owned(),
        comment: String::new(),
    };
    let name = Operation::Name(Address::Input(1), row);
    bencher.bench_local(|| apply(black_box(&state), &name));
}
