//! A chart is edited: what stays as it was written, what goes with what is removed, what is refused.

use crate::drawn::check;
use unoclp_sfc::edit::{Operation, Refusal, Side};
use unoclp_sfc::{Document, Id, Look, Qualifier};
use unoclp_testing::chart::sketch;
use unoclp_testing::{Random, held, rounds};

const FILLING: &str = "\
PROGRAM filling
VAR
  start AT %IX1 : BOOL; // a button
  q AT %QX1 : BOOL;
END_VAR
(* nothing moves *)
INITIAL_STEP Wait: END_STEP
STEP Fill: q(N); (* the valve *) END_STEP
TRANSITION FROM Wait TO Fill := start; END_TRANSITION
// full after two seconds
TRANSITION FROM Fill TO Wait := Fill.T >= T#2s AND NOT start; END_TRANSITION
END_PROGRAM
";

fn document(text: &str) -> Document {
    Document::all(text).remove(0)
}

#[test]
fn each_part_stands_where_it_is_written() {
    let chart = document(FILLING);
    let places = chart.places();
    assert_eq!(
        &FILLING[places.steps[1].clone()],
        "STEP Fill: q(N); (* the valve *) END_STEP"
    );
    assert!(FILLING[places.transitions[1].clone()].starts_with("TRANSITION FROM Fill TO Wait"));
    let after = chart.after(&Operation::Act(Id::Step(0))).unwrap().0;
    let text = after.text();
    let places = after.places();
    assert_eq!(
        &text[places.steps[0].clone()],
        "INITIAL_STEP Wait: A1(N); END_STEP"
    );
    assert!(text[places.actions[0].clone()].starts_with("ACTION A1:"));
}

/// The text after operations.
fn after(text: &str, operations: &[Operation]) -> String {
    let mut document = document(text);
    for operation in operations {
        document = document
            .after(operation)
            .unwrap_or_else(|refusal| panic!("{operation:?}: {refusal:?}"))
            .0;
    }
    document.text()
}

/// The lines of a text that are not in another.
fn new<'t>(text: &'t str, before: &str) -> Vec<&'t str> {
    let old: Vec<&str> = before.lines().collect();
    text.lines().filter(|line| !old.contains(line)).collect()
}

#[test]
fn what_nobody_changes_stays_as_it_was_written() {
    let text = after(
        FILLING,
        &[Operation::Condition(
            Id::Transition(0),
            "start AND Fill.X;".to_owned(),
        )],
    );
    assert_eq!(text, FILLING.replace(":= start;", ":= start AND Fill.X;"));
    let comments: Vec<String> = document(FILLING)
        .steps
        .iter()
        .map(|step| step.comment.clone())
        .collect();
    assert_eq!(comments, ["nothing moves", ""]);
}

#[test]
fn steps_come_with_transitions() {
    let text = after(FILLING, &[Operation::StepAfter(Id::Step(0))]);
    assert_eq!(
        new(&text, FILLING),
        [
            "STEP S1: END_STEP",
            "TRANSITION FROM Wait TO S1 := TRUE; END_TRANSITION",
            "TRANSITION FROM S1 TO Fill := start; END_TRANSITION"
        ]
    );
    let text = after(FILLING, &[Operation::StepAfter(Id::Transition(1))]);
    assert_eq!(
        new(&text, FILLING),
        [
            "STEP S1: END_STEP",
            "TRANSITION FROM Fill TO S1 := Fill.T >= T#2s AND NOT start; END_TRANSITION",
            "TRANSITION FROM S1 TO Wait := TRUE; END_TRANSITION",
        ]
    );
    let text = after(FILLING, &[Operation::StepBefore(Id::Step(0))]);
    assert_eq!(
        new(&text, FILLING),
        [
            "STEP Wait: END_STEP",
            "INITIAL_STEP S1: END_STEP",
            "TRANSITION FROM S1 TO Wait := TRUE; END_TRANSITION",
            "TRANSITION FROM Fill TO S1 := Fill.T >= T#2s AND NOT start; END_TRANSITION",
        ]
    );
}

