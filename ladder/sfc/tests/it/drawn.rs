//! Each chart is drawn: every step and transition once, and nothing over another.

use std::collections::{BTreeMap, HashSet};
use std::fs;
use std::path::Path;
use unoclp_sfc::{Document, Id, Look, Sheet, picture, svg};
use unoclp_testing::chart::sketch;

/// The texts of `programs/charts`, by their names.
pub(crate) fn programs() -> BTreeMap<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/charts");
    let files = fs::read_dir(folder)
        .unwrap()
        .map(|file| file.unwrap().path());
    let charts = files.filter(|path| path.extension().is_some_and(|end| end == "st"));
    let name = |path: &Path| path.file_stem().unwrap().to_string_lossy().into_owned();
    charts
        .map(|path| (name(&path), fs::read_to_string(&path).unwrap()))
        .collect()
}

/// Tells what is missing on a sheet, twice on it, or in the way of something else.
pub(crate) fn check(text: &str, look: Look) -> Document {
    let mut charts = Document::all(text);
    assert_eq!(charts.len(), 1, "{text}");
    let document = charts.remove(0);
    assert_eq!(document.text(), text);
    let sheet = Sheet::drawn(&document, look);
    let mut seen = HashSet::new();
    let mut cells = HashSet::new();
    for item in &sheet.items {
        assert!(seen.insert(item.id), "{} stands twice in\n{text}", item.id);
        let area = item.area;
        assert!(area.x + area.columns <= sheet.columns + 2, "{text}");
        assert!(area.y + area.rows <= sheet.rows, "{text}");
        // The rows of a table of actions share their edges.
        let rows = match item.id {
            Id::Does(..) => area.y + 1..area.y + 2,
            _ => area.y..area.y + area.rows,
        };
        for cell in rows.flat_map(|y| (area.x..area.x + area.columns).map(move |x| (x, y))) {
            let look = || picture(&document, &sheet, None);
            assert!(
                cells.insert(cell),
                "{} stands on another:\n{}",
                item.id,
                look()
            );
        }
    }
    for step in 0..document.steps.len() {
        assert!(
            seen.contains(&Id::Step(step)),
            "step {step} is missing:\n{text}"
        );
    }
    for transition in 0..document.transitions.len() {
        assert!(
            seen.contains(&Id::Transition(transition)),
            "{transition} is missing:\n{text}"
        );
    }
    let written = svg(&document, &sheet, None, "t", false);
    assert_eq!(
        written.matches("class=\"transition\"").count(),
        document.transitions.len()
    );
    document
}

#[test]
fn the_charts_of_courses_are_drawn() {
    for (name, text) in programs() {
        let document = check(&text, Look::Norm);
        check(&text, Look::Grafcet);
        let sheet = Sheet::drawn(&document, Look::Norm);
        println!("{name}\n{}", picture(&document, &sheet, None));
    }
}

#[test]
fn random_charts_are_drawn() {
    for seed in 0..unoclp_testing::rounds(500) {
        check(&sketch(u64::from(seed)).text(seed % 5 == 0), Look::Norm);
    }
}

/// A chart of any size is drawn in a time that grows with it; so is one whose branches stand in each other.
#[test]
fn large_and_deep_charts_are_drawn() {
    let row = |steps: usize| {
        let step = |step: usize| {
            let word = if step == 0 { "INITIAL_STEP" } else { "STEP" };
            let to = (step + 1) % steps;
            format!(
                "{word} S{step}: y(N); END_STEP\nTRANSITION FROM S{step} TO S{to} := a; END_TRANSITION\n"
            )
        };
        (0..steps).map(step).collect::<String>()
    };
    let deep = |steps: usize| {
        let step = |step: usize| {
            format!(
                "STEP S{step}: END_STEP STEP E{step}: END_STEP\nTRANSITION FROM S{step} TO (S{}, E{step}) := a; END_TRANSITION\n",
                step + 1
            )
        };
        let all: String = (0..steps).map(step).collect();
        format!(
            "INITIAL_STEP I: END_STEP STEP S{steps}: END_STEP\nTRANSITION FROM I TO S0 := a; END_TRANSITION\n{all}"
        )
    };
    check(&row(5_000), Look::Norm);
    check(&deep(1_000), Look::Norm);
    let wide: String = (0..2_000)
        .map(|way| format!("STEP W{way}: END_STEP\nTRANSITION FROM I TO W{way} := a; END_TRANSITION\nTRANSITION FROM W{way} TO I := b; END_TRANSITION\n"))
        .collect();
    check(&format!("INITIAL_STEP I: END_STEP\n{wide}"), Look::Norm);
}
