//! The house has floors, and what stands on a floor uses what is on it or below. ARCHITECTURE.md draws them; what cargo
//! knows of the crates is held against it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;
use xtask::shell;

/// The floors from the ground up: each may use itself and those before it.
const FLOORS: [&str; 5] = ["device", "language", "ladder", "tools", "page"];

/// A crate, as its folder from the root: `tools/cli`.
type Room = String;

/// What each crate needs to be built, and what its tests need beside that.
struct Uses {
    built: BTreeSet<Room>,
    tested: BTreeSet<Room>,
}

fn rooms() -> BTreeMap<Room, Uses> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["metadata", "--format-version=1", "--no-deps", "--offline"]);
    let text = shell::output(cargo.current_dir(shell::root())).expect("cargo tells what there is");
    let all: Value = serde_json::from_str(&text).expect("cargo writes JSON");
    let room = |manifest: &str| {
        let folder = Path::new(manifest).parent().expect("a crate has a folder");
        let inside = folder
            .strip_prefix(shell::root())
            .expect("below the root")
            .to_str();
        inside.expect("a folder has a plain name").to_owned()
    };
    let packages = all["packages"].as_array().expect("a list of crates");
    let named: BTreeMap<&str, Room> = packages
        .iter()
        .map(|one| (text_of(&one["name"]), room(text_of(&one["manifest_path"]))))
        .collect();
    let mut rooms = BTreeMap::new();
    for package in packages {
        let ours = |is_tested: bool| {
            let all = package["dependencies"].as_array().expect("a list");
            let wanted = all.iter().filter(|one| (one["kind"] == "dev") == is_tested);
            wanted
                .filter_map(|one| named.get(text_of(&one["name"])).cloned())
                .collect()
        };
        let uses = Uses {
            built: ours(false),
            tested: ours(true),
        };
        rooms.insert(room(text_of(&package["manifest_path"])), uses);
    }
    rooms
}

fn text_of(value: &Value) -> &str {
    value.as_str().expect("a text")
}

/// The floor of a crate, by its folder: `proof`, `examples`, `xtask`, `firmware` and `host-sim` are floors of their own.
fn floor(room: &str) -> &str {
    room.split('/').next().unwrap_or(room)
}

/// Whether a crate on one floor may need one on another to be built.
fn may_use(user: &str, used: &str) -> bool {
    let height = |name: &str| FLOORS.iter().position(|floor| *floor == name);
    match (user, height(user), height(used)) {
        ("proof" | "xtask" | "examples", _, _) => used != "xtask",
        ("firmware" | "host-sim", _, _) => used == "device",
        (_, Some(above), Some(below)) => below <= above,
        // The simulated PLC stands on the device, so what is above the device may run it.
        ("tools" | "page", _, None) => used == "host-sim",
        _ => false,
    }
}

#[test]
fn each_crate_uses_only_its_floor_and_those_below() {
    let rooms = rooms();
    assert!(rooms.len() >= 20, "{} crates", rooms.len());
    let mut wrong = Vec::new();
    for (room, uses) in &rooms {
        for used in &uses.built {
            if !may_use(floor(room), floor(used)) {
                wrong.push(format!("{room} uses {used}"));
            }
        }
        // Tests may borrow what proofs are made of and the simulated PLC, and nothing else from a floor above.
        for used in &uses.tested {
            let is_borrowed = matches!(floor(used), "proof" | "host-sim");
            if !is_borrowed && !may_use(floor(room), floor(used)) {
                wrong.push(format!("the tests of {room} use {used}"));
            }
        }
    }
    assert!(wrong.is_empty(), "against the floors: {wrong:#?}");
}

/// The TypeScript files below a folder, with their texts.
fn scripts(folder: &Path, into: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("it can be listed").path();
        if path.is_dir() {
            scripts(&path, into);
        } else if path.extension().is_some_and(|end| end == "ts") {
            let text = fs::read_to_string(&path).expect("a text");
            into.push((path.display().to_string(), text));
        }
    }
}

/// What TypeScript imports, no crate tells: the simulated board nothing of the page, the page nothing but its entries: the
/// boards' names come with the first view, slow motion is loaded later.
#[test]
fn the_simulated_board_knows_no_page_and_the_page_its_entries_alone() {
    for (folder, other) in [("page/uno", "/web/"), ("page/web/src", "/uno/")] {
        let mut files = Vec::new();
        scripts(&shell::root().join(folder), &mut files);
        assert!(files.len() > 15, "{folder}: {}", files.len());
        for (file, text) in files {
            let mut imports = text.split(" from \"").skip(1);
            let wrong = imports.find(|import| {
                let path = import.split('"').next().unwrap_or_default();
                path.contains(other)
                    || path
                        .strip_prefix("unoclp-uno/")
                        .is_some_and(|entry| !["boards", "slow"].contains(&entry))
            });
            assert_eq!(wrong.map(|_| ()), None, "{file} imports over the wall");
        }
    }
}

/// The rows of the map: | `tools/cli/` | owns | must not know | `core`, `lang` |
fn drawn() -> BTreeMap<Room, BTreeSet<String>> {
    let page = fs::read_to_string(shell::root().join("ARCHITECTURE.md")).expect("the map is there");
    let rows = page.lines().filter(|line| line.starts_with("| `"));
    let cells = rows.map(|row| row.split('|').map(str::trim).collect::<Vec<_>>());
    let maps = cells.filter(|cells| cells.len() == 6);
    maps.map(|cells| {
        let room = cells[1].trim_matches('`').trim_end_matches('/').to_owned();
        let uses = cells[4].split(", ").filter(|used| *used != "–");
        (room, uses.map(str::to_owned).collect())
    })
    .collect()
}

#[test]
fn the_map_says_what_each_crate_uses() {
    let short = |room: &Room| room.rsplit('/').next().unwrap_or(room).to_owned();
    let built: BTreeMap<Room, BTreeSet<String>> = rooms()
        .into_iter()
        .map(|(room, uses)| (room, uses.built.iter().map(short).collect()))
        .collect();
    let drawn = drawn();
    for (room, uses) in &built {
        let row: Vec<_> = uses.iter().map(String::as_str).collect();
        assert_eq!(
            drawn.get(room),
            Some(uses),
            "the row of {room} in ARCHITECTURE.md ends in | {} |",
            if row.is_empty() {
                "–".to_owned()
            } else {
                row.join(", ")
            }
        );
    }
    let extra: Vec<_> = drawn
        .keys()
        .filter(|room| !built.contains_key(*room))
        .collect();
    assert!(extra.is_empty(), "no crates: {extra:?}");
}
