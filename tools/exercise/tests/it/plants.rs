//! The plants of `programs/plants`: each has model solutions that pass on the core, and each typical mistake breaks the rule
//! that it names.

use std::fs;
use std::path::{Path, PathBuf};
use unoclp_core::Board;
use unoclp_exercise::machine::control;
use unoclp_host_sim::engine::HostEngine;
use unoclp_plant::{Plant, Verdict, read};
use unoclp_program::drawn::{self, WriteAs};
use unoclp_program::{Lang, Written};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/plants")
}

/// The files of a folder that end so, in order.
fn files(folder: &Path, ends: &[&str]) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap();
    let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| {
        file.extension()
            .is_some_and(|end| ends.contains(&end.to_str().unwrap()))
    });
    files.sort();
    files
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap().to_str().unwrap().to_owned()
}

/// Every plant with the stem of its file.
fn plants() -> Vec<(String, Plant)> {
    let read = |path: PathBuf| {
        let name = stem(&path);
        let text = fs::read_to_string(&path).unwrap();
        let plant = read(&text, Board::UNO).unwrap_or_else(|mistakes| {
            let told = mistakes.iter().map(|mistake| mistake.text(&name, Lang::En));
            panic!("{}", told.collect::<Vec<_>>().join("\n"))
        });
        (name, plant)
    };
    files(&folder(), &["toml"]).into_iter().map(read).collect()
}

/// The plant whose name a program's begins with.
fn plant_of<'p>(plants: &'p [(String, Plant)], program: &Path) -> (&'p str, &'p Plant) {
    let stem = stem(program);
    let own = plants.iter().filter(|(name, _)| {
        stem.strip_prefix(name)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with('-'))
    });
    let longest = own
        .max_by_key(|(name, _)| name.len())
        .unwrap_or_else(|| panic!("{program:?}"));
    (&longest.0, &longest.1)
}

fn code(path: &Path, plant: &Plant) -> Vec<u8> {
    let name = path.display().to_string();
    let source = Written::new(name.clone(), fs::read(path).unwrap(), plant.board).check(None);
    let source = source.unwrap_or_else(|refused| panic!("{name}: {refused:?}"));
    if let Some(told) = source.language.warnings() {
        assert_eq!(told.listed, [], "{name}");
    }
    source.code
}

fn run(plant: &Plant, seed: u64, program: &Path) -> Verdict {
    let engine = &mut HostEngine::new(plant.board);
    control(plant, seed, &code(program, plant), engine, |_| ())
        .unwrap_or_else(|ended| panic!("{program:?}: {ended}"))
}

/// The rules that broke and the goals that were missed, in words.
fn told(plant: &Plant, verdict: &Verdict) -> Vec<String> {
    let broken = verdict
        .broken
        .iter()
        .map(|broken| (broken.at, &plant.nevers[broken.rule].text.en));
    let missed = verdict
        .missed
        .iter()
        .map(|missed| (missed.at, &plant.goals[missed.goal].text.en));
    let mut all: Vec<_> = broken.chain(missed).collect();
    all.sort_by_key(|(at, _)| *at);
    all.into_iter()
        .map(|(at, text)| format!("{at} ms: {text}"))
        .collect()
}

/// The kinds of parts that chance moves.
const BY_CHANCE: [&str; 4] = ["feeder", "road", "walk", "lane"];

#[test]
fn each_model_solution_passes_whatever_chance_brings() {
    let plants = plants();
    assert_eq!(plants.len(), 20);
    let mut faults = Vec::new();
    let mut count = 0;
    for program in files(&folder(), &["st", "il", "txt"]) {
        count += 1;
        let (_, plant) = plant_of(&plants, &program);
        // What chance brings is the same for every language, and brings nothing but to these.
        let by_chance = plant
            .parts
            .iter()
            .any(|part| BY_CHANCE.contains(&part.kind.name));
        let others = if by_chance && program.extension().is_some_and(|end| end == "st") {
            3
        } else {
            1
        };
        for seed in [plant.seed, 2, 3].into_iter().take(others) {
            let verdict = run(plant, seed, &program);
            let words = told(plant, &verdict);
            if !words.is_empty() {
                faults.push(format!("{program:?}, seed {seed}: {words:?}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(count >= 60, "{count}");
}

#[test]
fn each_plant_has_a_solution_in_two_languages_and_a_typical_mistake() {
    for (name, _) in plants() {
        for end in [".st", ".il", "-ladder.il"] {
            let file = folder().join(format!("{name}{end}"));
            assert!(file.exists(), "{file:?}");
        }
        let wrong = files(&folder().join("wrong"), &["st"]);
        assert!(
            wrong.iter().any(|file| stem(file).starts_with(&name)),
            "{name}"
        );
    }
}

/// A solution that is drawn is a text as the ladder editor writes it: opened and written again, it is the same. It is drawn
/// with names, and with nothing that is code alone. This test writes them with UPDATE=1.
#[test]
fn each_drawn_solution_is_what_the_ladder_editor_writes() {
    let plants = plants();
    for program in files(&folder(), &["il"]) {
        if !stem(&program).ends_with("-ladder") {
            continue;
        }
        let (name, plant) = plant_of(&plants, &program);
        let text = fs::read(&program).unwrap();
        let written = Written::new(name.to_owned(), text, plant.board).check(None);
        let source = written.unwrap_or_else(|refused| panic!("{program:?}: {refused:?}"));
        let document = drawn::document(&source);
        let again = drawn::text(&document, WriteAs::Il, plant.board).unwrap();
        if std::env::var_os("UPDATE").is_some() {
            fs::write(&program, &again).unwrap();
        }
        assert_eq!(fs::read_to_string(&program).unwrap(), again, "{program:?}");
        assert!(
            again.contains(" AT Q1 : BOOL;") || ["level", "oven"].contains(&name),
            "{again}"
        );
    }
}

/// A wrong program says in its first line what it breaks first: `(* Breaks: Nobody is hit *)`.
#[test]
fn each_typical_mistake_breaks_its_rule() {
    let plants = plants();
    let mut faults = Vec::new();
    for program in files(&folder().join("wrong"), &["st"]) {
        let (_, plant) = plant_of(&plants, &program);
        let text = fs::read_to_string(&program).unwrap();
        let rule = text
            .strip_prefix("(* Breaks: ")
            .unwrap()
            .split_once(" *)")
            .unwrap()
            .0;
        let words = told(plant, &run(plant, plant.seed, &program));
        let first = words.first().and_then(|first| first.split_once(": "));
        if first.is_none_or(|(_, first)| first != rule) {
            faults.push(format!("{program:?}: {rule:?}, came {words:?}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
