//! The cases of the scenario files.

use super::scenarios;
use std::path::PathBuf;
use unoclp_core::{Board, Fault, Loader};
use unoclp_exercise::scenario::Scenario;
use unoclp_testing::cases;

/// Which cases of an exercise are run: each is a start and some seconds, and there are many.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Of {
    /// All.
    Each,
    /// The first, where another test runs all of them.
    First,
}

/// All cases of the scenario files in these folders but for these of exercises, each with its file; in a quick run one of
/// each few.
pub fn every_scenario(folders: &[&str], of: Of) -> impl Iterator<Item = (PathBuf, Scenario)> {
    cases(scenarios(folders).into_iter().flat_map(move |path| {
        let all = Scenario::load_all(&path, unoclp_core::Board::UNO)
            .unwrap_or_else(|error| panic!("{error}"));
        let is_exercise = path
            .components()
            .any(|part| part.as_os_str() == "exercises");
        let most = if is_exercise && of == Of::First {
            1
        } else {
            all.len()
        };
        all.into_iter()
            .take(most)
            .map(move |scenario| (path.clone(), scenario))
    }))
}

/// The first fault of a program on a board.
pub fn first_fault(file: &[u8], board: Board) -> Option<Fault> {
    let mut memory = vec![0; board.linked_bytes.into()];
    let mut loader = Loader::new(&mut memory, board);
    for &byte in file {
        // The loader keeps the first.
        let _ = loader.push(byte);
    }
    loader.finish().err()
}
