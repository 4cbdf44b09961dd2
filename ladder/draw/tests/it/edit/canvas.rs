//! The sheet of a document: everything on it has a place, and something can be inserted wherever it says so.

use unoclp_core::isa::Opcode;
use unoclp_core::{Board, Loader, Target};
use unoclp_draw::Area;
use unoclp_draw::edit::{
    Along, Canvas, Coil, Cursor, Document, Draft, Drawn, Editor, Operation, Place, Step,
};
use unoclp_point::Address;

/// A seal-in circuit with a timer, a rung that ends in an IF, an empty path, and an empty rung.
fn document() -> Document {
    let codes =
        "0 827301 40 827901 41 -827302 847978 500 7901 7370 827303 40 41 877902 697868 787600";
    let mut memory = vec![0; 2_000];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    let text = codes.replace(' ', "\n");
    text.bytes().for_each(|byte| loader.push(byte).unwrap());
    Document::of_steps(loader.finish().unwrap().steps())
}

fn canvas(document: &Document) -> Canvas {
    let title = |number: usize| format!("Rung {number}");
    Drawn::of(document).canvas(document, 80, &title, "a program")
}

fn overlap(one: Area, other: Area) -> bool {
    one.x < other.x + other.width
        && other.x < one.x + one.width
        && one.y < other.y + other.height
        && other.y < one.y + one.height
}

#[test]
fn what_is_on_the_sheet_has_its_name_and_a_place_on_it() {
    let document = document();
    let canvas = canvas(&document);
    for spot in &canvas.spots {
        let name = format!("data-id=\"{}\"", spot.id.0);
        assert!(canvas.svg.contains(&name), "{name} in {}", canvas.svg);
        assert!(overlap(spot.area, canvas.area), "{spot:?}");
    }
    // Four contacts, a timer with its coil, an IF, a path without an element, a coil; and four rungs.
    assert_eq!(canvas.spots.len(), 4 + 2 + 1 + 1 + 1 + 4);
    assert!(canvas.svg.contains("Rung 4"));
    assert!(canvas.svg.contains("END_IF:"));
}

#[test]
fn an_element_can_be_inserted_at_each_opening() {
    let canvas = canvas(&document());
    let contact = Draft::contact(Some(Address::Input(4)), false).unwrap();
    for opening in &canvas.places {
        let mut editor = Editor::new(document());
        let before = editor.document().codes().unwrap().len();
        editor
            .apply(&Operation::Select(Cursor::at(opening.at)))
            .unwrap();
        let insert = Operation::Insert(contact.clone(), opening.place);
        editor
            .apply(&insert)
            .unwrap_or_else(|refusal| panic!("{opening:?}: {refusal:?}"));
        assert!(
            editor.document().codes().unwrap().len() > before,
            "{opening:?}"
        );
    }
}

#[test]
fn openings_do_not_cover_each_other() {
    let canvas = canvas(&document());
    for (index, one) in canvas.places.iter().enumerate() {
        for other in &canvas.places[..index] {
            assert!(!overlap(one.area, other.area), "{one:?} {other:?}");
        }
    }
    let empty = canvas
        .places
        .iter()
        .filter(|opening| opening.area.width > 100.0);
    assert!(
        empty.count() >= 2,
        "the empty rungs are openings as a whole"
    );
}

#[test]
fn what_a_screen_asks_for_keeps_its_names() {
    let mut editor = Editor::new(Document::new());
    let timer = Draft::timer(Opcode::OnDelay, None, Some(Target::Output(1))).unwrap();
    let coil = Draft::coil(None, Coil::Set).unwrap();
    for draft in [timer, coil, Step::new(Opcode::Not).into()] {
        editor
            .apply(&Operation::Insert(draft, Place::Behind))
            .unwrap();
    }
    let before = canvas(editor.document()).spots;
    editor.apply(&Operation::InsertRung(Along::Back)).unwrap();
    editor.undo().unwrap();
    assert_eq!(canvas(editor.document()).spots, before);
}
