//! The tests of plants, in one binary.

mod goals;
mod mistakes;
mod pages;
mod pictures;
mod random;

use std::fs;
use std::path::{Path, PathBuf};
use unoclp_core::Board;
use unoclp_plant::{Plant, read};
use unoclp_words::Lang;

/// A folder of the project.
fn folder(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(path)
}

/// The plant of a text that is right.
fn plant(text: &str) -> Plant {
    read(text, Board::UNO).unwrap_or_else(|mistakes| {
        let told = mistakes
            .iter()
            .map(|mistake| mistake.text("plant", Lang::En));
        panic!("{}", told.collect::<Vec<_>>().join("\n"))
    })
}

/// Every plant that is shipped, with its name.
fn plants() -> Vec<(String, Plant)> {
    let entries = fs::read_dir(folder("programs/plants")).unwrap();
    let files = entries.map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> = files
        .filter(|file| file.extension().is_some_and(|end| end == "toml"))
        .collect();
    files.sort();
    assert_eq!(files.len(), 20);
    let read = |file: PathBuf| {
        let name = file.file_stem().unwrap().to_str().unwrap().to_owned();
        (name, plant(&fs::read_to_string(file).unwrap()))
    };
    files.into_iter().map(read).collect()
}
