//! Units with bodies in all five languages: shown as they stand in the file, changed there, and compiled.

use unoclp_core::Board;
use unoclp_plcopen::{
    Touch, add, charts, import, outline, remove, retain, shown, touch, write_body, write_chart,
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
