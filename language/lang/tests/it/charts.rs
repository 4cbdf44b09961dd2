//! What charts take of a UNO.

use std::fs;
use std::path::Path;
use unoclp_core::Board;
use unoclp_lang::{TextLanguage, compile_text};

/// How many bytes the board stores of a program in `programs/charts`.
fn stored(name: &str) -> usize {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/charts");
    let text = fs::read_to_string(folder.join(format!("{name}.st"))).unwrap();
    stored_of(&text)
}

fn stored_of(text: &str) -> usize {
    let made = compile_text(text, TextLanguage::St, Board::UNO);
    assert_eq!(made.diagnostics.listed, [], "{text}");
    made.program.unwrap().0.program().stored_bytes()
}

/// A chart of so many steps in a row, each with a contact and an output.
fn row(steps: usize) -> String {
    let step = |step: usize| {
        let word = if step == 0 { "INITIAL_STEP" } else { "STEP" };
        let to = (step + 1) % steps;
        let (input, output) = (step % 8 + 1, step % 4 + 1);
        format!(
            "{word} S{step}: %QX{output}(N); END_STEP\n\
             TRANSITION FROM S{step} TO S{to} := %IX{input}; END_TRANSITION\n"
        )
    };
    (0..steps).map(step).collect()
}

#[test]
fn charts_of_courses_leave_half_of_the_board() {
    let names = [
        "filling",
        "cylinders",
        "traffic",
        "mixer",
        "gate",
        "washer",
        "lift",
        "table",
        "stardelta",
        "sorter",
    ];
    let sizes = names.map(|name| (name, stored(name)));
    println!("{sizes:?}");
    let large: Vec<_> = sizes.iter().filter(|(_, bytes)| *bytes > 450).collect();
    assert!(large.is_empty(), "{large:?}");
}

#[test]
fn a_step_with_a_contact_and_an_action_takes_twelve_bytes() {
    let per_step = stored_of(&row(20)) - stored_of(&row(10));
    assert!(per_step <= 10 * 14, "{per_step}");
    let many = stored("many");
    println!("28 steps: {many}");
    assert!(many <= 450, "{many}");
}

/// Any number of steps is read in a time that grows with it, and told to be too many.
#[test]
fn a_hundred_thousand_steps_are_read() {
    for steps in [1_000, 50_000, 100_000] {
        let made = compile_text(&row(steps), TextLanguage::St, Board::UNO);
        assert!(made.program.is_none(), "{steps}");
        assert!(!made.diagnostics.listed.is_empty(), "{steps}");
    }
}

/// Twenty sequences at once come to a million situations.
#[test]
fn too_many_situations_are_not_searched() {
    let all: Vec<usize> = (0..20).collect();
    let list = |letter: &str| {
        let names: Vec<String> = all
            .iter()
            .map(|number| format!("{letter}{number}"))
            .collect();
        names.join(", ")
    };
    let step = |number: &usize| {
        format!(
            "STEP a{number}: END_STEP STEP b{number}: END_STEP\n\
             TRANSITION FROM a{number} TO b{number} := %IX1; END_TRANSITION\n"
        )
    };
    let steps: String = all.iter().map(step).collect();
    let text = format!(
        "INITIAL_STEP S: %QX1(N); END_STEP\n{steps}TRANSITION FROM S TO ({}) := %IX2; END_TRANSITION\n\
         TRANSITION FROM ({}) TO S := %IX3; END_TRANSITION\n",
        list("a"),
        list("b")
    );
    let made = compile_text(&text, TextLanguage::St, Board::UNO);
    let told: Vec<String> = made
        .diagnostics
        .iter()
        .map(|d| d.code.to_string())
        .collect();
    assert_eq!(told, ["ST-255"]);
    assert!(made.program.is_some());
}
