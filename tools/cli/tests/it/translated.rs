//! The figures of the translated summary of the benchmarks are those of the page that the bench writes.

use std::fs;
use std::path::Path;

fn read(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(name);
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The rows of the first table after this text, without its two lines of head.
fn rows<'p>(page: &'p str, after: &str) -> Vec<Vec<&'p str>> {
    let (_, rest) = page
        .split_once(after)
        .unwrap_or_else(|| panic!("no {after}"));
    let lines = rest.lines().skip_while(|line| !line.starts_with('|'));
    let lines = lines.take_while(|line| line.starts_with('|')).skip(2);
    let cells = |line: &'p str| line.trim_matches('|').split('|').map(str::trim).collect();
    lines.map(cells).collect()
}

/// The numbers of a cell, as English writes them.
fn figures(cell: &str) -> Vec<String> {
    let parts = cell.split(|c: char| !c.is_ascii_digit() && c != '.' && c != ',');
    let is_number = |part: &&str| part.contains(|c: char| c.is_ascii_digit());
    parts.filter(is_number).map(str::to_owned).collect()
}

/// A number as Portuguese writes it, with a point for thousands and a comma before the fraction.
fn turned(figure: &str) -> String {
    let turn = |c| match c {
        '.' => ',',
        ',' => '.',
        c => c,
    };
    figure.chars().map(turn).collect()
}

#[test]
fn the_summary_of_the_benchmarks_has_their_figures() {
    let (english, portuguese) = (read("docs/benchmarks.md"), read("docs/benchmarks.pt-BR.md"));
    let mark = "<!-- figures: ";
    let marks = portuguese
        .lines()
        .filter_map(|line| line.strip_prefix(mark));
    let headings: Vec<&str> = marks.filter_map(|line| line.strip_suffix(" -->")).collect();
    assert!(headings.len() > 5, "{headings:?}");
    for heading in headings {
        let here = rows(&portuguese, &format!("{mark}{heading} -->"));
        let there = rows(&english, &format!("# {heading}\n"));
        assert_eq!(here.len(), there.len(), "{heading}");
        for (here, there) in here.iter().zip(&there) {
            assert_eq!(here.len(), there.len(), "{heading}: {there:?}");
            for (cell, original) in here.iter().zip(there.iter()).skip(1) {
                let told: Vec<String> = figures(original).iter().map(|f| turned(f)).collect();
                assert_eq!(figures(cell), told, "{heading}: {there:?}");
            }
        }
    }
}
