//! The examples of the pages about the typed languages do what stands below them.

use crate::board;
use std::fs;
use std::path::Path;
use unoclp_lang::run::Machine;
use unoclp_lang::typed::{Base, Value};
use unoclp_lang::{Diagnostic, Severity, TextLanguage, check};

/// A language, its page, and how many examples that has at least.
const PAGES: [(TextLanguage, &str, usize); 6] = [
    (TextLanguage::St, "structured-text", 9),
    (TextLanguage::St, "types", 8),
    (TextLanguage::St, "sfc", 3),
    (TextLanguage::Iscl, "interscl", 3),
    (TextLanguage::Lce, "lce", 4),
    (TextLanguage::Il, "instruction-list", 4),
];

fn read(page: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../docs")
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
            let checked = check(program, language, unoclp_core::Board::UNO);
            assert_eq!(checked.diagnostics.listed, [], "{page}: {program}");
            let made = board::compiled(program, language);
            let lacks = |d: &Diagnostic| {
                d.severity() == Severity::Error && (201..=210).contains(&d.code.number())
            };
            let refused = made.diagnostics.iter().any(lacks);
            assert!(made.program.is_some() != refused, "{page}: {program}");
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
                let named = symbol.values.name_of(value.int());
                let shown = named.map_or_else(|| value.shown(base), str::to_owned);
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

/// The cells of each row of a page's tables.
fn table_rows(text: &str) -> Vec<Vec<String>> {
    let rows = text.lines().filter(|line| line.starts_with("| "));
    rows.map(|row| {
        let cells = row.trim_matches('|').split('|');
        cells.map(|cell| cell.trim().replace('`', "")).collect()
    })
    .collect()
}

/// The elementary types as the compiler has them.
fn bases() -> impl Iterator<Item = Base> {
    Base::ALL.iter().copied().filter(|base| !base.is_any())
}

#[test]
fn the_table_of_types_says_what_the_compiler_has() {
    for (page, lacks) in [("types.md", "no:"), ("types.pt-BR.md", "não:")] {
        let rows = table_rows(&read(page));
        for base in bases() {
            let row = rows
                .iter()
                .find(|row| row.len() == 6 && row[0].split(',').next() == Some(base.name()))
                .unwrap_or_else(|| panic!("{page}: {base}"));
            if !base.is_text() {
                assert_eq!(row[1], base.bits().to_string(), "{page}: {base}");
            }
            let on_board = !row[5].starts_with(lacks);
            assert_eq!(on_board, base.is_on_board(), "{page}: {base}");
            if let Some((least, most)) = base.range() {
                let shown = |number| Value::Int(number).shown(base);
                assert_eq!(plain(&row[2]), plain(&shown(least)), "{page}: {base}");
                // The last day is not a whole one.
                if base != Base::Dt {
                    assert_eq!(plain(&row[3]), plain(&shown(most)), "{page}: {base}");
                }
            }
        }
    }
}

/// A value however its zeros are written.
fn plain(value: &str) -> String {
    value.replace("16#0", "0").replace(".000", "")
}

#[test]
fn the_table_of_conversions_says_what_the_compiler_does() {
    for page in ["types.md", "types.pt-BR.md"] {
        let rows = table_rows(&read(page));
        for from in bases().filter(|base| base.is_int() || *base == Base::Real) {
            let into: Vec<&str> = bases()
                .filter(|to| *to != from && from.widens_to(*to))
                .map(Base::name)
                .collect();
            let row = rows
                .iter()
                .find(|row| row.len() == 2 && row[0] == from.name());
            let said = row.map_or("", |row| row[1].as_str());
            let mut said: Vec<&str> = said.split(", ").filter(|name| !name.is_empty()).collect();
            said.sort_by_key(|name| into.iter().position(|other| other == name));
            assert_eq!(said, into, "{page}: {from}");
        }
    }
}

#[test]
fn the_table_of_points_says_where_variables_stand() {
    for page in ["structured-text.md", "structured-text.pt-BR.md"] {
        let text = read(page);
        let (_, rest) = text.split_once("<!-- addresses:begin -->").unwrap();
        let (table, _) = rest.split_once("<!-- addresses:end -->").unwrap();
        let rows = table.lines().filter(|line| line.starts_with("| `"));
        let mut count = 0;
        for row in rows {
            let (written, points) = row.trim_matches('|').split_once(" | ").unwrap();
            let written = written.split('`').skip(1).step_by(2);
            let points: Vec<&str> = points.split_whitespace().collect();
            let points = points.chunks(3).map(|point| point[..2].join(" "));
            for (address, point) in written.zip(points) {
                let ty = if address.contains('W') { "INT" } else { "BOOL" };
                let program = format!("VAR x AT {address} : {ty}; y : {ty}; END_VAR y := x;");
                let made = board::compiled(&program, TextLanguage::St);
                assert_eq!(made.diagnostics.listed, [], "{page}: {program}");
                assert_eq!(
                    made.places()[0].as_deref(),
                    Some(&*point),
                    "{page}: {program}"
                );
                count += 1;
            }
        }
        assert_eq!(count, 20, "{page}");
    }
}
