//! Exercises: what they ask of a student, and whether a program does it.

use crate::machine::plant;
use crate::program::Text;
use crate::words::{self, Both, No, both};
use serde::Serialize;
use std::collections::BTreeMap;
use unoclp_core::Board;
use unoclp_draw::edit::Row;
use unoclp_exercise::diagram;
use unoclp_exercise::machine::first_wrong;
use unoclp_exercise::scenario::{self, Case, Exercise, ProgramFile, Verdict, grade};
use unoclp_host_sim::engine::HostEngine;
use unoclp_plant::Plant;
use unoclp_point::Address;
use unoclp_program::{Lang, drawn};

/// What an exercise says of itself.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Sheet {
    /// The name of its machine's file, where it has one.
    plant: Option<String>,
    title: Both,
    task: Option<Both>,
    hints: Vec<Both>,
    /// What is connected to the points.
    names: BTreeMap<String, Both>,
    /// The inputs, from 1, whose buttons are normally closed.
    normally_closed: Vec<u8>,
    /// A text in Instruction List that names what is connected, and has no instruction yet.
    begin: Both,
    cases: Vec<Told>,
}

/// What a student learns of a case before its turn.
#[derive(Debug, Serialize)]
struct Told {
    title: Both,
    hidden: bool,
}

/// What came of a check.
#[derive(Debug, Serialize)]
pub struct Outcome {
    passed: bool,
    /// The cases in order, and whether each was passed.
    cases: Vec<(Told, bool)>,
    failing: Option<Failing>,
    /// How the machine of the exercise fared, where it has one.
    machine: Option<Fared>,
}

/// How a machine fared with a program.
#[derive(Debug, Serialize)]
struct Fared {
    passed: bool,
    /// What went wrong first: when, and which rule.
    why: Option<Both>,
}

/// The first case that was not passed.
#[derive(Debug, Serialize)]
struct Failing {
    /// Its place among the cases, from 0.
    case: usize,
    /// None of a hidden case.
    shown: Option<Shown>,
}

/// What is shown of a case that was not passed.
#[derive(Debug, Serialize)]
struct Shown {
    /// What was not as expected first, if it was a place.
    unmet: Option<Unmet>,
    /// Why it was not passed, in a line.
    why: Both,
    /// Its timing diagram.
    svg: Both,
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

impl From<&scenario::Both> for Both {
    fn from(told: &scenario::Both) -> Both {
        both(|lang| told.text(lang).to_owned())
    }
}

impl From<&Case> for Told {
    fn from(case: &Case) -> Told {
        Told {
            title: (&case.title).into(),
            hidden: case.hidden,
        }
    }
}

/// What an exercise asks.
///
/// # Errors
/// Where the file is wrong.
pub fn sheet(name: &str, text: &str, board: Board) -> Result<Sheet, No> {
    let exercise = read(name, text, board)?;
    let names = exercise.names.iter();
    let file = exercise.plant.as_ref().and_then(|file| file.file_name());
    Ok(Sheet {
        plant: file.map(|name| name.to_string_lossy().into_owned()),
        title: (&exercise.title).into(),
        task: exercise.task.as_ref().map(Both::from),
        hints: exercise.hints.iter().map(Both::from).collect(),
        names: names
            .map(|(point, name)| (point.clone(), name.into()))
            .collect(),
        normally_closed: exercise.normally_closed.clone(),
        begin: both(|lang| begin(&exercise, lang)),
        cases: exercise.cases().iter().map(Told::from).collect(),
    })
}

/// A text in Instruction List that names what is connected, and has no instruction yet.
fn begin(exercise: &Exercise, lang: Lang) -> String {
    let mut rows: BTreeMap<Address, Row> = BTreeMap::new();
    for (point, words) in &exercise.names {
        let comment = words.text(lang);
        let Some(point) = Address::parse(point) else {
            continue;
        };
        let taken = |name: &String| rows.values().any(|row| row.name == *name);
        let name = drawn::name_of(comment).filter(|name| !taken(name));
        let numbered = || drawn::name_of(&format!("{} {}", comment.split('(').next()?, point));
        if let Some(name) = name.or_else(numbered) {
            let comment = comment.to_owned();
            rows.insert(point, Row { name, comment });
        }
    }
    let rows = rows.iter().map(|(point, row)| (*point, row));
    drawn::blank_text(exercise.title.text(lang), rows)
}

/// Runs a program through the cases of an exercise, and through the script of its machine.
///
/// # Errors
/// Where there is no program, or the file of the exercise or of the machine is wrong.
pub fn exercise(
    text: Text,
    name: &str,
    scenario: &str,
    machine: Option<(String, String)>,
) -> Result<Outcome, No> {
    let board = text.board;
    let program = text.program()?;
    let program = ProgramFile {
        name: program.name,
        bytes: program.code,
    };
    let exercise = read(name, scenario, board)?;
    let machine = match machine {
        Some((name, text)) => Some(fared(&plant(&name, &text, board)?, &program.bytes)),
        None => None,
    };
    let grade = grade(&exercise, &program, &mut HostEngine::new(board));
    let cases = exercise.cases();
    Ok(Outcome {
        passed: grade.is_passed() && machine.as_ref().is_none_or(|machine| machine.passed),
        machine,
        cases: cases.iter().map(Told::from).zip(grade.passed).collect(),
        failing: grade.failing.map(|failing| Failing {
            case: failing.case,
            shown: (!cases[failing.case].hidden).then(|| shown(&failing, &exercise)),
        }),
    })
}

/// How the machine fares with this program.
fn fared(plant: &Plant, program: &[u8]) -> Fared {
    let engine = &mut HostEngine::new(plant.board);
    let why = match first_wrong(plant, plant.seed, program, engine) {
        Ok(first) => first.map(|first| both(|lang| first.text(plant, lang))),
        Err(ended) => Some(both(|lang| ended.text(lang))),
    };
    Fared {
        passed: why.is_none(),
        why,
    }
}

fn read(name: &str, text: &str, board: Board) -> Result<Exercise, No> {
    let told = |error: scenario::LoadError| {
        both(|lang| words::no_scenario(lang, error.line.unwrap_or(0), error.text(lang)))
    };
    Exercise::of_text(name, text, board).map_err(|error| told(error).into())
}

fn shown(failing: &scenario::Failing, exercise: &Exercise) -> Shown {
    let scenario::Failing {
        scenario, report, ..
    } = failing;
    let unmet = match &report.verdict {
        Verdict::Unmet(unmet) => unmet.first(),
        _ => None,
    };
    let run = diagram::Run { scenario, report };
    Shown {
        unmet: unmet.map(|unmet| Unmet {
            place: unmet.place.to_string(),
            expected: unmet.expected,
            came: unmet.came,
            from: unmet.from,
            to: unmet.to,
        }),
        why: both(|lang| report.verdict.brief(lang)),
        svg: both(|lang| diagram::svg(&[run], &exercise.names, lang)),
    }
}
