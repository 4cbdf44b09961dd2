//! What the tests of several crates share: how many rounds they make, random programs of all types, random projects of all languages, the corpora of the
//! fuzz targets, and the programs that stand in several languages.
//!
//! Owns what tests are made of. Must not know what is tested.

pub mod chart;
mod languages;
mod least;
mod mixed;
mod random;
mod typed;

pub use languages::{Twins, in_languages};
pub use least::{held, least};
pub use mixed::mixed_project;
pub use random::Random;
pub use typed::typed_program;

use std::env;
use std::fs;
use std::panic::catch_unwind;
use std::path::Path;

/// Percent of the usual rounds: `cargo xtask test --quick` sets less than 100, `cargo xtask soak` more.
const ROUNDS: &str = "UNOCLP_ROUNDS";

fn percent() -> u32 {
    env::var(ROUNDS).map_or(100, |text| {
        let percent = text.parse().ok().filter(|&percent| percent > 0);
        percent.unwrap_or_else(|| panic!("{ROUNDS} is a percentage of 1 or more, not {text:?}"))
    })
}

/// How many rounds a random test makes that usually makes `usual`; at least one.
pub fn rounds(usual: u32) -> u32 {
    let rounds = u64::from(usual) * u64::from(percent()) / 100;
    rounds.clamp(1, u32::MAX.into()) as u32
}

/// All cases of a test that goes through every one of them. In a quick run, one of each few, evenly spread.
pub fn cases<T>(all: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    all.into_iter().step_by(100 / percent().min(100) as usize)
}

/// Takes every file of `proof/fuzz/corpus/<target>`.
///
/// # Panics
/// If `hold` does, which names the file; or if the corpus is not there.
pub fn each_of_corpus(target: &str, hold: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus");
    let folder = folder.join(target);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{folder:?}: {error}"));
    let paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    assert!(paths.len() > 20, "{} files in {folder:?}", paths.len());
    for path in paths {
        let data = fs::read(&path).unwrap();
        assert!(catch_unwind(|| hold(&data)).is_ok(), "with {path:?}");
    }
}
