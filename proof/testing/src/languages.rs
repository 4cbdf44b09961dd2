//! The programs of `programs/languages`, each of which stands in several languages beside one scenario.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Without timers and loops, which InterSCL and LCE do not have in common with the others.
const IN_FIVE: [&str; 6] = ["average", "forward", "overload", "parts", "tank", "voting"];
/// With timers, loops and REAL.
const IN_THREE: [&str; 6] = [
    "dosing",
    "oven",
    "pressure",
    "spread",
    "stardelta",
    "volume",
];
/// How the files end: numeric code, Structured Text, Instruction List, InterSCL, LCE.
const ENDS: [&str; 5] = ["txt", "st", "il", "iscl", "lce"];

/// A program in several languages.
#[derive(Clone, Debug)]
pub struct Twins {
    /// What its files are called.
    pub name: &'static str,
    folder: PathBuf,
    ends: &'static [&'static str],
}

impl Twins {
    /// The text in the language whose files end so.
    pub fn text(&self, end: &str) -> PathBuf {
        self.folder.join(format!("{}.{end}", self.name))
    }

    /// The scenario that each text passes.
    pub fn scenario(&self) -> PathBuf {
        self.text("toml")
    }

    /// All its texts, the numeric code first.
    pub fn texts(&self) -> impl Iterator<Item = PathBuf> {
        self.ends.iter().map(|end| self.text(end))
    }
}

/// All of these programs.
///
/// # Panics
/// If the folder lacks one of their files, or has another.
pub fn in_languages() -> Vec<Twins> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/languages");
    let twins = |ends| {
        let folder = folder.clone();
        move |name| Twins {
            name,
            folder: folder.clone(),
            ends,
        }
    };
    let five = IN_FIVE.into_iter().map(twins(&ENDS[..]));
    let all: Vec<Twins> = five
        .chain(IN_THREE.into_iter().map(twins(&ENDS[..3])))
        .collect();
    let due = all.iter().flat_map(|twins| {
        let texts = twins.texts().collect::<Vec<_>>();
        texts.into_iter().chain([twins.scenario()])
    });
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{folder:?}: {error}"));
    let there = entries.map(|entry| entry.unwrap().path());
    assert_eq!(there.collect::<BTreeSet<_>>(), due.collect::<BTreeSet<_>>());
    all
}
