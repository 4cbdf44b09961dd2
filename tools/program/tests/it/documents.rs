//! Every program becomes a document of the ladder editor, and comes back as the same codes, drawn the same.

use std::fs;
use std::path::{Path, PathBuf};
use unoclp_core::{Instruction, Program};
use unoclp_draw::edit::{Document, Drawn};
use unoclp_draw::{Drawing, Ladder, Names};
use unoclp_host_sim::random::{Random, random_program};
use unoclp_program::Written;
use unoclp_testing::{held, rounds};

/// All files in a folder and in those below it.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{folder:?}: {error}"));
    let paths = entries.map(|entry| entry.unwrap().path());
    let files = paths.flat_map(|path| match path.is_dir() {
        true => files(&path),
        false => vec![path],
    });
    files.collect()
}

fn codes(program: &Program<'_>) -> Vec<i32> {
    let codes = program.steps().flat_map(Instruction::codes);
    std::iter::once(0).chain(codes).collect()
}

fn pictures(drawing: &Drawing<'_>) -> Vec<String> {
    drawing.rungs.iter().map(ToString::to_string).collect()
}

/// Makes a document of a program, and the program's codes of that.
fn comes_back(name: &str, program: &Program<'_>) {
    let document = Document::of_steps(program.steps());
    assert_eq!(document.codes(), Ok(codes(program)), "{name}");
    let mistakes = document.check(unoclp_core::Board::UNO);
    let errors = mistakes.iter().find(|mistake| mistake.what.is_error());
    assert_eq!(errors, None, "{name}");
    if !mistakes.is_empty() {
        return;
    }
    let ladder = Ladder::new(program.steps());
    let drawn = Drawn::of(&document);
    let names = Names::new();
    let style = unoclp_draw::Style {
        width: 80,
        names: &names,
        medium: unoclp_draw::Medium::PLAIN,
    };
    assert_eq!(
        pictures(&drawn.draw(80, &names)),
        pictures(&ladder.draw(&style)),
        "{name}"
    );
}

#[test]
fn every_program_of_the_project_comes_back() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut count = 0;
    for folder in ["programs", "proof/suite"] {
        for path in files(&root.join(folder)) {
            let end = path.extension().and_then(|end| end.to_str());
            if !matches!(end, Some("txt" | "il" | "st" | "iscl" | "lce")) {
                continue;
            }
            let name = path.display().to_string();
            // Those that show a fault have nothing to come back.
            if let Ok(source) = Written::new(
                name.clone(),
                fs::read(&path).unwrap(),
                unoclp_core::Board::UNO,
            )
            .check(None)
            {
                comes_back(&name, source.program());
                count += 1;
            }
        }
    }
    assert!(count > 150, "{count} programs");
}

#[test]
fn random_programs_come_back() {
    let compare = |seed: u32| {
        let text = random_program(&mut Random::new(seed.into()));
        let checked = unoclp_program::load(text.as_bytes(), unoclp_core::Board::UNO).unwrap();
        comes_back(&format!("seed {seed}:\n{text}"), checked.program());
    };
    (0..rounds(1_500)).for_each(|seed| held(|| compare(seed)));
}
