//! Above the device nobody knows what the UNO has: a board is an argument, and the default is chosen at a door.

use std::fs;
use std::path::{Path, PathBuf};

/// What holds the UNO's limits, or held them.
const NAMES: [&str; 8] = [
    "Board::UNO",
    "Board::NANO",
    "Profile::UNO",
    "program::BOARD",
    "BOARD.i",
    "BOARD.o",
    "BOARD.m",
    "limits::",
];

/// Where a person or a page says which board is meant, or does not.
const DOORS: [&str; 3] = [
    "tools/client/src/lib.rs",
    "tools/cli/src/commands/wording.rs",
    "page/bridge/src/facts.rs",
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|end| end == "rs")
            && !path.ends_with("tests.rs")
            && !is_test(&path)
        {
            found.push(path);
        }
    }
}

/// Whether the module in this file is compiled for tests alone.
fn is_test(path: &Path) -> bool {
    let name = path.file_stem().unwrap().to_string_lossy();
    let door = path.with_file_name("mod.rs");
    let says = format!("#[cfg(test)]\nmod {name};");
    fs::read_to_string(door).is_ok_and(|text| text.contains(&says))
}

/// The lines of a file before its tests, without its comments.
fn code(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let (code, _) = text.split_once("#[cfg(test)]\nmod").unwrap_or((text, ""));
    let lines = (1..).zip(code.lines());
    lines.filter(|(_, line)| !line.trim_start().starts_with("//"))
}

#[test]
fn no_room_above_the_device_knows_the_uno() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let rooms = ["language", "ladder", "tools", "page/bridge"];
    let (mut seen, mut told) = (0, Vec::new());
    for floor in rooms {
        let mut files = Vec::new();
        let floor = root.join(floor);
        match floor.join("src").is_dir() {
            true => sources(&floor.join("src"), &mut files),
            false => {
                for room in fs::read_dir(&floor).unwrap() {
                    let sources_of = room.unwrap().path().join("src");
                    if sources_of.is_dir() {
                        sources(&sources_of, &mut files);
                    }
                }
            }
        }
        for file in files {
            let name = file.strip_prefix(&root).unwrap().display().to_string();
            seen += 1;
            if DOORS.contains(&name.as_str()) {
                continue;
            }
            let text = fs::read_to_string(&file).unwrap();
            for (number, line) in code(&text) {
                if NAMES.iter().any(|known| line.contains(known)) {
                    told.push(format!("{name}:{number}: {}", line.trim()));
                }
            }
        }
    }
    assert!(seen > 300, "{seen}");
    assert_eq!(told, [""; 0], "pass the board down");
}
