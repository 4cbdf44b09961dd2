//! Both looks, and what is live.

use unoclp_sfc::{Document, Id, Live, Look, Sheet, State, picture, svg};

const CHART: &str = "\
PROGRAM main
VAR a, b, v, w : BOOL; END_VAR
INITIAL_STEP S1: END_STEP
STEP S2: v(N); w(D, T#2s); END_STEP
STEP S3: v(S); END_STEP
STEP S4: v(R); w(L, T#1s); END_STEP
TRANSITION FROM S1 TO (S2, S3) := a AND NOT b OR S3.X; END_TRANSITION
TRANSITION wait FROM (S2, S3) TO S4 := S2.T >= T#5s; END_TRANSITION
TRANSITION (PRIORITY := 2) FROM S4 TO S1 := TRUE; END_TRANSITION
TRANSITION (PRIORITY := 1) FROM S4 TO S4 := a <> b; END_TRANSITION
END_PROGRAM
";

fn drawn(look: Look, live: Option<&Live>) -> String {
    let document = Document::all(CHART).remove(0);
    picture(&document, &Sheet::drawn(&document, look), live)
}

#[test]
fn the_norm_and_grafcet_have_words_of_their_own() {
    assert_eq!(drawn(Look::Norm, None), include_str!("norm.txt"));
    assert_eq!(drawn(Look::Grafcet, None), include_str!("grafcet.txt"));
}

#[test]
fn active_steps_have_a_dot_and_transitions_that_may_fire_too() {
    let document = Document::all(CHART).remove(0);
    let live = Live::of(&document, |step| State {
        active: matches!(step, "S2" | "S3"),
        time: (step == "S3").then_some(1_250),
    });
    assert_eq!(live.line(&document), "● S2  ● S3 1.2 s");
    assert!(live.may_fire(&document, 1) && !live.may_fire(&document, 0));
    assert_eq!(drawn(Look::Norm, Some(&live)), include_str!("live.txt"));
    let sheet = Sheet::drawn(&document, Look::Norm);
    let written = svg(&document, &sheet, Some(&live), "A & B", true);
    for part in [
        "<g class=\"step active\" data-id=\"s1\">",
        "<g class=\"step initial\" data-id=\"s0\">",
        "<g class=\"transition ready\" data-id=\"t1\">",
        "<g class=\"transition\" data-id=\"t0\">",
        "aria-label=\"A &amp; B\"",
        ">1.2 s</text>",
    ] {
        assert!(written.contains(part), "{part}: {written}");
    }
}

#[test]
fn ids_are_read_as_they_are_written() {
    for id in [
        Id::Step(3),
        Id::Does(1, 2),
        Id::Transition(0),
        Id::Jump(4, 1),
        Id::Wait(7, 2),
    ] {
        assert_eq!(id.to_string().parse(), Ok(id));
    }
    for text in [
        "",
        "s",
        "x1",
        "a1",
        "j1.",
        "s-1",
        "é",
        "t99999999999999999999",
    ] {
        assert!(text.parse::<Id>().is_err(), "{text}");
    }
}
