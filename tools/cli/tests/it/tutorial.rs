//! The tutorial says what the tools say: its programs are those that the scenarios run, the same in both
//! languages, and its listings and ladders are the real ones.

use crate::common::outcome_in;
use std::fs;
use std::path::{Path, PathBuf};
use unoclp_exercise::scenario::{Exercise, Scenario, check};
use unoclp_host_sim::engine::HostEngine;
use unoclp_lang::{Lang, TextLanguage, compile_text};

const PAGES: [&str; 2] = ["docs/tutorial.md", "docs/tutorial.pt-BR.md"];
const FOLDER: &str = "programs/tutorial";

fn path(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(path)
}

fn read(name: &str) -> String {
    fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// A block of a page between fences: what follows the opening fence, and the lines.
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

/// The languages of the steps, as their files end and as the pages name their blocks.
const LANGUAGES: [&str; 2] = ["il", "st"];

/// What stands before the end of a link to a program, the end of its name, and what follows the link.
fn linked(rest: &str) -> Option<(&str, &str, &str)> {
    let (link, behind) = rest.split_once(')')?;
    let (name, end) = link.rsplit_once('.')?;
    LANGUAGES.contains(&end).then_some((name, end, behind))
}

/// The steps of a page: each program's file and its part of the page.
fn steps(page: &str) -> Vec<(String, String)> {
    let link = format!("](../{FOLDER}/");
    let text = read(page);
    let sections = text.split("\n## ").skip(1);
    sections
        .filter_map(|section| {
            let (name, end, _) = linked(section.split_once(&link)?.1)?;
            // The solutions stand in a folder of their own.
            (!name.contains('/')).then(|| (format!("{name}.{end}"), section.to_owned()))
        })
        .collect()
}

/// The language of a file.
fn language(file: &str) -> &str {
    file.rsplit_once('.').unwrap().1
}

/// The program file that the compiler makes of a text in which it finds nothing to say.
fn compiled(text: &str, language: &str) -> String {
    let (file, diagnostics) = match language {
        "il" => {
            let compiled = compile_text(text, TextLanguage::Il, unoclp_core::Board::UNO);
            (compiled.file(), compiled.diagnostics.listed)
        }
        _ => {
            let compiled = compile_text(text, TextLanguage::St, unoclp_core::Board::UNO);
            (compiled.file(), compiled.diagnostics.listed)
        }
    };
    assert!(diagnostics.is_empty(), "{diagnostics:#?}\n{text}");
    file.unwrap()
}

/// What `unoclp` with these arguments prints in the language of a page, from this word in either language on.
fn printed(arguments: &[&str], page: &str, from: [&str; 2]) -> String {
    let (lang, from) = match page.contains("pt-BR") {
        true => ("pt_BR.UTF-8", from[1]),
        false => ("C.UTF-8", from[0]),
    };
    let (code, printed, told) = outcome_in(arguments, lang);
    assert_eq!((code, told.as_str()), (0, ""), "{arguments:?}");
    let begin = printed.find(from).unwrap();
    printed[begin..].to_owned()
}

/// What `unoclp list` draws of a program in the language of a page, without the title above it.
fn ladder(file: &str, page: &str) -> String {
    let file = path(&format!("{FOLDER}/{file}"));
    let arguments = ["list", file.to_str().unwrap(), "--as", "ladder"];
    printed(&arguments, page, ["Rung 1", "Degrau 1"])
}

/// A command line `unoclp run FILE …`, and what it prints.
fn run(text: &str, page: &str) -> String {
    let command = text.lines().next().unwrap();
    let words: Vec<&str> = command.split(' ').collect();
    let ["unoclp", "run", file, options @ ..] = &words[..] else {
        panic!("{page}: {command}");
    };
    let file = path(file);
    let arguments = [&["run", file.to_str().unwrap()], options].concat();
    let table = printed(&arguments, page, ["name", "nome"]);
    format!("{command}\n{table}")
}

/// What this block of a page must hold in the step of this program.
fn expected(block: &Block, file: &str, page: &str) -> String {
    let text = read(&format!("{FOLDER}/{file}"));
    match block.kind.as_str() {
        kind if kind == language(file) => text,
        "numeric" => compiled(&text, language(file)),
        "ladder" => ladder(file, page),
        "run" => run(&block.text, page),
        kind => panic!("{file}: a block of {kind}"),
    }
}

#[test]
fn each_step_shows_its_program_and_what_becomes_of_it() {
    for page in PAGES {
        for (file, section) in steps(page) {
            let mut shown = Vec::new();
            for block in blocks(&section) {
                let Block { kind, text } = &block;
                let is_first = !shown.contains(kind);
                shown.push(kind.clone());
                // A timing chart has no kind; a further text is an example beside the program.
                if is_first && !kind.is_empty() {
                    let expected = expected(&block, &file, page);
                    assert_eq!(*text, expected, "{page}: {file} as {kind}:\n{expected}");
                }
            }
            // A ladder diagram of numbers and loops would teach nothing: there the values do.
            let due = match language(&file) {
                "il" => &["il", "ladder"][..],
                _ => &["st"],
            };
            for kind in due {
                assert!(
                    shown.iter().any(|shown| shown == kind),
                    "{page}: {file} as {kind}"
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
        let is_text = |block: &&Block| LANGUAGES.contains(&block.kind.as_str());
        let texts: Vec<_> = blocks.iter().filter(is_text).collect();
        assert!(texts.len() > 26, "{page}: {}", texts.len());
        for Block { kind, text } in texts {
            compiled(text, kind);
        }
    }
}

#[test]
fn both_languages_show_the_same() {
    let [english, portuguese] = PAGES.map(|page| {
        let all = blocks(&read(page));
        // The words in a timing chart are those of its language, and so are those above a rung or a table.
        let headings = ["Rung ", "Degrau ", "name ", "nome "];
        let is_heading = |line: &&str| headings.iter().any(|heading| line.starts_with(heading));
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

/// The files of the programs in a folder, in order. Each is kept as numeric code too, and does what
/// its scenario says.
fn programs(folder: &str) -> Vec<String> {
    let entries = fs::read_dir(path(folder)).unwrap();
    let files = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut files: Vec<_> = files
        .filter(|file| file.contains('.') && LANGUAGES.contains(&language(file)))
        .collect();
    files.sort();
    for program in &files {
        let (name, _) = program.rsplit_once('.').unwrap();
        let file = compiled(&read(&format!("{folder}/{program}")), language(program));
        let kept = read(&format!("{folder}/{name}.txt"));
        assert_eq!(
            kept, file,
            "{name}.txt is not what the compiler makes of {program}"
        );
        let scenario = path(&format!("{folder}/{name}.toml"));
        let scenario = Scenario::load(&scenario, unoclp_core::Board::UNO)
            .unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(scenario.program().bytes, file.as_bytes(), "{name}");
        let report = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO));
        assert!(report.passed(), "{report}");
    }
    files
}

#[test]
fn every_program_is_a_step() {
    let programs = programs(FOLDER);
    for page in PAGES {
        let files: Vec<_> = steps(page).into_iter().map(|(file, _)| file).collect();
        assert_eq!(files, programs, "{page}");
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
        let shown: Vec<_> = links.map(|rest| linked(rest).unwrap()).collect();
        let file = |(name, end, _): &(&str, &str, &str)| format!("{name}.{end}");
        let files: Vec<_> = shown.iter().map(file).collect();
        assert_eq!(files, solutions, "{page}");
        assert_eq!(files.len(), steps(page).len(), "{page}");
        for (file, (_, _, rest)) in files.iter().zip(shown) {
            let program = read(&format!("{folder}/{file}"));
            let block = blocks(rest).into_iter().next().unwrap();
            assert!(program.ends_with(&block.text), "{page}: {file}");
        }
    }
}

/// Title and task of an exercise stand in its file and on the pages, in the same words.
#[test]
fn every_exercise_asks_what_the_pages_ask() {
    let solutions = programs(&format!("{FOLDER}/solutions"));
    for (page, lang, mark) in [
        (PAGES[0], Lang::En, "**Exercise**: "),
        (PAGES[1], Lang::Pt, "**Exercício**: "),
    ] {
        for ((_, section), solution) in steps(page).iter().zip(&solutions) {
            let file = solution.replace(".il", ".toml").replace(".st", ".toml");
            let exercise = Exercise::load(
                &path(&format!("{FOLDER}/solutions/{file}")),
                unoclp_core::Board::UNO,
            );
            let exercise = exercise.unwrap_or_else(|error| panic!("{error}"));
            let (_, title) = section.split_once(". ").unwrap();
            let title = title.lines().next().unwrap();
            assert_eq!(exercise.title.text(lang), title, "{page}");
            let (_, asked) = section.split_once(mark).unwrap();
            let asked = asked.split("\n\n").next().unwrap();
            let asked: Vec<&str> = asked.split_whitespace().collect();
            let asked = asked.join(" ").replace(['`', '*'], "");
            // On the page it follows a word.
            let task = exercise.task.expect("it has a task");
            let same = |text: &str| text.chars().skip(1).collect::<String>();
            assert_eq!(same(task.text(lang)), same(&asked), "{page}");
        }
    }
}
