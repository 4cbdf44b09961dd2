//! Each ruling of the numeric code has a test that names it, and `docs/rulings.md` says which.

use std::fs;
use xtask::rulings::{PAGE, page, rulings};
use xtask::shell::root;

#[test]
fn each_ruling_has_a_test() {
    let rulings = rulings().unwrap();
    assert!(rulings.len() >= 29, "{:?}", rulings.keys());
    let numbers: Vec<u32> = rulings.keys().copied().collect();
    assert_eq!(numbers, (1..=rulings.len() as u32).collect::<Vec<_>>());
    let untested = rulings.iter().filter(|(_, (_, tests))| tests.is_empty());
    let untested: Vec<&u32> = untested.map(|(number, _)| number).collect();
    assert!(untested.is_empty(), "no test names NC-{untested:?}");
}

#[test]
fn the_page_is_as_it_is_written() {
    let written = fs::read_to_string(root().join(PAGE)).unwrap_or_default();
    assert_eq!(written, page().unwrap(), "run `cargo xtask rulings`");
}
