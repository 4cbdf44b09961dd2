//! The documents say what the code says.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use unoclp_core::isa::{Operand, TABLE};
use unoclp_core::{Cause, Profile};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

fn document(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The rows of the table between two marks, as their cells.
fn table(text: &str, name: &str) -> Vec<Vec<String>> {
    let begin = format!("<!-- {name}:begin -->");
    let end = format!("<!-- {name}:end -->");
    let (_, rest) = text.split_once(&begin).expect(&begin);
    let (table, _) = rest.split_once(&end).expect(&end);
    table
        .lines()
        .filter(|line| line.starts_with('|'))
        .skip(2)
        .map(|row| {
            let cells = row.trim_matches('|').split('|');
            cells.map(|cell| cell.trim().replace('`', "")).collect()
        })
        .collect()
}

#[test]
fn instruction_table() {
    let expected: Vec<Vec<String>> = TABLE
        .iter()
        .map(|row| {
            let (mut code, mut letters) = (row.code.to_string(), row.letters.to_string());
            if row.operand.is_point() {
                code.truncate(code.len() - 2);
                code += "XX";
                letters += " XX";
            }
            let bytes = if row.operand == Operand::Timer {
                "6"
            } else {
                "1"
            };
            vec![code, letters, row.effect.to_string(), bytes.to_string()]
        })
        .collect();
    assert_eq!(table(&document("docs/numeric-code.md"), "isa"), expected);
}

#[test]
fn fault_table() {
    let expected: Vec<Vec<String>> = Cause::ALL
        .iter()
        .map(|cause| vec![cause.number().to_string(), cause.text().to_string()])
        .collect();
    assert_eq!(table(&document("docs/numeric-code.md"), "faults"), expected);
}

#[test]
fn limits_of_the_uno() {
    let Profile {
        inputs,
        outputs,
        stored_bytes,
        linked_bytes,
    } = Profile::UNO;
    for name in ["README.md", "README.pt-BR.md", "docs/numeric-code.md"] {
        let rows = table(&document(name), "profile");
        let numbers: Vec<&str> = rows.iter().map(|row| row[1].as_str()).collect();
        assert_eq!(
            numbers,
            [
                inputs.to_string(),
                outputs.to_string(),
                stored_bytes.to_string(),
                linked_bytes.to_string()
            ],
            "{name}"
        );
    }
}

/// Every ruling of the language is named by a test: a scenario, or a test of a crate.
#[test]
fn every_ruling_is_tested() {
    let text = document("docs/numeric-code.md");
    let rulings: BTreeSet<&str> = text
        .lines()
        .filter_map(|line| line.strip_prefix("- NC-"))
        .map(|line| line.split(|c: char| !c.is_ascii_digit()).next().unwrap())
        .collect();
    assert!(rulings.len() >= 11, "{rulings:?}");

    let mut tests = String::new();
    for folder in [
        "programs",
        "suite",
        "core/tests",
        "card/tests",
        "uno-sim/tests",
    ] {
        read_all(&root().join(folder), &mut tests);
    }
    for ruling in rulings {
        let named = tests
            .match_indices(&format!("NC-{ruling}"))
            .any(|(at, found)| {
                !tests[at + found.len()..].starts_with(|c: char| c.is_ascii_digit())
            });
        assert!(named, "no test names NC-{ruling}");
    }
}

fn read_all(folder: &Path, into: &mut String) {
    for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{folder:?}: {error}")) {
        let path = entry.unwrap().path();
        if path.is_dir() {
            read_all(&path, into);
        } else if path.extension().is_some_and(|e| e == "toml" || e == "rs") {
            *into += &fs::read_to_string(&path).unwrap();
        }
    }
}
