//! What a user reads stands in a table, beside its twin in the other language: the sources hold no text elsewhere.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::fs;
use std::path::{Path, PathBuf};

/// What holds both languages, or words of one beside a table of the other.
const TABLES: &[&str] = &[
    "tools/cli/src/messages/table.rs",
    "tools/cli/src/metrics.rs",
    "tools/cli/src/commands/help.rs",
    "tools/cli/src/commands/refuse.rs",
    "tools/client/src/words.rs",
    "tools/exercise/src/diagram/words.rs",
    "tools/exercise/src/scenario/words.rs",
    "tools/program/src/diagnosis/help.rs",
    "tools/program/src/diagnosis/portuguese.rs",
    "tools/program/src/edit.rs",
    "tools/program/src/effect.rs",
    "tools/program/src/list/words.rs",
    "tools/program/src/messages.rs",
    "tools/program/src/words.rs",
];

/// What is no text for users: it names things that have that name in every language, or is for developers.
const NAMES: &[&str] = &[
    // Columns of a spreadsheet, which are the same for what reads them, and how a page begins.
    "cases passed",
    "first failing case",
    "<!doctype html",
    // Marks of the tools' own files: what reads them knows them by these words.
    "<!-- unoclp: this file is overwritten without a question -->",
    "unoclp ",
    "[unoclp: length and check sum in the last line]",
    "/ unoclp: ",
    "0         / program start",
    "{bytes} bytes, check sum {:04X}",
    // What the register map calls it.
    "no reset",
    // The fonts and the dashes of a drawing.
    "Helvetica, Arial, 'DejaVu Sans', sans-serif",
    // What the reader of TOML says.
    "missing field `about`",
    "unknown field `{key}`",
    "unknown field",
    "missing field",
    "duplicate key",
    "invalid type",
    "invalid value",
    // The key of a scenario.
    "{name} (text)",
    "'DejaVu Sans Mono', Consolas, Menlo, monospace",
    // Boxes of a ladder, beside their mnemonics.
    "scan µs",
    "time ms",
    "D{from}-{} to D{to}-{}",
    "{}..{} to {}..{}",
    // Classes of a drawing.
    "element n{}",
    "wire n{net}",
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|end| end == "rs")
            && !path.ends_with("tests.rs")
            && !path
                .parent()
                .is_some_and(|folder| folder.ends_with("tests"))
        {
            found.push(path);
        }
    }
}

/// The literals that may come to be read: not those of documentation, arguments of the command line, and tests.
fn literals(tokens: TokenStream, found: &mut Vec<String>) {
    let mut tokens = tokens.into_iter().peekable();
    let mut of_a_test = false;
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(mark) if mark.as_char() == '#' => {
                tokens.next_if(
                    |next| matches!(next, TokenTree::Punct(mark) if mark.as_char() == '!'),
                );
                if let Some(TokenTree::Group(attribute)) = tokens.next() {
                    let text = attribute.stream().to_string();
                    of_a_test |= text.starts_with("cfg (test)") || text.starts_with("cfg(test)");
                    if text.starts_with("error") {
                        literals(attribute.stream(), found);
                    }
                }
            }
            TokenTree::Group(group) if of_a_test && group.delimiter() == Delimiter::Brace => {
                of_a_test = false;
            }
            TokenTree::Group(group) => literals(group.stream(), found),
            TokenTree::Punct(mark) if mark.as_char() == ';' => of_a_test = false,
            TokenTree::Literal(literal) if !of_a_test => {
                let literal = literal.to_string();
                found.extend(literal.strip_prefix('"').map(str::to_owned));
            }
            _ => {}
        }
    }
}

/// Whether it has a word beside others: two letters or more, without the values and marks of a format.
fn is_text(literal: &str) -> bool {
    let mut plain = String::new();
    let mut depth = 0;
    for character in literal.trim_end_matches('"').chars() {
        match character {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ if depth == 0 => plain.push(character),
            _ => {}
        }
    }
    let plain = plain
        .replace("\\n", " ")
        .replace("\\r", " ")
        .replace("\\x1b", " ");
    let is_word = |word: &str| {
        let word = word.trim_matches(|c: char| !c.is_alphabetic());
        // Units and file names are the same in both.
        word.len() > 1 && word.chars().all(|c| c.is_lowercase()) && !["ms", "µs"].contains(&word)
    };
    plain.contains(' ') && plain.split_whitespace().any(is_word)
}

#[test]
fn every_text_stands_in_a_table() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files = Vec::new();
    for folder in [
        "tools/cli/src",
        "tools/client/src",
        "tools/exercise/src/diagram",
        "tools/exercise/src/scenario",
        "tools/program/src",
        "ladder/draw/src",
        "device/checked/src",
    ] {
        sources(&root.join(folder), &mut files);
    }
    assert!(files.len() > 60, "{}", files.len());
    let mut told = Vec::new();
    for file in files {
        if TABLES.iter().any(|table| file.ends_with(table)) {
            continue;
        }
        let mut found = Vec::new();
        literals(
            fs::read_to_string(&file).unwrap().parse().unwrap(),
            &mut found,
        );
        found.retain(|literal| is_text(literal) && !NAMES.contains(&literal.trim_end_matches('"')));
        told.extend(
            found
                .into_iter()
                .map(|text| format!("{}: \"{text}", file.display())),
        );
    }
    assert!(
        told.is_empty(),
        "put these into a table of messages:\n{}",
        told.join("\n")
    );
}

#[test]
fn a_text_without_a_twin_is_found() {
    let source = r#"
        /// A page of it
        #[error("the port is gone")]
        fn f() { bail!("there is no {file}"); say!("{name}: {line}"); let at = format!(" at {port}"); }
        #[cfg(test)]
        mod tests { const T: &str = "only a test"; }
        const UNIT: &str = "{time} ms";
    "#;
    let mut found = Vec::new();
    literals(source.parse().unwrap(), &mut found);
    found.retain(|literal| is_text(literal));
    assert_eq!(
        found,
        [
            r#"the port is gone""#,
            r#"there is no {file}""#,
            r#" at {port}""#
        ]
    );
}
