//! The examples of the pages about the typed languages do what stands below them.

use std::fs;
use std::path::Path;
use unoclp_lang::run::Machine;
use unoclp_lang::{TextLanguage, check};

/// A language, its page, and how many examples that has at least.
const PAGES: [(TextLanguage, &str, usize); 4] = [
    (TextLanguage::St, "structured-text", 9),
    (TextLanguage::Iscl, "interscl", 3),
    (TextLanguage::Lce, "lce", 4),
    (TextLanguage::Il, "instruction-list", 3),
];

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
    for (language, page, least) in PAGES {
        let text = read(&format!("{page}.md"));
        let (programs, results) = (blocks(&text, language.name()), blocks(&text, "text"));
        assert_eq!(programs.len(), results.len(), "{page}");
        assert!(programs.len() >= least, "{page}");
        for (program, result) in programs.into_iter().zip(results) {
            let checked = check(program, language);
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
    for (language, page, _) in PAGES {
        let [english, portuguese] = ["md", "pt-BR.md"].map(|end| read(&format!("{page}.{end}")));
        for kind in [language.name(), "text"] {
            assert_eq!(blocks(&english, kind), blocks(&portuguese, kind), "{page}");
        }
    }
}
