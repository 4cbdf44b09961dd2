//! What an upload sends of each program that comes with unoclp.

use std::fs;
use std::path::{Path, PathBuf};
use unoclp_client::upload::Codes;
use unoclp_core::Board;
use unoclp_program::{Source, Written, not_sent};

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => files(&path, found),
            false => found.push(path),
        }
    }
}

/// All programs under `programs/` that are sent to a board.
fn programs() -> Vec<Source> {
    let mut found = Vec::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs");
    files(&root, &mut found);
    found.sort_unstable();
    let read = |path: &PathBuf| {
        let name = path.to_str()?.to_owned();
        let source = Written::new(name, fs::read(path).ok()?, Board::UNO).check(None);
        source
            .ok()
            .filter(|source| not_sent(source, unoclp_program::Lang::En).is_none())
    };
    found.iter().filter_map(read).collect()
}

/// Bytes that the codes of a program take, each with the end of its line.
fn own(source: &Source) -> usize {
    let text = String::from_utf8_lossy(&source.code);
    let codes = text
        .lines()
        .map(|line| line.split('/').next().unwrap_or_default().trim());
    codes
        .filter(|code| !code.is_empty())
        .map(|code| code.len() + 1)
        .sum()
}

#[test]
fn an_upload_sends_little_more_than_the_codes() {
    let programs = programs();
    assert!(programs.len() > 100, "{}", programs.len());
    for source in programs {
        let sent = Codes::of(source.program(), &source.code).bytes().len();
        let own = own(&source);
        assert!(5 * sent <= 6 * own, "{}: {sent} of {own}", source.name);
    }
}
