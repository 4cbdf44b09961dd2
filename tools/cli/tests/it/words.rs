//! One word for one thing in Portuguese: those of `docs/words.md`, and none of those that it forbids.

use std::fs;
use std::path::{Path, PathBuf};

fn path(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(path)
}

fn read(name: &str) -> String {
    fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The words that must not stand for what others stand for.
fn forbidden() -> Vec<String> {
    let page = read("docs/words.md");
    let rows = page.lines().filter(|line| line.starts_with("| ")).skip(2);
    rows.filter_map(|row| row.split('|').nth(3))
        .flat_map(|cell| cell.split(','))
        .map(|word| word.trim().to_lowercase())
        .filter(|word| !word.is_empty())
        .collect()
}

/// A text as its reader sees it: in one line, without what is quoted as code, in italics, in a block or as a link.
fn prose(text: &str) -> String {
    let blocks: String = text.split("```").step_by(2).collect();
    // The faults have the board's own words in their headings, and cases of tests have English names.
    let lines = blocks
        .lines()
        .filter(|line| !line.starts_with("## ") || !line.contains("(NC-"))
        .filter(|line| !line.contains(".toml: "));
    let text: Vec<&str> = lines.collect();
    let text = text.join(" ");
    let text: String = text.split('`').step_by(2).collect();
    text.split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
        .to_lowercase()
}

/// Whether this stands in the text as whole words.
fn has(text: &str, words: &str) -> bool {
    let is_letter = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
    text.match_indices(words).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let behind = text[at + words.len()..].chars().next();
        !is_letter(before) && !is_letter(behind)
    })
}

/// The Portuguese of a table of messages: what stands in quotation marks and is not English alone.
fn portuguese(source: &str) -> String {
    let texts = source.split('"').skip(1).step_by(2);
    let is_portuguese = |text: &&str| text.chars().any(|c| "ãáàâçéêíóôõú".contains(c));
    texts.filter(is_portuguese).collect::<Vec<_>>().join("\n")
}

#[test]
fn pages_and_messages_use_one_word_for_one_thing() {
    let forbidden = forbidden();
    assert!(forbidden.len() > 20, "{forbidden:?}");
    let mut texts = vec![(
        "README.pt-BR.md".to_owned(),
        prose(&read("README.pt-BR.md")),
    )];
    for page in [
        "draw",
        "exercises",
        "faults",
        "grammar-tests",
        "il-diagnostics",
        "instruction-list",
        "interscl",
        "interscl-diagnostics",
        "lce",
        "lce-diagnostics",
        "plcopen",
        "plcopen-diagnostics",
        "st-diagnostics",
        "site",
        "structured-text",
        "tutorial",
        "types",
    ] {
        let name = format!("docs/{page}.pt-BR.md");
        texts.push((name.clone(), prose(&read(&name))));
    }
    for table in [
        "tools/cli/src/messages/table.rs",
        "tools/cli/src/commands/help.rs",
        "tools/cli/src/commands/refuse.rs",
        "tools/exercise/src/diagram/words.rs",
        "tools/exercise/src/scenario/words.rs",
        "language/lang/src/messages/il.rs",
        "language/lang/src/messages/iscl.rs",
        "language/lang/src/messages/lce.rs",
        "language/lang/src/messages/st.rs",
        "language/lang/src/messages/xml.rs",
        "tools/program/src/diagnosis/help.rs",
        "tools/program/src/diagnosis/portuguese.rs",
        "tools/program/src/effect.rs",
        "tools/program/src/list/words.rs",
        "tools/program/src/words.rs",
        "tools/site/src/words.rs",
        "page/bridge/src/edit/words.rs",
    ] {
        texts.push((table.to_owned(), portuguese(&read(table)).to_lowercase()));
    }
    for folder in ["programs/exercises", "programs/tutorial/solutions"] {
        let files = fs::read_dir(path(folder)).unwrap();
        let files = files.map(|file| file.unwrap().file_name().into_string().unwrap());
        for file in files.filter(|file| file.ends_with(".toml")) {
            let name = format!("{folder}/{file}");
            let text = portuguese(&read(&name)).to_lowercase();
            texts.push((name, text));
        }
    }
    let mut found = Vec::new();
    for (name, text) in &texts {
        assert!(!text.is_empty(), "{name}");
        let words = forbidden.iter().filter(|words| has(text, words));
        found.extend(words.map(|words| format!("{name}: {words}")));
    }
    assert!(
        found.is_empty(),
        "docs/words.md has other words for these:\n{}",
        found.join("\n")
    );
}

#[test]
fn a_forbidden_word_is_found_as_a_whole() {
    assert!(has("um salto para trás", "salto"));
    assert!(!has("ressalto e saltos", "salto"));
    assert!(has(&prose("o tempo\n  ajustado"), "tempo ajustado"));
    assert!(!has(&prose("é `preset` em\n```\npreset\n```\n"), "preset"));
}
