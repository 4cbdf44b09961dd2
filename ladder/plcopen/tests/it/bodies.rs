//! Units with bodies in all five languages: shown as they stand in the file, changed there, and compiled.

use unoclp_core::Board;
use unoclp_plcopen::{
    Charts, Touch, Where, add, charts, draw, erase, import, outline, remove, retain, shown, touch,
    write_body, write_chart,
};
use unoclp_sfc::edit::Operation;
use unoclp_sfc::{Document, Id};

const FIVE: &str = include_str!("../../../../page/web/test/page/five.xml");

fn compiles(text: &str) {
    let imported = import(text, Board::UNO);
    let told = imported.diagnostics.listed;
    assert!(imported.program.is_some(), "{told:#?}");
}

/// What is between the first and the last byte that differ, in both.
fn difference<'t>(one: &'t str, other: &'t str) -> (&'t str, &'t str) {
    let alike = one.bytes().zip(other.bytes());
    let start = alike.take_while(|(a, b)| a == b).count();
    let rest = one[start..].bytes().rev().zip(other[start..].bytes().rev());
    let end = rest.take_while(|(a, b)| a == b).count();
    (
        &one[start..one.len() - end],
        &other[start..other.len() - end],
    )
}

#[test]
fn a_project_may_have_all_five_languages() {
    compiles(FIVE);
    let outline = outline(FIVE).unwrap();
    let languages: Vec<&str> = outline.units.iter().map(|unit| &*unit.language).collect();
    assert_eq!(languages, ["LD", "FBD", "IL", "ST", "SFC"]);
}

#[test]
fn what_a_list_says_twice_is_worth_what_it_was() {
    let list = |body: &str| write_body(FIVE, "Any", body).unwrap();
    compiles(&list("LD x\nST z\nAND y\nST z\n"));
    // The accumulator would be another value by then, so a variable keeps it.
    compiles(&list("LD x\nANDN z\nS z\nST z\n"));
}

#[test]
fn drawn_bodies_are_shown_where_their_file_lays_them_out() {
    let ladder = shown(FIVE, "LATCH").unwrap();
    assert_eq!(ladder.language, "LD");
    let stop = ladder.elements.iter().find(|of| of.written == "stop");
    let stop = stop.unwrap();
    assert!(stop.negated && stop.kind == "contact");
    assert!(FIVE[stop.at.range()].starts_with("<contact localId=\"4\""));
    assert_eq!(
        ladder.svg.matches("data-id=").count(),
        ladder.elements.len()
    );
    let blocks = shown(FIVE, "Pair").unwrap();
    // When it runs stands at it.
    assert!(blocks.svg.contains("order") && blocks.svg.contains(">AND<"));
    assert_eq!(shown(FIVE, "Any").unwrap().text.trim(), "LD x\nOR y\nST z");
    assert!(shown(FIVE, "nobody").is_none());
    // Without places it stands in columns.
    let bare = FIVE.replace("<position", "<nowhere");
    assert!(shown(&bare, "Latch").unwrap().svg.contains(">stop<"));
}

#[test]
fn an_element_is_changed_and_all_else_stays() {
    let touched = |element, change| touch(FIVE, "Latch", element, &change).unwrap();
    let written = touched("2", Touch::Written("on < \"1\"".to_owned()));
    assert_eq!(difference(FIVE, &written), ("go", "on &lt; &quot;1&quot;"));
    let plain = touched("4", Touch::Negated(false));
    assert_eq!(difference(FIVE, &plain), ("negated=\"true\" ", ""));
    let set = touched("5", Touch::Storage("set".to_owned()));
    assert_eq!(difference(FIVE, &set), ("", "storage=\"set\" "));
    compiles(&set);
    assert!(touch(FIVE, "Latch", "77", &Touch::Negated(true)).is_none());
}

#[test]
fn a_body_in_text_is_written_anew() {
    let after = write_body(FIVE, "Ready", "Ready := a & NOT b;").unwrap();
    assert_eq!(difference(FIVE, &after), ("AND", "&amp;"));
    compiles(&after);
    assert!(write_body(FIVE, "Latch", "x := 1;").is_none());
}

#[test]
fn a_chart_is_drawn_on_and_the_rest_of_the_file_stays() {
    let [chart]: [Document; 1] = charts(FIVE).try_into().unwrap();
    let after = chart.after(&Operation::StepAfter(Id::Step(1))).unwrap().0;
    let text = write_chart(FIVE, &after).unwrap();
    compiles(&text);
    let [again]: [Document; 1] = charts(&text).try_into().unwrap();
    assert_eq!(again.steps.len(), 3);
    assert_eq!(again.actions[0].body.trim(), chart.actions[0].body.trim());
    let begins = FIVE.find("<SFC>").unwrap();
    assert_eq!(FIVE[..begins], text[..begins]);
    assert_eq!(
        FIVE.split("<instances>").last(),
        text.split("<instances>").last()
    );
}

#[test]
fn rows_come_and_go() {
    let unit = Some("main");
    let names = |text: &str| -> Vec<(String, bool)> {
        let outline = outline(text).unwrap();
        let main = outline.units.last().unwrap();
        main.variables
            .iter()
            .map(|row| (row.name.clone(), row.retained))
            .collect()
    };
    let before = names(FIVE);
    let more = add(FIVE, unit, "localVars", "fresh", "INT").unwrap();
    assert_eq!(names(&more).last().unwrap().0, "fresh");
    assert_eq!(remove(&more, unit, "FRESH").unwrap(), FIVE);
    let input = add(FIVE, unit, "inputVars", "asked", "Latch").unwrap();
    assert_eq!(names(&input).len(), before.len() + 1);
    let kept = retain(FIVE, unit, "hold", true).unwrap();
    assert!(names(&kept).contains(&("hold".to_owned(), true)));
    compiles(&kept);
    let two = retain(&kept, unit, "one", true).unwrap();
    assert_eq!(two.matches("retain=\"true\"").count(), 1);
    let back = retain(&two, unit, "hold", false).unwrap();
    assert!(names(&back).contains(&("hold".to_owned(), false)));
    assert!(names(&back).contains(&("one".to_owned(), true)));
    assert!(add(FIVE, Some("nobody"), "localVars", "x", "INT").is_none());
}

