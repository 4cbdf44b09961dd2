//! Exercises: what they ask of a student, and whether a program does it.

use crate::answer::{answer, spoken};
use crate::machine::plant;
use crate::words::{self, Both, No, both};
use std::collections::BTreeMap;
use std::path::Path;
use unoclp_core::Board;
use unoclp_draw::edit::Row;
use unoclp_exercise::diagram;
use unoclp_exercise::find::Hidden;
use unoclp_exercise::machine::{self, Ended, WentWrong, with_chances};
use unoclp_exercise::scenario::{self, Case, Exercise, ProgramFile, Verdict, grade};
use unoclp_host_sim::engine::HostEngine;
use unoclp_plant::Plant;
use unoclp_point::Address;
use unoclp_program::{Lang, Source, WrittenIn, drawn};

answer! {
    /// What an exercise says of itself.
    pub struct Sheet as "Sheet" {
        kind: Kind,
        /// The program that is to be written in another language.
        given: Option<Given>,
        /// The name of its machine's file, where it has one.
        plant: Option<String>,
        /// The board that it is for, where it names one.
        board: Option<&'static str>,
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
}

spoken! {
    /// What an exercise asks for.
    enum Kind as "ExerciseKind", word {
        /// A program.
        Program,
        /// The fault of a machine whose program is right.
        Find,
        /// The same program in another language.
        Write,
    }
}

answer! {
    /// A program that is to be written in another language.
    struct Given as "GivenProgram" {
        text: String,
        /// Its language, and the one to write it in, by the ends of the names of files.
        language: &'static str => "LanguageName",
        answer_in: &'static str => "LanguageName",
    }
}

impl From<&scenario::Given> for Given {
    fn from(given: &scenario::Given) -> Given {
        let language = WrittenIn::of(Path::new("given"), given.text.as_bytes());
        Given {
            text: given.text.clone(),
            language: language.map_or("il", WrittenIn::name),
            answer_in: given.answer_in.name(),
        }
    }
}

answer! {
    /// What a student learns of a case before its turn.
    struct Told as "Case" {
        title: Both,
        hidden: bool,
    }
}

answer! {
    /// What came of a check.
    pub struct Outcome as "Outcome" {
        passed: bool,
        /// The cases in order, and whether each was passed.
        cases: Vec<(Told, bool)>,
        failing: Option<Failing>,
        /// How the machine of the exercise fared, where it has one.
        machine: Option<Fared>,
    }
}

answer! {
    /// How a machine fared with a program.
    pub struct Fared as "Fared" {
        passed: bool,
        /// What went wrong first: when, and which rule.
        why: Option<Both>,
        /// When, ms after the first scan; none where the program did not run at all.
        at: Option<u64>,
    }
}

answer! {
    /// The first case that was not passed.
    struct Failing as "Failing" {
        /// Its place among the cases, from 0.
        case: usize,
        /// None of a hidden case.
        shown: Option<Shown>,
    }
}

answer! {
    /// What is shown of a case that was not passed.
    struct Shown as "Shown" {
        /// What was not as expected first, if it was a place.
        unmet: Option<Unmet>,
        /// Why it was not passed, in a line.
        why: Both,
        /// Its timing diagram.
        svg: Both,
    }
}

answer! {
    /// A place that was not as expected for a while.
    struct Unmet as "Unmet" {
        place: String,
        expected: i32,
        came: i32,
        /// ms after the first scan.
        from: u32,
        to: u32,
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
    let kind = match (&exercise.find, &exercise.given) {
        (Some(_), _) => Kind::Find,
        (None, Some(_)) => Kind::Write,
        (None, None) => Kind::Program,
    };
    Ok(Sheet {
        kind,
        given: exercise.given.as_ref().map(Given::from),
        plant: file.map(|name| name.to_string_lossy().into_owned()),
        board: exercise.names_board.then(|| exercise.board.id()),
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
/// Where the file of the exercise or of the machine is wrong.
pub fn exercise(
    source: &Source,
    name: &str,
    scenario: &str,
    machine: Option<(String, String)>,
) -> Result<Outcome, No> {
    let board = source.board();
    let exercise = read(name, scenario, board)?;
    if let Some(given) = &exercise.given
        && given.answer_in != source.language.written_in()
    {
        let language = given.answer_in.name();
        return Err(both(|lang| words::other_language(lang, language)).into());
    }
    let program = ProgramFile {
        name: source.name.clone(),
        bytes: source.code.clone(),
    };
    let machine = match machine {
        Some((name, text)) => {
            let plant = plant(&name, &text, board)?;
            Some(fared(&plant, &exercise.seeds, &program.bytes))
        }
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

/// How the machine fares with this program; of chances that are hidden nothing is told but that they are.
fn fared(plant: &Plant, seeds: &[u32], program: &[u8]) -> Fared {
    let engine = &mut HostEngine::new(plant.board);
    let (why, at) = match with_chances(plant, seeds, program, engine) {
        Ok(None) => (None, None),
        Ok(Some(WentWrong {
            hidden: Some(_), ..
        })) => (Some(both(words::hidden_chances)), None),
        Ok(Some(WentWrong { first, .. })) => {
            let why = both(|lang| first.text(plant, lang));
            (Some(why), Some(first.at()))
        }
        Err(ended) => {
            let at = match &ended {
                Ended::Stopped(at, _) => Some(*at),
                Ended::Refused(_) | Ended::Broken(_) => None,
            };
            (Some(both(|lang| ended.text(lang))), at)
        }
    };
    Fared {
        passed: why.is_none(),
        why,
        at,
    }
}

/// Whether a program does what the rules of a machine ask, through its script.
///
/// # Errors
/// Where there is no machine.
pub fn trial(source: &Source, name: &str, machine: &str) -> Result<Fared, No> {
    let plant = plant(name, machine, source.board())?;
    Ok(fared(&plant, &[], &source.code))
}

/// A number for all that a machine is with a program in each of so many ms: the same everywhere.
///
/// # Errors
/// Where there is no machine, or the program ends before.
pub fn trace(source: &Source, name: &str, machine: &str, span: u64) -> Result<String, No> {
    let plant = plant(name, machine, source.board())?;
    let traced = machine::trace(
        &plant,
        &source.code,
        &mut HostEngine::new(plant.board),
        span,
    );
    let traced = traced.map_err(|ended| both(|lang| ended.text(lang)))?;
    Ok(format!("{traced:016x}"))
}

/// The fault that an exercise hides in a machine.
///
/// # Errors
/// Where its file is wrong, or hides none.
pub fn hidden(scenario: &str, board: Board) -> Result<Hidden, No> {
    let exercise = read("find.toml", scenario, board)?;
    exercise.find.ok_or_else(|| both(words::no_find).into())
}

/// The exercise of a file.
///
/// # Errors
/// What is wrong with it, with its line.
pub fn read(name: &str, text: &str, board: Board) -> Result<Exercise, No> {
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
        svg: both(|lang| diagram::column(&[run], &exercise.names, lang)),
    }
}
