//! Every scenario of the project on the core: the samples in `programs/`, the tests in `proof/suite/`.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use unoclp_core::Board;
use unoclp_core::isa::Opcode;
use unoclp_exercise::scenario::{Exercise, Scenario, Verdict, check};
use unoclp_host_sim::engine::HostEngine;

/// The scenario files in a folder and in all folders below it, in the order of their names. Machines are none.
fn scenarios(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{folder:?}: {error}"));
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    let machines = ["programs/plants", "programs/exercises/machines"];
    paths.retain(|path| !machines.iter().any(|folder| path.ends_with(folder)));
    paths.sort();
    let is_scenario = |path: &PathBuf| path.extension().is_some_and(|end| end == "toml");
    let files = paths.iter().flat_map(|path| match path.is_dir() {
        true => scenarios(path),
        false => Some(path.clone()).filter(is_scenario).into_iter().collect(),
    });
    files.collect()
}

#[test]
fn every_scenario_passes_on_the_core() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut failures = Vec::new();
    let mut count = 0;
    for folder in ["programs", "proof/suite"] {
        let paths = scenarios(&root.join(folder));
        assert!(!paths.is_empty(), "no scenario in {folder}");
        count += paths.len();
        for path in paths {
            let board = Exercise::load(&path, Board::UNO).map_or(Board::UNO, |own| own.board);
            let scenarios = Scenario::load_all(&path, Board::UNO).unwrap_or_else(|error| {
                failures.push(error.to_string());
                Vec::new()
            });
            for scenario in scenarios {
                let report = check(&scenario, &mut HostEngine::new(board));
                if !report.passed() || report.verdict == (Verdict::Met { comparisons: 0 }) {
                    failures.push(report.to_string());
                }
            }
        }
    }
    println!("{count} scenarios");
    assert!(
        failures.is_empty(),
        "{} fail:\n{}",
        failures.len(),
        failures.join("\n")
    );
}

#[test]
fn every_instruction_has_a_scenario() {
    let suite = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../proof/suite");
    let mut seen = BTreeSet::new();
    for path in scenarios(&suite) {
        let scenario = Scenario::load(&path, unoclp_core::Board::UNO).unwrap();
        // Of programs that are refused nothing is run.
        if let Ok(checked) =
            unoclp_program::load(&scenario.program().bytes, unoclp_core::Board::UNO)
        {
            seen.extend(checked.program().steps().map(|step| step.opcode));
        }
    }
    let missing: Vec<&Opcode> = Opcode::ALL.iter().filter(|o| !seen.contains(o)).collect();
    assert!(
        missing.is_empty(),
        "no scenario in proof/suite/ runs {missing:?}"
    );
}
