//! How a program does in an exercise.

use super::{Exercise, ProgramFile, Report, Scenario, check};
use unoclp_host_sim::engine::Engine;

/// How a program does in all cases of an exercise.
#[derive(Clone, Debug)]
pub struct Grade {
    /// Whether it passed each case, in the order of the file.
    pub passed: Vec<bool>,
    /// The first case that it did not pass.
    pub failing: Option<Failing>,
}

/// A case that a program did not pass.
#[derive(Clone, Debug)]
pub struct Failing {
    /// Its place among the cases, from 0.
    pub case: usize,
    /// The case with the program.
    pub scenario: Scenario,
    /// What came of it.
    pub report: Report,
}

impl Grade {
    /// Whether the program passed every case.
    pub fn is_passed(&self) -> bool {
        self.failing.is_none()
    }

    /// How many cases it passed.
    pub fn count(&self) -> usize {
        self.passed.iter().filter(|passed| **passed).count()
    }
}

/// Whether a program passes every case. It is run up to the first that it does not pass.
pub fn passes<E: Engine>(exercise: &Exercise, program: &ProgramFile, engine: &mut E) -> bool {
    let mut all = exercise.scenarios(program).into_iter();
    all.all(|scenario| check(&scenario, engine).passed())
}

/// Runs a program through every case, whether or not it passes those before.
pub fn grade<E: Engine>(exercise: &Exercise, program: &ProgramFile, engine: &mut E) -> Grade {
    let mut grade = Grade {
        passed: Vec::new(),
        failing: None,
    };
    for (case, scenario) in exercise.scenarios(program).into_iter().enumerate() {
        let report = check(&scenario, engine);
        grade.passed.push(report.passed());
        if grade.failing.is_none() && !report.passed() {
            grade.failing = Some(Failing {
                case,
                scenario,
                report,
            });
        }
    }
    grade
}
