//! Programs that stand in several languages: each does what the scenario says, and takes little more than by hand.

use std::fs;
use std::path::{Path, PathBuf};
use unoclp_host_sim::engine::HostEngine;
use unoclp_host_sim::scenario::{ProgramFile, Scenario, check};
use unoclp_source::{Source, Written};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../programs/languages")
}

fn checked(path: &Path) -> Source {
    let name = path.display().to_string();
    let bytes = fs::read(path).unwrap_or_else(|error| panic!("{name}: {error}"));
    let written = Written::new(name, bytes);
    written
        .check(None)
        .unwrap_or_else(|refused| panic!("{refused:?}"))
}

/// The scenarios of the folder, by the names of their programs.
fn scenarios() -> Vec<PathBuf> {
    let entries = fs::read_dir(folder()).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("it can be read").path());
    let mut paths: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    paths.sort();
    paths
}

#[test]
fn every_language_passes_the_scenario() {
    let paths = scenarios();
    assert!(paths.len() >= 3);
    for path in paths {
        for end in ["txt", "st"] {
            let source = checked(&path.with_extension(end));
            let program = ProgramFile {
                name: source.name.clone(),
                bytes: source.code.clone(),
            };
            let scenario = Scenario::load_for(&path, program).expect("the scenario is right");
            let report = check(&scenario, &mut HostEngine::default());
            assert!(report.passed(), "{}: {report}", source.name);
        }
    }
}

#[test]
fn structured_text_takes_little_more_than_numeric_code() {
    for path in scenarios() {
        let bytes = |end| checked(&path.with_extension(end)).size.stored_bytes;
        let (by_hand, compiled) = (bytes("txt"), bytes("st"));
        println!("{}: {by_hand} by hand, {compiled} compiled", path.display());
        assert!(compiled * 4 <= by_hand * 5, "{}", path.display());
    }
}
