//! Each floor and each room says at its door what it owns and what it must not know: in the first comment of the crate, or
//! in its README. A floor names its rooms.

use std::fs;
use std::path::{Path, PathBuf};
use xtask::shell::root;

/// The floors that have rooms.
const FLOORS: [&str; 7] = [
    "device", "examples", "language", "ladder", "tools", "page", "proof",
];
/// Rooms with a door of their own, at the root.
const ALONE: [&str; 3] = ["firmware", "host-sim", "xtask"];
/// Folders that are nobody's work.
const MADE: [&str; 2] = ["node_modules", "target"];

/// The folders of a floor, by name.
fn rooms(floor: &str) -> Vec<String> {
    let entries = fs::read_dir(root().join(floor)).expect("the floor is there");
    let mut rooms: Vec<String> = entries
        .map(|entry| entry.expect("it can be listed"))
        .filter(|entry| entry.path().is_dir())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .filter(|name| !MADE.contains(&&**name))
        .collect();
    rooms.sort();
    rooms
}

/// What stands at the door of a folder: the comment that its crate begins with, else its README.
fn door(folder: &Path) -> (PathBuf, String) {
    let files = ["src/lib.rs", "src/main.rs"].map(|file| folder.join(file));
    for file in files {
        let Ok(text) = fs::read_to_string(&file) else {
            continue;
        };
        let comment: Vec<&str> = text
            .lines()
            .map_while(|line| line.strip_prefix("//!"))
            .map(str::trim)
            .collect();
        // A crate may have its README for its comment.
        if !comment.is_empty() {
            return (file, comment.join("\n"));
        }
    }
    let file = folder.join("README.md");
    let text = fs::read_to_string(&file).unwrap_or_default();
    (file, text)
}

/// Whether a paragraph says `Owns …. Must not know ….`
fn says_its_own(text: &str) -> bool {
    text.split("\n\n").any(|paragraph| {
        let words: Vec<&str> = paragraph.split_whitespace().collect();
        let line = words.join(" ");
        let rest = line
            .strip_prefix("Owns ")
            .and_then(|rest| rest.split_once(" Must not know "));
        rest.is_some_and(|(_, must_not)| must_not.contains('.'))
    })
}

#[test]
fn the_form_is_found_where_it_is() {
    assert!(says_its_own(
        "# A\n\nOwns a,\nand b. Must not know\nc.\n\nOther."
    ));
    assert!(!says_its_own("It owns a. Must not know b."));
    assert!(!says_its_own("Owns a.\n\nMust not know b."));
}

#[test]
fn each_room_says_what_it_owns_and_must_not_know() {
    let below = FLOORS.iter().flat_map(|floor| {
        let rooms = rooms(floor);
        rooms.into_iter().map(move |room| format!("{floor}/{room}"))
    });
    let all: Vec<String> = FLOORS
        .iter()
        .chain(&ALONE)
        .map(|name| (*name).to_owned())
        .chain(below)
        .collect();
    assert!(all.len() > 30, "{all:?}");
    let silent: Vec<String> = all
        .iter()
        .map(|room| door(&root().join(room)))
        .filter(|(_, text)| !says_its_own(text))
        .map(|(file, _)| file.display().to_string())
        .collect();
    assert!(
        silent.is_empty(),
        "a paragraph `Owns …. Must not know ….` is missing in {silent:#?}"
    );
}

#[test]
fn each_floor_names_its_rooms() {
    for floor in FLOORS {
        let readme = fs::read_to_string(root().join(floor).join("README.md"));
        let readme = readme.unwrap_or_else(|error| panic!("{floor}/README.md: {error}"));
        let line = readme.lines().find_map(|line| line.strip_prefix("Rooms: "));
        let line = line.unwrap_or_else(|| panic!("{floor}/README.md has no line `Rooms: …`"));
        let mut named: Vec<&str> = line
            .split('`')
            .skip(1)
            .step_by(2)
            .map(|room| room.trim_end_matches('/'))
            .collect();
        named.sort_unstable();
        assert_eq!(named, rooms(floor), "the rooms of {floor}/README.md");
    }
}
