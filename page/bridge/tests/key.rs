//! What a key press costs: nothing of it is done twice.

#![cfg(feature = "full")]

mod asked;

use asked::told;
use serde_json::{Value, json};
use unoclp_bridge::Boards;
use unoclp_checked::Work;

const RUNGS: usize = 100;

fn rungs() -> String {
    let rung = |number| {
        let marker = 1 + number % 64;
        format!("LD I1\nANDN I2\nAND(\nLD I3\nOR I4\n)\nST M{marker}\n")
    };
    let rungs: Vec<String> = (0..RUNGS).map(rung).collect();
    rungs.join("\n")
}

fn ok(boards: &mut Boards, request: Value) -> Value {
    let told = told(boards, request);
    assert!(told.get("ok").is_some(), "{told}");
    told["ok"].clone()
}

fn edit(boards: &mut Boards, act: Value) -> Value {
    let request = json!({ "ask": "edit", "act": act, "name": "a.il", "width": 80, "speak": "en" });
    ok(boards, request)
}

/// How many rungs come with a drawing.
fn drawn(view: &Value) -> usize {
    let rungs = view["sheet"]["rungs"].as_array().unwrap();
    let drawn = rungs.iter().filter(|rung| rung["drawn"].is_object());
    drawn.count()
}

/// A page with a drawing of 100 rungs.
fn drawing() -> Boards {
    let mut boards = Boards::default();
    let base = json!({ "name": "a.il", "text": rungs() });
    let draw = json!({ "ask": "draw", "base": base, "log": [], "width": 80, "speak": "en" });
    let view = ok(&mut boards, draw);
    assert_eq!(view["isProgram"], true);
    assert_eq!(drawn(&view), RUNGS);
    edit(&mut boards, json!({ "do": "move", "to": "right" }));
    boards
}

#[test]
fn a_key_press_in_a_drawing_of_100_rungs_makes_one_of_each() {
    let mut boards = drawing();
    let mut last = rungs();
    for _ in 0..3 {
        let before = Work::done();
        // Open to closed, and what the page asks of the text that this makes.
        let view = edit(&mut boards, json!({ "do": "toggle" }));
        let text = view["text"].as_str().unwrap();
        let check = json!({ "ask": "check", "version": view["version"] });
        let checked = ok(&mut boards, check);
        let again = json!({ "ask": "check", "name": "a.il", "text": text });
        assert_eq!(ok(&mut boards, again), checked, "one version");
        let work = Work::since(before);
        assert!(text != last && view["sheet"].is_object(), "{text}");
        assert!(checked["program"].is_object());
        let is = (work.emissions, work.passes, work.drawings, work.compiles);
        assert_eq!(is, (1, 1, 1, 1), "{work:?}");
        assert_eq!((work.rungs, drawn(&view)), (1, 1), "the others stay");
        last = text.to_owned();
        edit(&mut boards, json!({ "do": "move", "to": "down" }));
    }
}

#[test]
fn a_cursor_that_moves_makes_nothing() {
    let mut boards = drawing();
    let before = Work::done();
    let view = edit(&mut boards, json!({ "do": "move", "to": "down" }));
    assert_eq!(view["sheet"], Value::Null);
    assert_eq!(Work::since(before), Work::default());
}

/// A key that makes the drawing no program has nothing to compile.
#[test]
fn a_contact_without_an_address_is_not_compiled() {
    let mut boards = drawing();
    let before = Work::done();
    let act = json!({ "do": "insert", "what": "contact", "place": "behind" });
    let view = edit(&mut boards, act);
    assert_eq!(view["isProgram"], false);
    let work = Work::since(before);
    let is = (work.emissions, work.passes, work.drawings, work.compiles);
    assert_eq!((is, drawn(&view)), ((1, 1, 1, 0), 1));
}

/// What stands below a new rung has another number above it, and else only another place.
#[test]
fn a_contact_more_moves_the_rungs_below_it() {
    let mut boards = drawing();
    let places = |view: &Value| {
        let rungs = view["sheet"]["rungs"].as_array().unwrap().iter();
        let place = |rung: &Value| {
            (
                rung["nets"].as_u64().unwrap(),
                rung["top"].as_f64().unwrap(),
            )
        };
        rungs.map(place).collect::<Vec<_>>()
    };
    let before = places(&edit(&mut boards, json!({ "do": "toggle" })));
    let act = json!({ "do": "insert", "what": "contact", "place": "beside" });
    let view = edit(&mut boards, act);
    let after = places(&view);
    assert_eq!((drawn(&view), before[0]), (1, after[0]));
    let below = before.iter().zip(&after).skip(1);
    assert!(below.clone().count() == RUNGS - 1);
    assert!(
        below
            .clone()
            .all(|(one, other)| one.0 < other.0 && one.1 < other.1)
    );
}
