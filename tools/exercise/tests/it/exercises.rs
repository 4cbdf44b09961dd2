//! The exercises of `programs/exercises`: each says what to do in both languages, its model solution passes, and a typical
//! wrong one is caught by the case that names the mistake.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use unoclp_core::Board;
use unoclp_exercise::scenario::{Both, Exercise, ProgramFile, grade};
use unoclp_host_sim::engine::HostEngine;
use unoclp_program::{Lang, Written};

/// The files of a folder below `programs` that end so, in order.
pub(crate) fn files(folder: &str, ends: &[&str]) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../programs")
        .join(folder);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{folder:?}: {error}"));
    let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| ends.contains(&file.extension().unwrap_or_default().to_str().unwrap()));
    files.sort();
    files
}

/// All exercises that cases judge, with the stems of their files: those of the list, and those that give a program to be
/// written again.
pub(crate) fn exercises() -> Vec<(String, Exercise)> {
    of_folders(&["exercises", "exercises/write"])
}

/// The exercises of these folders.
pub(crate) fn of_folders(folders: &[&str]) -> Vec<(String, Exercise)> {
    let load = |path: PathBuf| {
        let exercise = Exercise::load(&path, Board::UNO).unwrap_or_else(|error| panic!("{error}"));
        (stem(&path), exercise)
    };
    let all = folders.iter().flat_map(|folder| files(folder, &["toml"]));
    all.map(load).collect()
}

pub(crate) fn stem(path: &Path) -> String {
    path.file_stem().unwrap().to_str().unwrap().to_owned()
}

/// The program of a text about which its compiler has nothing to say, for this board.
pub(crate) fn program(path: &Path, board: Board) -> ProgramFile {
    let name = path.display().to_string();
    let source = Written::new(name.clone(), fs::read(path).unwrap(), board).check(None);
    let source = source.unwrap_or_else(|refused| panic!("{name}: {refused:?}"));
    if let Some(told) = source.language.warnings() {
        assert_eq!(told.listed, [], "{name}");
    }
    ProgramFile {
        name,
        bytes: source.code,
    }
}

#[test]
fn each_exercise_says_what_to_do_in_both_languages() {
    let all = exercises();
    assert_eq!(all.len(), 55);
    for (name, exercise) in all {
        let titles = exercise.cases().iter().map(|case| &case.title);
        let task = exercise.task.iter();
        let texts = task.chain(&exercise.hints).chain([&exercise.title]);
        for text in texts.chain(titles) {
            let Both { en, pt } = text;
            assert!(!en.is_empty() && !pt.is_empty() && en != pt, "{name}: {en}");
        }
        assert!(
            exercise.task.is_some() && !exercise.hints.is_empty(),
            "{name}"
        );
        let hidden = exercise.cases().iter().filter(|case| case.hidden).count();
        assert!(hidden > 0 && hidden < exercise.cases().len(), "{name}");
        let titles: BTreeSet<_> = exercise.cases().iter().map(|case| &case.title.en).collect();
        assert_eq!(
            titles.len(),
            exercise.cases().len(),
            "{name}: a title twice"
        );
    }
}

/// What is pressed and expected is named, and nothing else.
#[test]
fn each_point_of_an_exercise_has_a_name() {
    for (name, exercise) in exercises() {
        let model = program(exercise.program.as_deref().unwrap(), exercise.board);
        let mut used = BTreeSet::new();
        for scenario in exercise.scenarios(&model) {
            let plan = scenario.plan();
            let report =
                unoclp_exercise::scenario::check(&scenario, &mut HostEngine::new(exercise.board));
            used.extend(
                plan.inputs
                    .iter()
                    .map(|point| format!("I{}", point.number())),
            );
            used.extend(
                report
                    .columns
                    .analogue
                    .iter()
                    .map(|input| format!("A{input}")),
            );
            used.extend(plan.expected.keys().map(ToString::to_string));
        }
        let named: BTreeSet<_> = exercise.names.keys().cloned().collect();
        assert_eq!(used, named, "{name}");
    }
}

#[test]
fn each_model_solution_passes() {
    for (name, exercise) in exercises() {
        let file = exercise.program.as_deref().unwrap();
        assert_eq!(stem(file), name);
        let grade = grade(
            &exercise,
            &program(file, exercise.board),
            &mut HostEngine::new(exercise.board),
        );
        if let Some(failing) = grade.failing {
            panic!("{name}: {}", failing.report);
        }
    }
}

/// The wrong solutions of an exercise.
pub(crate) fn wrong(name: &str) -> Vec<PathBuf> {
    let folders = ["exercises/wrong", "exercises/write/wrong"];
    let all = folders
        .iter()
        .flat_map(|folder| files(folder, &["il", "st"]));
    all.filter(|file| stem(file).starts_with(name)).collect()
}

/// What a wrong solution says in its first line: `(* Caught by: Stop wins *)` names a case, `(* Breaks: … *)` a rule or a
/// goal of the machine.
pub(crate) fn says(file: &Path, key: &str) -> Option<String> {
    let text = fs::read_to_string(file).unwrap();
    let rest = text.strip_prefix(&format!("(* {key}: "))?;
    Some(rest.split_once(" *)").unwrap().0.to_owned())
}

#[test]
fn each_typical_mistake_is_caught_by_its_case() {
    for (name, exercise) in exercises() {
        let own = wrong(&name);
        for file in &own {
            let grade = grade(
                &exercise,
                &program(file, exercise.board),
                &mut HostEngine::new(exercise.board),
            );
            let Some(by) = says(file, "Caught by") else {
                assert!(grade.is_passed(), "{file:?}: a case catches it already");
                continue;
            };
            let failing = grade.failing.unwrap_or_else(|| panic!("{file:?} passes"));
            let title = exercise.cases()[failing.case].title.text(Lang::En);
            assert_eq!(title, by, "{}", failing.report);
        }
        assert!(!own.is_empty(), "{name} has no wrong solution");
    }
}
