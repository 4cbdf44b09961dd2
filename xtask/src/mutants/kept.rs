//! What has become of mutants, run after run: a run that is stopped goes on where it was, and one that comes later tries
//! again what no test has noticed.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};

/// A mutant, as cargo-mutants lists it.
#[derive(Deserialize)]
pub struct Mutant {
    pub name: String,
}

/// What has become of a mutant, in the words of cargo-mutants.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Fate {
    #[serde(rename = "CaughtMutant")]
    Noticed,
    #[serde(rename = "Timeout")]
    TooLong,
    #[serde(rename = "Unviable")]
    DoesNotCompile,
    #[serde(rename = "MissedMutant")]
    Missed,
    /// The run itself failed, or this was no mutant.
    #[serde(other)]
    Unknown,
}

#[derive(Deserialize)]
struct Outcomes {
    outcomes: Vec<Outcome>,
}

#[derive(Deserialize)]
struct Outcome {
    scenario: Scenario,
    summary: Fate,
}

#[derive(Deserialize)]
enum Scenario {
    Baseline,
    Mutant(Mutant),
}

/// The fates of the mutants of a room, in a file.
pub struct Kept {
    path: PathBuf,
    fates: BTreeMap<String, Fate>,
}

impl Kept {
    /// What earlier runs have kept in this file; nothing if it is to begin again.
    ///
    /// # Errors
    /// If the file is no such file.
    pub fn of(path: PathBuf, again: bool) -> Result<Self> {
        let text = if again {
            None
        } else {
            fs::read_to_string(&path).ok()
        };
        let read = text.map(|text| serde_json::from_str(&text)).transpose();
        let fates = read.with_context(|| format!("{}", path.display()))?;
        Ok(Self {
            path,
            fates: fates.unwrap_or_default(),
        })
    }

    /// Takes what a run has written, to its end or not, and removes that file.
    ///
    /// # Errors
    /// If it is no such file, or what was kept cannot be written.
    pub fn take(&mut self, result: &Path) -> Result<()> {
        let Ok(text) = fs::read_to_string(result) else {
            return Ok(());
        };
        self.add(&text)?;
        let text = serde_json::to_string_pretty(&self.fates)?;
        fs::write(&self.path, text).with_context(|| format!("{}", self.path.display()))?;
        fs::remove_file(result).with_context(|| format!("{}", result.display()))
    }

    fn add(&mut self, text: &str) -> Result<()> {
        let read: Outcomes = serde_json::from_str(text).context("outcomes of mutants")?;
        for outcome in read.outcomes {
            if let (Scenario::Mutant(mutant), fate) = (outcome.scenario, outcome.summary)
                && fate != Fate::Unknown
            {
                self.fates.insert(mutant.name, fate);
            }
        }
        Ok(())
    }

    /// What has become of a mutant, if it was tried.
    pub fn fate(&self, mutant: &Mutant) -> Option<Fate> {
        self.fates.get(&mutant.name).copied()
    }

    /// Whether a mutant is to be tried, or tried again.
    pub fn is_open(&self, mutant: &Mutant) -> bool {
        matches!(self.fate(mutant), None | Some(Fate::Missed))
    }
}

/// A mutant's name without its file, line and column.
pub fn without_line(name: &str) -> &str {
    name.split_once(": ").map_or(name, |(_, what)| what)
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// Fates as a run tells them.
    pub fn kept(fates: &[(&str, &str)]) -> Kept {
        let mut kept = Kept {
            path: PathBuf::new(),
            fates: BTreeMap::new(),
        };
        let outcomes = fates.iter().map(|(name, fate)| {
            serde_json::json!({"scenario": {"Mutant": {"name": name}}, "summary": fate})
        });
        let baseline = serde_json::json!({"scenario": "Baseline", "summary": "Success"});
        let all: Vec<_> = [baseline].into_iter().chain(outcomes).collect();
        let text = serde_json::json!({ "outcomes": all }).to_string();
        kept.add(&text).expect("outcomes");
        kept
    }

    #[test]
    fn what_a_test_has_noticed_is_not_tried_again() {
        let kept = kept(&[
            ("a", "CaughtMutant"),
            ("b", "MissedMutant"),
            ("c", "Failure"),
        ]);
        let is_open = |name: &str| kept.is_open(&Mutant { name: name.into() });
        assert_eq!(["a", "b", "c"].map(is_open), [false, true, true]);
    }
}
