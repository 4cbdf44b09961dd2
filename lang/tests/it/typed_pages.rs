//! The examples of the pages about the typed languages do what stands below them.

use std::fs;
use std::path::Path;
use unoclp_lang::run::Machine;
use unoclp_lang::{TextLanguage, check};

const PAGES: [&str; 2] = ["structured-text.md", "structured-text.pt-BR.md"];

fn read(page: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../docs")
        .join(page);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{page}: {error}"))
}

/// What a page has between ``` of this kind.
fn blocks<'t>(text: &'t str, kind: &str) -> Vec<&'t str> {
    let begin = format!("```{kind}\n");
    let parts = text.split(begin.as_str()).skip(1);
    parts.filter_map(|part| part.split("```").next()).collect()
}

/// `3 scans, 50 ms`
fn scans(line: &str) -> Option<(i64, i64)> {
    let (count, rest) = line.split_once(" scans")?;
    let every = rest
        .strip_prefix(", ")
        .and_then(|rest| rest.strip_suffix(" ms"));
    Some((
        count.parse().ok()?,
        every.map_or(1, |every| every.parse().unwrap()),
    ))
}

#[test]
fn each_example_does_what_stands_below_it() {
    for page in PAGES {
        let text = read(page);
        let (programs, results) = (blocks(&text, "st"), blocks(&text, "text"));
        assert_eq!(programs.len(), results.len(), "{page}");
        assert!(programs.len() >= 9, "{page}");
        for (program, result) in programs.into_iter().zip(results) {
            let checked = check(program, TextLanguage::St);
            assert_eq!(checked.diagnostics.listed, [], "{page}: {program}");
            let tree = checked.tree.unwrap();
            let mut machine = Machine::new(&tree);
            let (count, every) = result.lines().find_map(scans).unwrap_or((1, 1));
            for scan in 0..count {
                machine.scan(scan * every).unwrap();
            }
            for line in result.lines().filter(|line| scans(line).is_none()) {
                let (name, expected) = line.split_once(" = ").unwrap();
                let symbol = tree.symbols.iter().find(|symbol| symbol.name == name);
                let symbol = symbol.unwrap_or_else(|| panic!("{page}: {name}"));
                let (value, base) = machine.value(symbol);
                let named = symbol.values.get(value.int() as usize).cloned();
                let shown = named.unwrap_or_else(|| value.shown(base));
                assert_eq!(shown, expected, "{page}: {name} in\n{program}");
            }
        }
    }
}

#[test]
fn both_languages_have_the_same_examples() {
    let [english, portuguese] = PAGES.map(read);
    assert_eq!(blocks(&english, "st"), blocks(&portuguese, "st"));
    assert_eq!(blocks(&english, "text"), blocks(&portuguese, "text"));
}
