//! Which part of a chart each instruction comes from: in a text, and in the same as a project.

use std::collections::BTreeSet;
use unoclp_core::Board;
use unoclp_program::{Source, Written};
use unoclp_sfc::{Document, Id, Origin};
use unoclp_testing::chart::sketch;
use unoclp_testing::rounds;

const FILLING: &str = "\
PROGRAM filling
VAR start AT %IX1 : BOOL; full AT %IX2 : BOOL; valve AT %QX1 : BOOL; lamp AT %QX2 : BOOL; END_VAR
INITIAL_STEP Wait: END_STEP
STEP Fill: valve(N);
  Blink(N); END_STEP
STEP Rest: END_STEP
TRANSITION FROM Wait TO Fill := start; END_TRANSITION
TRANSITION FROM Fill TO Rest := full; END_TRANSITION
TRANSITION FROM Rest TO Wait := NOT full AND Rest.T > T#2s; END_TRANSITION
ACTION Blink:
  lamp := NOT lamp;
END_ACTION
END_PROGRAM
";

/// None of one that no board of this kind has room for.
fn source(name: &str, text: &str) -> Option<Source> {
    let written = Written::new(name.to_owned(), text.as_bytes().to_vec(), Board::UNO);
    written.check(None).ok()
}

/// The instructions of a part.
fn of(source: &Source, origin: Option<Origin>) -> Vec<usize> {
    let all = source.origins[0].iter().enumerate();
    let own = all.filter(|(_, from)| from.is_some() && **from == origin);
    own.map(|(step, _)| step).collect()
}

/// The lines from which these instructions come.
fn lines(source: &Source, steps: &[usize]) -> BTreeSet<usize> {
    let lines = steps.iter().map(|step| source.map.steps[*step].line);
    lines.collect()
}

#[test]
fn each_part_knows_its_instructions() {
    let made = source("chart.st", FILLING).unwrap();
    let chart = &made.charts[0];
    let stands = |id| {
        let steps = of(&made, chart.origin(id));
        lines(&made, &steps).into_iter().collect::<Vec<_>>()
    };
    for (transition, line) in [(0, 7), (1, 8), (2, 9)] {
        assert_eq!(stands(Id::Transition(transition)), [line]);
    }
    // The first scan begins with the initial step; the time of the last is measured.
    assert_eq!(stands(Id::Step(0)), [3]);
    assert_eq!(stands(Id::Step(2)), [6]);
    // A step whose actions do all is nothing of its own.
    assert!(stands(Id::Step(1)).is_empty());
    assert_eq!(stands(Id::Does(1, 0)), [4]);
    assert!(stands(Id::Does(1, 1)).contains(&11));
    assert!(!stands(Id::Does(1, 1)).contains(&4));
    assert_eq!(chart.origin(Id::Does(1, 7)), None);
    // Each instruction is of one part.
    let whole = made.origins[0].iter().filter(|from| from.is_some()).count();
    assert_eq!(whole, made.map.steps.len());
}

/// All parts of a chart.
fn parts(chart: &Document) -> Vec<Id> {
    let steps = chart.steps.iter().enumerate();
    let steps = steps.flat_map(|(step, own)| {
        let does = (0..own.does.len()).map(move |nth| Id::Does(step, nth));
        [Id::Step(step)].into_iter().chain(does)
    });
    let transitions = (0..chart.transitions.len()).map(Id::Transition);
    steps.chain(transitions).collect()
}

#[test]
fn a_project_knows_the_same_as_its_text() {
    let mut compared = 0;
    for seed in 0..rounds(30).into() {
        let text = sketch(seed).text(false);
        let project = unoclp_plcopen::export_text(&text, "chart");
        let both = source("chart.st", &text).zip(source("chart.xml", &project));
        let Some((text, project)) = both else {
            continue;
        };
        if text.program().stored() != project.program().stored() {
            continue;
        }
        let charts = [&text.charts[0], &project.charts[0]];
        assert_eq!(parts(charts[0]), parts(charts[1]));
        for id in parts(charts[0]) {
            let [own, other] = charts.map(|chart| chart.origin(id));
            assert_eq!(of(&text, own), of(&project, other), "seed {seed}, {id}");
            compared += 1;
        }
    }
    assert!(compared > 5, "{compared}");
}