#[test]
fn branches_part_and_meet() {
    let text = after(FILLING, &[Operation::Branch(Id::Transition(0))]);
    assert_eq!(
        new(&text, FILLING),
        [
            "STEP S1: END_STEP",
            "TRANSITION FROM Wait TO S1 := TRUE; END_TRANSITION",
            "TRANSITION FROM S1 TO Wait := TRUE; END_TRANSITION",
        ]
    );
    let text = after(FILLING, &[Operation::Beside(Id::Step(1))]);
    assert_eq!(
        new(&text, FILLING),
        [
            "STEP S1: END_STEP",
            "TRANSITION FROM Wait TO (Fill, S1) := start; END_TRANSITION",
            "TRANSITION FROM (Fill, S1) TO Wait := Fill.T >= T#2s AND NOT start; END_TRANSITION",
        ]
    );
    // And back: what was added is removed.
    let back = after(&text, &[Operation::Remove(Id::Step(2))]);
    assert_eq!(new(&back, FILLING), [""; 0]);
    let text = after(
        FILLING,
        &[
            Operation::Jump(Id::Step(1), "fill".to_owned()),
            Operation::Move(Id::Transition(2), Side::Left),
        ],
    );
    let lines: Vec<&str> = text
        .lines()
        .filter(|line| line.starts_with("TRANSITION FROM Fill"))
        .collect();
    assert_eq!(
        lines[0],
        "TRANSITION FROM Fill TO Fill := TRUE; END_TRANSITION"
    );
}

#[test]
fn names_change_wherever_they_stand() {
    let text = after(
        FILLING,
        &[Operation::Rename(Id::Step(1), "Pour".to_owned())],
    );
    assert_eq!(
        new(&text, FILLING),
        [
            "STEP Pour: q(N); END_STEP",
            "TRANSITION FROM Wait TO Pour := start; END_TRANSITION",
            "TRANSITION FROM Pour TO Wait := Pour.T >= T#2s AND NOT start; END_TRANSITION",
        ]
    );
}

#[test]
fn actions_are_added_named_and_written() {
    let id = Id::Does(0, 0);
    let text = after(FILLING, &[Operation::Act(Id::Step(0))]);
    assert_eq!(
        new(&text, FILLING),
        [
            "INITIAL_STEP Wait: A1(N); END_STEP",
            "ACTION A1:  END_ACTION"
        ]
    );
    let variable = Operation::Does(id, "q".to_owned(), Qualifier::L, Some("T#1s".to_owned()));
    let text = after(FILLING, &[Operation::Act(Id::Step(0)), variable]);
    assert_eq!(
        new(&text, FILLING),
        ["INITIAL_STEP Wait: q(L, T#1s); END_STEP"]
    );
    let text = after(
        FILLING,
        &[
            Operation::Act(Id::Step(0)),
            Operation::Rename(id, "Count".to_owned()),
            Operation::Body("Count".to_owned(), "n := n + 1;\nm := n;".to_owned()),
        ],
    );
    assert_eq!(
        new(&text, FILLING),
        [
            "INITIAL_STEP Wait: Count(N); END_STEP",
            "ACTION Count:",
            "  n := n + 1;",
            "  m := n;",
            "END_ACTION"
        ]
    );
}

#[test]
fn what_is_removed_takes_with_it_what_only_it_leads_to() {
    let branch = after(
        FILLING,
        &[
            Operation::Branch(Id::Transition(0)),
            Operation::StepAfter(Id::Step(2)),
        ],
    );
    let document = document(&branch);
    let to = document
        .transitions
        .iter()
        .position(|of| of.to == ["S1"])
        .unwrap();
    let back = after(&branch, &[Operation::Remove(Id::Transition(to))]);
    assert_eq!(new(&back, FILLING), [""; 0]);
    let one = after(FILLING, &[Operation::Remove(Id::Step(1))]);
    assert_eq!(
        new(&one, FILLING),
        ["TRANSITION FROM Wait TO Wait := start; END_TRANSITION"]
    );
}

