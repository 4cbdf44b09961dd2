//! The programs in Instruction List take no more of the board than they did.

use std::fs;
use std::path::Path;
use unoclp_lang::{TextLanguage, compile_text};

/// Each program with the bytes of program memory that it has come to take.
#[test]
fn no_program_takes_more_bytes() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let table = fs::read_to_string(root.join("tests/sizes.txt")).unwrap();
    let rows: Vec<(&str, usize)> = table
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| line.rsplit_once(' ').unwrap())
        .map(|(name, bytes)| (name, bytes.parse().unwrap()))
        .collect();
    assert!(rows.len() >= 200, "{}", rows.len());
    let larger = rows.into_iter().filter_map(|(name, least)| {
        let text = fs::read_to_string(root.join("../../programs").join(name)).unwrap();
        let program = compile_text(&text, TextLanguage::Il, unoclp_core::Board::UNO).program;
        let bytes = program.map(|(checked, _)| checked.program().stored_bytes());
        let holds = bytes.is_some_and(|bytes| bytes <= least);
        (!holds).then(|| format!("{name} {bytes:?}, not {least}"))
    });
    assert_eq!(larger.collect::<Vec<_>>(), [""; 0]);
}
