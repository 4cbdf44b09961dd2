//! The cases of the scenario files.

use super::scenarios;
use std::path::{Path, PathBuf};
use unoclp_core::{Board, Fault, Loader};
use unoclp_exercise::scenario::{Exercise, Scenario};
use unoclp_testing::cases;

/// Which cases of an exercise are run: each is a start and some seconds, and there are many.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Of {
    /// All.
    Each,
    /// The first, where another test runs all of them.
    First,
}

/// All cases of the scenario files in these folders but for these of exercises, as far as they are of this board, each with its file; in a quick run one of
/// each few.
pub fn every_scenario(folders: &[&str], of: Of) -> impl Iterator<Item = (PathBuf, Scenario)> {
    cases(scenarios(folders).into_iter().flat_map(move |path| {
        let mut all =
            Scenario::load_all(&path, Board::UNO).unwrap_or_else(|error| panic!("{error}"));
        if crate::BOARD == Board::UNO && is_of_mega(&path) {
            all.clear();
        }
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

/// Whether a scenario names the Mega as its board: its program asks for points that a UNO lacks.
pub fn is_of_mega(path: &Path) -> bool {
    let exercise = Exercise::load(path, Board::UNO);
    exercise.is_ok_and(|exercise| exercise.board == Board::MEGA)
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
