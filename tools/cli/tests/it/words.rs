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

/// The rows of a section of `docs/words.md`, without its heading.
fn section(heading: &str) -> Vec<Vec<String>> {
    let page = read("docs/words.md");
    let heading = format!("## {heading}\n");
    let (_, text) = page
        .split_once(&heading)
        .unwrap_or_else(|| panic!("{heading}"));
    let text = text.split("\n## ").next().unwrap_or_default();
    let rows = text.lines().filter(|line| line.starts_with("| ")).skip(2);
    let cells = |row: &str| row.split('|').map(|cell| cell.trim().to_owned()).collect();
    rows.map(cells).collect()
}

/// The words that must not stand for what others stand for.
fn forbidden() -> Vec<String> {
    let rows = section("One word for one thing");
    let cells = rows.iter().filter_map(|row| row.get(3));
    cells
        .flat_map(|cell| cell.split(','))
        .map(|word| word.trim().to_lowercase())
        .filter(|word| !word.is_empty())
        .collect()
}

/// The phrases that no page and no message has, in either language.
fn phrases() -> Vec<String> {
    let rows = section("Phrases that no page and no message has");
    rows.iter().filter_map(|row| row.get(1).cloned()).collect()
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

/// What stands in quotation marks in a source, without its comments and its tests.
fn literals(source: &str) -> impl Iterator<Item = &str> {
    let source = source
        .split("#[cfg(test)]\nmod tests")
        .next()
        .unwrap_or_default();
    let lines = source.lines().filter(|line| {
        let line = line.trim_start();
        !line.starts_with("//") && !line.starts_with("* ")
    });
    lines.flat_map(|line| line.split('"').skip(1).step_by(2))
}

/// The Portuguese of a source: what stands in quotation marks and is not English alone.
fn portuguese(source: &str) -> String {
    let is_portuguese = |text: &&str| text.chars().any(|c| "ãáàâçéêíóôõú".contains(c));
    let texts: Vec<&str> = literals(source).filter(is_portuguese).collect();
    texts.join("\n")
}

/// Every file below a folder whose name ends so, of what is kept here: nothing that was built, nothing of others.
fn files(folder: &str, ends: &[&str], found: &mut Vec<String>) {
    for entry in fs::read_dir(path(folder)).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        let inner = if folder.is_empty() {
            name.clone()
        } else {
            format!("{folder}/{name}")
        };
        if entry.file_type().unwrap().is_dir() {
            if !["target", "node_modules", "dist", ".git"].contains(&name.as_str()) {
                files(&inner, ends, found);
            }
        } else if ends.iter().any(|end| name.ends_with(end)) {
            found.push(inner);
        }
    }
}

fn all(ends: &[&str]) -> Vec<String> {
    let mut found = Vec::new();
    files("", ends, &mut found);
    found.sort();
    found
}

/// Every page, but the one that names the words, and the history of the project.
fn pages() -> Vec<String> {
    let is_it = |name: &String| !["docs/words.md", "CHANGELOG.md"].contains(&name.as_str());
    all(&[".md"]).into_iter().filter(is_it).collect()
}

/// Every source that may have a text for users: of crates, not of their tests, and of the page.
fn sources() -> Vec<String> {
    let is_it = |name: &String| name.contains("/src/") && !name.contains("/tests/");
    all(&[".rs", ".ts"]).into_iter().filter(is_it).collect()
}

