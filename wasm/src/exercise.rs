//! Scenarios as checks of a program that somebody has written.

use crate::program::Text;
use crate::words::{self, Both, No, both};
use serde::Serialize;
use unoclp_host_sim::engine::HostEngine;
use unoclp_host_sim::scenario::{ProgramFile, Scenario, Verdict, check};
use unoclp_source::Lang;

/// What came of a check.
#[derive(Debug, Serialize)]
pub struct Outcome {
    passed: bool,
    /// What the scenario shows.
    about: String,
    /// What was not as expected, the first first.
    unmet: Vec<Unmet>,
    /// The whole of it as text, as on the command line.
    report: Both,
}

/// A place that was not as expected for a while.
#[derive(Debug, Serialize)]
struct Unmet {
    place: String,
    expected: i32,
    came: i32,
    /// ms after the first scan.
    from: u32,
    to: u32,
}

/// Runs a program against a scenario.
///
/// # Errors
/// Where there is no program, or no scenario.
pub fn exercise(text: Text, name: &str, scenario: &str) -> Result<Outcome, No> {
    let program = text.program()?;
    let file = ProgramFile {
        name: program.name,
        bytes: program.code,
    };
    let scenario = Scenario::of_text(name, scenario, file).map_err(|error| {
        both(|lang| words::no_scenario(lang, error.line.unwrap_or(0), error.text(lang)))
    })?;
    let report = check(&scenario, &mut HostEngine::default());
    let unmet = match &report.verdict {
        Verdict::Unmet(unmet) => unmet.as_slice(),
        _ => &[],
    };
    let unmet = unmet.iter().map(|unmet| Unmet {
        place: unmet.place.to_string(),
        expected: unmet.expected,
        came: unmet.came,
        from: unmet.from,
        to: unmet.to,
    });
    Ok(Outcome {
        passed: report.passed(),
        unmet: unmet.collect(),
        report: both(|lang: Lang| report.text(lang)),
        about: report.about,
    })
}