/// The text with something new in a unit, and its number.
fn drawn(text: &str, unit: &str, place: Where, at: &str, what: &str) -> (String, String) {
    let after =
        draw(text, unit, place, at, what).unwrap_or_else(|| panic!("{what} {place:?} {at}"));
    compiles(&after);
    let elements = shown(&after, unit).unwrap().elements;
    let ids = elements.iter().filter_map(|of| of.id.parse::<u32>().ok());
    (after, ids.max().unwrap().to_string())
}

#[test]
fn a_ladder_of_a_unit_grows_and_shrinks() {
    let (text, contact) = drawn(FIVE, "Latch", Where::After, "4", "contact");
    let new = shown(&text, "Latch").unwrap();
    let own = new.elements.iter().find(|of| of.id == contact).unwrap();
    assert_eq!((&*own.kind, &*own.written), ("contact", "go"));
    assert!(text.contains(&format!("<connection refLocalId=\"{contact}\"/>")));
    let shorter = erase(&text, "Latch", &contact).unwrap();
    compiles(&shorter);
    assert!(shorter.contains(
        "<connectionPointIn><relPosition x=\"0\" y=\"7\"/><connection refLocalId=\"4\"/>"
    ));
    // In parallel: what takes the one takes the other.
    let (text, beside) = drawn(FIVE, "Latch", Where::Beside, "3", "contact");
    assert!(text.contains("<connection refLocalId=\"3\"/>"));
    assert!(text.contains(&format!("<connection refLocalId=\"{beside}\"/>")));
    let (text, coil) = drawn(&text, "Latch", Where::Beside, "5", "coil");
    let (text, _) = drawn(&text, "Latch", Where::Before, &coil, "contact");
    // A block of the standard gets an instance, one of the project too.
    let (text, timer) = drawn(&text, "Latch", Where::Before, "5", "TON");
    assert!(
        text.contains("<variable name=\"TON_1\"><type><derived name=\"TON\"/></type></variable>")
    );
    let (text, pair) = drawn(&text, "Latch", Where::After, &timer, "Pair");
    assert!(text.contains("instanceName=\"Pair_1\""));
    let (text, _) = drawn(&text, "Latch", Where::After, "4", "Ready");
    let (text, _) = drawn(&text, "Latch", Where::After, "4", "GT");
    let (text, _) = drawn(&text, "Latch", Where::After, "4", "ADD");
    let (text, _) = drawn(&text, "Latch", Where::Below, "", "coil");
    let before = shown(&text, "Latch").unwrap().elements.len();
    let text = erase(&text, "Latch", &pair).unwrap();
    compiles(&text);
    // The value at its other input goes with it.
    assert_eq!(shown(&text, "Latch").unwrap().elements.len(), before - 2);
    // Nothing stands before the left rail, and no value in a ladder.
    assert!(draw(FIVE, "Latch", Where::Before, "1", "contact").is_none());
    assert!(draw(FIVE, "Latch", Where::After, "4", "value").is_none());
    assert!(draw(FIVE, "Latch", Where::After, "4", "Nobody").is_none());
    assert!(draw(FIVE, "Ready", Where::Below, "", "coil").is_none());
}

#[test]
fn a_block_diagram_of_a_unit_grows_and_shrinks() {
    let (text, not) = drawn(FIVE, "Pair", Where::After, "3", "NOT");
    let (text, _) = drawn(&text, "Pair", Where::After, &not, "TON");
    let (text, _) = drawn(&text, "Pair", Where::Before, "3", "OR");
    let (text, _) = drawn(&text, "Pair", Where::Before, "3", "value");
    assert!(text.contains("formalParameter=\"IN3\""), "{text}");
    let (text, more) = drawn(&text, "Pair", Where::After, &not, "variable");
    let (text, _) = drawn(&text, "Pair", Where::Beside, &more, "variable");
    let (text, _) = drawn(&text, "Pair", Where::Below, "", "variable");
    let text = erase(&text, "Pair", &not).unwrap();
    compiles(&text);
    assert!(text.contains("a comment of the author's"));
    assert!(draw(FIVE, "Pair", Where::After, "4", "NOT").is_none());
    assert!(draw(FIVE, "Pair", Where::After, "3", "contact").is_none());
}

#[test]
fn parts_of_a_chart_know_their_places_in_the_file() {
    let charts = Charts::of(FIVE);
    let places = charts.documents[0].places();
    let said = |place: &std::ops::Range<usize>| -> Vec<&str> {
        let places = charts.in_file(place.clone()).into_iter();
        places.map(|place| &FIVE[place]).collect()
    };
    let step = said(&places.steps[1]);
    assert!(
        step.iter().any(|of| of.starts_with("<step localId=\"2\"")),
        "{step:?}"
    );
    let transition = said(&places.transitions[1]);
    assert!(transition.contains(&"halt"), "{transition:?}");
    assert!(
        said(&places.actions[0])
            .concat()
            .contains("hold(go := start")
    );
}