#[test]
fn pages_and_messages_use_one_word_for_one_thing() {
    let forbidden = forbidden();
    assert!(forbidden.len() > 20, "{forbidden:?}");
    let mut texts = Vec::new();
    for name in pages() {
        if name.ends_with(".pt-BR.md") {
            texts.push((name.clone(), prose(&read(&name))));
        }
    }
    assert!(texts.len() > 20, "{}", texts.len());
    let mut scenarios = all(&[".toml"]);
    scenarios.retain(|name| name.starts_with("programs/"));
    for name in sources().into_iter().chain(scenarios) {
        let text = portuguese(&read(&name)).to_lowercase();
        texts.push((name, text));
    }
    let mut found = Vec::new();
    for (name, text) in &texts {
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
fn no_page_and_no_message_has_these_phrases() {
    let phrases = phrases();
    assert!(phrases.len() > 5, "{phrases:?}");
    let mut texts: Vec<(String, String)> = Vec::new();
    for name in pages() {
        let text = prose(&read(&name));
        texts.push((name, text));
    }
    for name in sources() {
        let source = read(&name);
        let said: Vec<&str> = literals(&source)
            .filter(|text| text.contains(' '))
            .collect();
        texts.push((name, said.join("\n").to_lowercase()));
    }
    let mut found = Vec::new();
    for (name, text) in &texts {
        let held = phrases.iter().filter(|phrase| has(text, phrase));
        found.extend(held.map(|phrase| format!("{name}: {phrase}")));
    }
    assert!(
        found.is_empty(),
        "docs/words.md has others for these:\n{}",
        found.join("\n")
    );
}

/// The sentences of a page, in one line each: paragraphs and items of lists, without tables, headings, blocks and
/// what links lead to. A colon and a semicolon end one too.
fn sentences(page: &str) -> Vec<String> {
    let blocks: String = page.split("\n```").step_by(2).collect();
    let mut parts = vec![String::new()];
    for line in blocks.lines() {
        let line = line.trim();
        let begins = |mark: &str| line.starts_with(mark);
        let is_none = line.is_empty() || begins("#") || begins("|") || begins("!") || begins("<");
        let counted = line
            .split_once(". ")
            .is_some_and(|(n, _)| n.parse::<u32>().is_ok());
        if is_none || counted || begins("- ") || begins("* ") {
            parts.push(String::new());
        }
        if let (false, Some(part)) = (is_none, parts.last_mut()) {
            part.push_str(line);
            part.push(' ');
        }
    }
    let ends = |pair: [char; 2]| ".!?:;".contains(pair[0]) && pair[1] == ' ';
    let mut sentences = Vec::new();
    for part in parts {
        let code: Vec<&str> = part.split('`').step_by(2).collect();
        let mut sentence = String::new();
        let mut last = ' ';
        for letter in unlinked(&code.join("X")).chars() {
            sentence.push(letter);
            if ends([last, letter]) {
                sentences.push(std::mem::take(&mut sentence));
            }
            // What ends a sentence may stand before what closes bold letters, quotes or brackets.
            if !"*_)\"”".contains(letter) {
                last = letter;
            }
        }
        sentences.push(sentence);
    }
    sentences
}

/// A text without what its links lead to.
fn unlinked(text: &str) -> String {
    let mut parts = text.split("](");
    let mut told = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        told.push_str(part.split_once(')').map_or("", |(_, rest)| rest));
    }
    told
}

/// How many words a sentence has: numbers count, signs do not.
fn length(sentence: &str) -> usize {
    let words = sentence.split_whitespace();
    words
        .filter(|word| word.contains(char::is_alphanumeric))
        .count()
}

#[test]
fn sentences_are_short() {
    const MOST: usize = 25;
    let mut found = Vec::new();
    for name in pages() {
        for sentence in sentences(&read(&name)) {
            let words = length(&sentence);
            if words > MOST {
                found.push(format!("{name}: {words} words: {sentence}"));
            }
        }
    }
    assert!(found.is_empty(), "{}:\n{}", found.len(), found.join("\n"));
}

#[test]
fn a_sentence_ends_where_a_reader_pauses() {
    let page =
        "# Head\n\nOne two; three\n[four](five.md) six.\n\n- seven `a b c`: eight\n\n| nine |\n";
    let told = sentences(page);
    let told: Vec<usize> = told
        .iter()
        .map(|text| length(text))
        .filter(|words| *words > 0)
        .collect();
    assert_eq!(told, [2, 3, 2, 1]);
}

#[test]
fn a_forbidden_word_is_found_as_a_whole() {
    assert!(has("um salto para trás", "salto"));
    assert!(!has("ressalto e saltos", "salto"));
    assert!(has(&prose("o tempo\n  ajustado"), "tempo ajustado"));
    assert!(!has(&prose("é `preset` em\n```\npreset\n```\n"), "preset"));
}
