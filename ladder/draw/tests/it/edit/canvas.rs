//! The sheet of a document: everything on it has a place, and something can be inserted wherever it says so.

use super::operations::operation;
use unoclp_core::isa::Opcode;
use unoclp_core::{Board, Loader, Target};
use unoclp_draw::edit::{
    Along, Canvas, Coil, Cursor, Document, Draft, Drawn, Editor, Node, Opening, Operation, Place,
    Row, Spot, Step, Strip, visit,
};
use unoclp_draw::{Area, Look};
use unoclp_point::Address;
use unoclp_testing::{Random, held, rounds};

/// A seal-in circuit with a timer, a rung that ends in an IF, an empty path, and an empty rung.
fn document() -> Document {
    of_codes("0 827301 40 827901 41 -827302 847978 500 7901 7370 827303 40 41 877902 697868 787600")
}

/// The document that a program's codes say.
pub fn of_codes(codes: &str) -> Document {
    let mut memory = vec![0; 2_000];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    let text = codes.replace(' ', "\n");
    text.bytes().for_each(|byte| loader.push(byte).unwrap());
    Document::of_steps(loader.finish().unwrap().steps())
}

fn after(document: &Document, before: Option<&Canvas>) -> Canvas {
    let title = |number: usize| format!("Rung {number}");
    Drawn::of(document).canvas(document, (Look::Ladder, 80), &title, before)
}

fn canvas(document: &Document) -> Canvas {
    after(document, None)
}

/// An area of a rung, on the whole sheet.
fn on_sheet(strip: &Strip, area: Area) -> Area {
    Area {
        y: area.y + strip.top,
        ..area
    }
}

fn svg(canvas: &Canvas) -> String {
    let rungs = canvas.rungs.iter();
    rungs.map(|strip| strip.drawn.svg.as_str()).collect()
}

fn spots(canvas: &Canvas) -> Vec<Spot> {
    let of = |strip: &Strip| {
        let spot = |spot: &Spot| Spot {
            area: on_sheet(strip, spot.area),
            ..*spot
        };
        strip.drawn.spots.iter().map(spot).collect::<Vec<_>>()
    };
    canvas.rungs.iter().flat_map(of).collect()
}

fn places(canvas: &Canvas) -> Vec<Opening> {
    let of = |strip: &Strip| {
        let opening = |opening: &Opening| Opening {
            area: on_sheet(strip, opening.area),
            ..*opening
        };
        strip.drawn.places.iter().map(opening).collect::<Vec<_>>()
    };
    canvas.rungs.iter().flat_map(of).collect()
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
    let (svg, (width, height)) = (svg(&canvas), canvas.size);
    let sheet = Area {
        x: 0.0,
        y: 0.0,
        width,
        height,
    };
    for spot in spots(&canvas) {
        let name = format!("data-id=\"{}\"", spot.id.0);
        assert!(svg.contains(&name), "{name} in {svg}");
        assert!(overlap(spot.area, sheet), "{spot:?}");
    }
    // Four contacts, a timer with its coil, an IF, a path without an element, a coil; and four rungs.
    assert_eq!(spots(&canvas).len(), 4 + 2 + 1 + 1 + 1 + 4);
    assert!(svg.contains("Rung 4"));
    assert!(svg.contains("END_IF:"));
}

#[test]
fn an_element_can_be_inserted_at_each_opening() {
    let canvas = canvas(&document());
    let contact = Draft::contact(Some(Address::Input(4)), false).unwrap();
    for opening in places(&canvas) {
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
    let places = places(&canvas);
    for (index, one) in places.iter().enumerate() {
        for other in &places[..index] {
            assert!(!overlap(one.area, other.area), "{one:?} {other:?}");
        }
    }
    let empty = places.iter().filter(|opening| opening.area.width > 100.0);
    assert!(
        empty.count() >= 2,
        "the empty rungs are openings as a whole"
    );
}

#[test]
fn each_element_is_found_by_its_name_and_nothing_else_is_one() {
    let document = document();
    let mut elements = 0;
    for (number, rung) in document.rungs().enumerate() {
        visit(&rung.series, &mut |node| {
            let found = document.element(node.id()).map(|element| element.id);
            let is_element = matches!(node, Node::Element(_));
            assert_eq!(found, is_element.then(|| node.id()));
            assert_eq!(document.rung_of(node.id()), Some(number));
            elements += usize::from(is_element);
        });
        assert!(document.element(rung.id).is_none());
    }
    assert_eq!(elements, 7);
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
    let before = spots(&canvas(editor.document()));
    editor.apply(&Operation::InsertRung(Along::Back)).unwrap();
    editor.undo().unwrap();
    assert_eq!(spots(&canvas(editor.document())), before);
}

/// What a page puts in place of what it has, comes to what it would be drawn anew.
#[test]
fn a_rung_that_is_not_drawn_again_is_as_if_it_were() {
    let (mut again, mut kept) = (0, 0);
    let mut draw = |seed: u64| {
        let random = &mut Random(seed);
        let mut editor = Editor::new(document());
        let mut before = canvas(editor.document());
        for count in 0..60 {
            let step = operation(random, editor.document());
            // What is refused changes nothing.
            let _ = editor.apply(&step);
            let now = after(editor.document(), Some(&before));
            let anew = canvas(editor.document());
            assert_eq!(svg(&now), svg(&anew), "seed {seed}, {count}: {step:?}");
            assert_eq!(spots(&now), spots(&anew), "seed {seed}, {count}");
            assert_eq!(places(&now), places(&anew), "seed {seed}, {count}");
            for (one, other) in now.rungs.iter().zip(&anew.rungs) {
                let says = |strip: &Strip| (strip.id, strip.nets, strip.first);
                assert_eq!(says(one), says(other), "seed {seed}, {count}");
            }
            let new = now.rungs.iter().filter(|strip| strip.is_new).count();
            again += new;
            kept += now.rungs.len() - new;
            before = now;
        }
    };
    (0..u64::from(rounds(60))).for_each(|seed| held(|| draw(seed)));
    assert!(kept > again, "{kept} of {again}");
}

#[test]
fn a_point_is_shown_by_its_name() {
    let mut editor = Editor::new(document());
    let row = Row {
        name: "start".to_owned(),
        comment: String::new(),
    };
    let name = Operation::Name(Address::Input(1), row);
    editor.apply(&name).unwrap();
    assert!(svg(&canvas(editor.document())).contains("start"));
}