#[test]
fn refusals_leave_a_document_as_it_is() {
    let document = document(FILLING);
    let named = |name: &str| Operation::Rename(Id::Step(0), name.to_owned());
    let does = |qualifier, time: Option<&str>| {
        Operation::Does(
            Id::Does(1, 0),
            "q".to_owned(),
            qualifier,
            time.map(str::to_owned),
        )
    };
    for (operation, refusal) in [
        (Operation::StepAfter(Id::Step(9)), Refusal::NotThere),
        (Operation::Remove(Id::Does(1, 7)), Refusal::NotThere),
        (Operation::Beside(Id::Step(0)), Refusal::SelectStep),
        (
            Operation::Condition(Id::Step(0), "a".to_owned()),
            Refusal::SelectTransition,
        ),
        (named("IF"), Refusal::NoName),
        (named("fill"), Refusal::NameTaken),
        (
            Operation::Condition(Id::Transition(0), " ; ".to_owned()),
            Refusal::Missing,
        ),
        (does(Qualifier::D, None), Refusal::Missing),
        (
            Operation::Move(Id::Transition(0), Side::Left),
            Refusal::NoFurther,
        ),
        (
            Operation::Condition(
                Id::Transition(0),
                "a END_TRANSITION STEP X: END_STEP".to_owned(),
            ),
            Refusal::NotOnePart,
        ),
        (
            Operation::Body("x".to_owned(), "END_ACTION ACTION y:".to_owned()),
            Refusal::NotOnePart,
        ),
        (does(Qualifier::L, Some("T#1s); z(N")), Refusal::NotOnePart),
    ] {
        assert_eq!(
            document.after(&operation).err(),
            Some(refusal),
            "{operation:?}"
        );
    }
    let one = after(FILLING, &[Operation::Remove(Id::Step(1))]);
    let one = self::document(&one);
    assert_eq!(
        one.after(&Operation::Remove(Id::Step(0))).err(),
        Some(Refusal::LastStep)
    );
}

/// Whatever is done to whatever chart, it stays one that is read and drawn.
#[test]
fn random_operations_leave_charts() {
    let edit = |seed: u64| {
        let random = &mut Random(seed);
        let mut chart = document(&sketch(seed).text(false));
        for _ in 0..40 {
            let operation = operation(&chart, random);
            if let Ok((after, id)) = chart.after(&operation) {
                let text = after.text();
                let read = check(&text, Look::Norm);
                assert_eq!(read.text(), text);
                let fine = match id {
                    Id::Step(step) => step < read.steps.len(),
                    Id::Does(step, nth) => nth < read.steps[step].does.len(),
                    Id::Transition(of) | Id::Jump(of, _) | Id::Wait(of, _) => {
                        of < read.transitions.len()
                    }
                };
                assert!(fine, "{operation:?} selects {id}");
                chart = read;
            }
        }
    };
    (0..u64::from(rounds(60))).for_each(|seed| held(|| edit(seed)));
}

fn operation(chart: &Document, random: &mut Random) -> Operation {
    let step = random.below(chart.steps.len() + 1);
    let transition = random.below(chart.transitions.len() + 1);
    let id = match random.below(5) {
        0 | 1 => Id::Step(step),
        2 => Id::Does(step, random.below(2)),
        3 => Id::Jump(transition, 0),
        _ => Id::Transition(transition),
    };
    let name = format!("s{step}");
    match random.below(14) {
        0 => Operation::StepAfter(id),
        1 => Operation::StepBefore(id),
        2 => Operation::Branch(id),
        3 => Operation::Beside(id),
        4 => Operation::Jump(id, name),
        5 => Operation::Act(id),
        6 | 7 => Operation::Remove(id),
        8 => Operation::Move(id, Side::Right),
        9 => Operation::Rename(id, format!("n{transition}")),
        10 => Operation::Lead(id, name),
        11 => Operation::Priority(id, Some(1)),
        12 => Operation::Does(id, "v0".to_owned(), Qualifier::D, Some("T#1s".to_owned())),
        _ => Operation::Initial(id),
    }
}
