//! How many sources know a board by its name, outside what makes and proves one: docs/porting.md lists them.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use xtask::shell;

/// What every board adds itself to; fewer than eight.
const EACH: [&str; 7] = [
    "page/uno/src/boards.ts",
    "page/uno/src/chip/model.ts",
    "page/uno/src/wiring.ts",
    "tools/boot/src/model.rs",
    "tools/cli/src/commands/flash.rs",
    "xtask/src/budget.rs",
    "xtask/src/firmware.rs",
];

/// What knows the Mega for a manner of its own: its boot loader waits as long as it hears something; an example in a message;
/// the help in Portuguese; the pages with its figures; its wiring picture.
const OWN: [&str; 6] = [
    "tools/cli/src/commands/help.rs",
    "tools/client/src/link.rs",
    "tools/site/src/lines.rs",
    "xtask/src/bench.rs",
    "xtask/src/bench/machines.rs",
    "xtask/src/wiring.rs",
];

/// Where sources are, beside `firmware/`, `device/` and `proof/`.
const FOLDERS: [&str; 8] = [
    "examples", "host-sim", "ladder", "language", "page", "tools", "xtask", "programs",
];

/// Sources below a folder, by their paths from the root; no tests, and nothing that others have written.
fn sources(folder: &Path, into: &mut Vec<String>) {
    for entry in fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        let name = entry.file_name();
        let name = name.to_str().expect("a name");
        if path.is_dir() {
            if !["tests", "test", "node_modules", "data"].contains(&name) {
                sources(&path, into);
            }
        } else if [".rs", ".ts", ".mjs"].iter().any(|end| name.ends_with(end)) {
            let path = path.strip_prefix(shell::root()).expect("below the root");
            into.push(path.display().to_string());
        }
    }
}

/// Whether a line of code names the Mega; comments do not count.
fn names_mega(line: &str) -> bool {
    let code = line.split("//").next().unwrap_or_default();
    code.split(|sign: char| !sign.is_ascii_alphanumeric())
        .any(|word| ["mega", "atmega2560"].contains(&&*word.to_ascii_lowercase()))
}

#[test]
fn a_new_board_touches_fewer_than_eight_sources() {
    let mut files = Vec::new();
    for folder in FOLDERS {
        sources(&shell::root().join(folder), &mut files);
    }
    assert!(files.len() > 800, "{}", files.len());
    let knows = |file: &&String| {
        let text = fs::read_to_string(shell::root().join(file)).expect("a text");
        let shipped = text.split("#[cfg(test)]").next().unwrap_or_default();
        shipped.lines().any(names_mega)
    };
    let found: BTreeSet<&str> = files.iter().filter(knows).map(String::as_str).collect();
    let known: BTreeSet<&str> = EACH.into_iter().chain(OWN).collect();
    assert_eq!(found, known);
    for page in ["docs/porting.md", "docs/porting.pt-BR.md"] {
        let text = fs::read_to_string(shell::root().join(page)).expect("a page");
        for file in EACH.iter().chain(&OWN) {
            assert!(text.contains(&format!("`{file}`")), "{page}: {file}");
        }
    }
}
