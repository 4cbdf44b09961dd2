//! The tutorial says what the tools say: its programs are those that the scenarios run, the same in both
//! languages, and its listings and ladders are the real ones.

use crate::common::outcome_in;
use std::fs;
use std::path::{Path, PathBuf};
use unoclp_host_sim::engine::HostEngine;
use unoclp_host_sim::scenario::{Scenario, check};
use unoclp_lang::{Options, compile};

const PAGES: [&str; 2] = ["docs/tutorial.md", "docs/tutorial.pt-BR.md"];
const FOLDER: &str = "programs/tutorial";

fn path(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

fn read(name: &str) -> String {
    fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// A block of a page between fences: what stands behind the opening fence, and the lines.
#[derive(Debug, PartialEq)]
struct Block {
    kind: String,
    text: String,
}

fn blocks(text: &str) -> Vec<Block> {
    let fenced = text.split("\n```").skip(1).step_by(2);
    fenced
        .map(|block| {
            let (kind, text) = block.split_once('\n').unwrap();
            Block {
                kind: kind.to_owned(),
                text: format!("{text}\n"),
            }
        })
        .collect()
}

/// The steps of a page: each program's name and its part of the page.
fn steps(page: &str) -> Vec<(String, String)> {
    let link = format!("](../{FOLDER}/");
    let text = read(page);
    let sections = text.split("\n## ").skip(1);
    sections
        .filter_map(|section| {
            let (name, _) = section.split_once(&link)?.1.split_once(".il)")?;
            // The solutions stand in a folder of their own.
            (!name.contains('/')).then(|| (name.to_owned(), section.to_owned()))
        })
        .collect()
}

/// The program file that the compiler makes of a text in which it finds nothing to say.
fn compiled(text: &str) -> String {
    let compiled = compile(text, &Options::default());
    let diagnostics = &compiled.diagnostics;
    assert!(diagnostics.is_empty(), "{diagnostics:#?}\n{text}");
    compiled.file().unwrap()
}

/// What `unoclp list` draws of a program in the language of a page, without the title above it.
fn ladder(name: &str, page: &str) -> String {
    let (lang, rung) = match page.contains("pt-BR") {
        true => ("pt_BR.UTF-8", "Degrau 1"),
        false => ("C.UTF-8", "Rung 1"),
    };
    let file = path(&format!("{FOLDER}/{name}.il"));
    let (code, listing, told) =
        outcome_in(&["list", file.to_str().unwrap(), "--as", "ladder"], lang);
    assert_eq!((code, told.as_str()), (0, ""), "{name}");
    let rungs = listing.find(rung).unwrap();
    listing[rungs..].to_owned()
}

/// What a block of this kind must hold in the step of this program on a page.
fn expected(kind: &str, name: &str, page: &str) -> String {
    let text = read(&format!("{FOLDER}/{name}.il"));
    match kind {
        "il" => text,
        "numeric" => compiled(&text),
        "ladder" => ladder(name, page),
        _ => panic!("{name}: a block of {kind}"),
    }
}

#[test]
fn each_step_shows_its_program_and_what_becomes_of_it() {
    for page in PAGES {
        for (name, section) in steps(page) {
            let mut shown = Vec::new();
            for Block { kind, text } in blocks(&section) {
                let is_first = !shown.contains(&kind);
                shown.push(kind.clone());
                // A timing chart has no kind; a further text is an example beside the program.
                if is_first && !kind.is_empty() {
                    let expected = expected(&kind, &name, page);
                    assert_eq!(text, expected, "{page}: {name} as {kind}:\n{expected}");
                }
            }
            for kind in ["il", "ladder"] {
                assert!(
                    shown.iter().any(|shown| shown == kind),
                    "{page}: {name} as {kind}"
                );
            }
        }
    }
}

/// The examples beside the programs and the solutions of the exercises too.
#[test]
fn every_text_compiles_without_a_warning() {
    for page in PAGES {
        let blocks = blocks(&read(page));
        let texts: Vec<_> = blocks.iter().filter(|block| block.kind == "il").collect();
        assert!(texts.len() > 20, "{page}: {}", texts.len());
        for Block { text, .. } in texts {
            compiled(text);
        }
    }
}

#[test]
fn both_languages_show_the_same() {
    let [english, portuguese] = PAGES.map(|page| {
        let all = blocks(&read(page));
        // The words in a timing chart are those of its language, and so are those above a rung.
        let is_heading = |line: &&str| line.starts_with("Rung ") || line.starts_with("Degrau ");
        let same = |Block { kind, text }| {
            let lines: Vec<String> = text
                .lines()
                .filter(|line| !is_heading(line))
                .map(str::to_owned)
                .collect();
            (kind, lines)
        };
        let shown = all.into_iter().filter(|block| !block.kind.is_empty());
        shown.map(same).collect::<Vec<_>>()
    });
    assert_eq!(english, portuguese);
}

/// The names of the programs in a folder, in order. Each is kept as numeric code too, and does what
/// its scenario says.
fn programs(folder: &str) -> Vec<String> {
    let entries = fs::read_dir(path(folder)).unwrap();
    let mut names: Vec<_> = entries
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|end| end == "il"))
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    names.sort();
    for name in &names {
        let file = compiled(&read(&format!("{folder}/{name}.il")));
        let kept = read(&format!("{folder}/{name}.txt"));
        assert_eq!(
            kept, file,
            "{name}.txt is not what the compiler makes of {name}.il"
        );
        let scenario = path(&format!("{folder}/{name}.toml"));
        let scenario = Scenario::load(&scenario).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(scenario.program().bytes, file.as_bytes(), "{name}");
        let report = check(&scenario, &mut HostEngine::default());
        assert!(report.passed(), "{report}");
    }
    names
}

#[test]
fn every_program_is_a_step() {
    let programs = programs(FOLDER);
    for page in PAGES {
        let names: Vec<_> = steps(page).into_iter().map(|(name, _)| name).collect();
        assert_eq!(names, programs, "{page}");
    }
}

/// Each step has a solution, a program that ends as the page shows.
#[test]
fn every_exercise_is_solved() {
    let folder = format!("{FOLDER}/solutions");
    let solutions = programs(&folder);
    for page in PAGES {
        let text = read(page);
        let link = format!("](../{folder}/");
        let links = text.split(&link).skip(1);
        let shown: Vec<_> = links.map(|rest| rest.split_once(".il)").unwrap()).collect();
        let names: Vec<_> = shown.iter().map(|(name, _)| *name).collect();
        assert_eq!(names, solutions, "{page}");
        assert_eq!(names.len(), steps(page).len(), "{page}");
        for (name, rest) in shown {
            let program = read(&format!("{folder}/{name}.il"));
            let block = blocks(rest).into_iter().next().unwrap();
            assert!(program.ends_with(&block.text), "{page}: {name}");
        }
    }
}
