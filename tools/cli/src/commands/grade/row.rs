//! The result of a program.

use super::super::plant::what_first;
use super::super::wording::Wording;
use super::course::{Course, Task};
use super::handin::{HandIn, Student};
use crate::messages;
use annotate_snippets::Renderer;
use std::path::Path;
use unoclp_exercise::diagram;
use unoclp_exercise::find::{Answer, Hidden};
use unoclp_exercise::scenario::{Exercise, Failing, ProgramFile, Verdict, grade};
use unoclp_host_sim::engine::HostEngine;
use unoclp_lang::{self as lang, Lines, Severity, Told};
use unoclp_program::{NoProgram, Refused, Source, Written, WrittenIn, diagnosis, list, shown};
use unoclp_workspace::Analysis;

/// Columns of a ladder beside the text of a page.
const WIDTH: usize = 80;

/// How a program does.
pub struct Row<'c> {
    /// Its file.
    pub file: String,
    /// Who has handed it in, where the file says so.
    pub student: Option<Student>,
    /// The exercise that it was graded in; none where that is not known.
    pub task: Option<&'c Task>,
    /// The program itself, where it is one.
    pub work: Option<Work>,
    /// How many cases it passed.
    pub passed: usize,
    /// Why it did not pass all of them.
    pub fail: Option<Fail>,
    /// What went wrong first with the machine, where the exercise has one; nothing, where all was well.
    pub machine: Option<String>,
    /// How many faults an answer names, where one is to be found.
    pub tries: Option<u32>,
}

/// A program as a teacher looks at it.
pub enum Work {
    /// As a ladder diagram, an SVG document.
    Ladder(String),
    /// As its text.
    Text(String),
}

/// Why a program did not pass.
#[derive(Debug)]
pub struct Fail {
    /// The first case that it did not pass; of one that does not compile, that.
    pub case: String,
    /// Why, in a line.
    pub why: String,
    /// What shows it.
    pub shown: Shown,
}

/// What shows why a program did not pass.
#[derive(Debug)]
pub enum Shown {
    /// The run, to be drawn.
    Run(Box<Failing>),
    /// An excerpt of its text.
    Excerpt(String),
}

impl Shown {
    /// The timing diagram, where there was a run.
    pub fn diagram(&self, exercise: &Exercise) -> Option<String> {
        let Shown::Run(failing) = self else {
            return None;
        };
        let Failing {
            scenario, report, ..
        } = &**failing;
        let run = diagram::Run { scenario, report };
        Some(diagram::svg(&[run], &exercise.names, messages::spoken()))
    }
}

impl<'c> Row<'c> {
    /// That of a file that cannot be read.
    pub fn unreadable(path: &Path, why: String) -> Row<'c> {
        Row::refused(shown(path), why, String::new())
    }

    /// That of a file that cannot be graded, whatever is in it.
    fn not_graded(path: &Path, why: String) -> Row<'c> {
        let mut row = Row::unreadable(path, why);
        if let Some(fail) = &mut row.fail {
            fail.case = messages::not_graded();
        }
        row.machine = Some(messages::not_graded());
        row
    }

    /// That of a program, which says no exercise: there has to be one alone.
    pub fn of_program(file: ProgramFile, wording: &Wording, course: &'c Course) -> Row<'c> {
        let ProgramFile { name, bytes } = file;
        match course.only() {
            Some(task) => Row::of(name, bytes, wording, task),
            None => {
                let path = Path::new(&name).to_owned();
                Row::not_graded(&path, messages::which_exercise())
            }
        }
    }

    /// That of what was handed in. It says its exercise; all else is found out anew.
    pub fn of_hand_in(path: &Path, wording: &Wording, course: &'c Course) -> Row<'c> {
        let HandIn {
            student,
            exercise,
            name,
            text,
        } = match HandIn::read(path) {
            Ok(hand_in) => hand_in,
            Err(why) => return Row::not_graded(path, why),
        };
        let mut row = match course.named(&exercise) {
            Some(task) => Row::of(name, text.into_bytes(), wording, task),
            None => Row::not_graded(path, messages::other_exercise(&exercise)),
        };
        row.file = shown(path);
        row.student = Some(student);
        row
    }

    /// Whether it was graded in this exercise.
    pub fn is_of(&self, task: &Task) -> bool {
        self.task.is_some_and(|own| std::ptr::eq(own, task))
    }

    /// What a table calls it.
    pub fn who(&self) -> &str {
        self.student.as_ref().map_or(&self.file, |it| &it.name)
    }

    /// How many cases there are.
    pub fn cases(&self) -> usize {
        self.task.map_or(0, |task| task.exercise.cases().len())
    }

    /// What it is worth, of 100: the share of the cases that it passed, where the machine counts as one of them.
    pub fn points(&self) -> usize {
        let has_machine = self.task.is_some_and(|task| task.plant.is_some());
        let passed = self.passed + usize::from(has_machine && self.machine.is_none());
        let of = self.cases() + usize::from(has_machine);
        (passed * 100).checked_div(of).unwrap_or_default()
    }

    /// Whether the file says that it passed, and it does not.
    pub fn is_boast(&self) -> bool {
        let says = self.student.as_ref().is_some_and(|it| it.says_passed);
        says && !self.is_passed()
    }

    /// That of a program, which is compiled and run through all cases.
    fn of(name: String, bytes: Vec<u8>, wording: &Wording, task: &'c Task) -> Row<'c> {
        let wording = wording.on(task.exercise.board);
        let analysis = wording.workspace().open(wording.of(name, bytes));
        Row {
            task: Some(task),
            ..Row::came(&analysis, task)
        }
    }

    fn came(analysis: &Analysis, task: &'c Task) -> Row<'c> {
        let Task {
            exercise, plant, ..
        } = task;
        let board = exercise.board;
        if let Some(hidden) = &exercise.find {
            return Row::of_answer(analysis.written(), hidden);
        }
        let source = match analysis.check() {
            Some(Ok(source)) => source,
            Some(Err(refused)) => return Row::of_refused(refused),
            None => return Row::no_program(analysis.written().name.clone(), NoProgram::Other),
        };
        if let Some(given) = &exercise.given
            && given.answer_in != source.language.written_in()
        {
            let why = messages::other_language(given.answer_in.name());
            return Row::refused(source.name.clone(), why, String::new());
        }
        let program = ProgramFile {
            name: source.name.clone(),
            bytes: source.code.clone(),
        };
        let grade = grade(exercise, &program, &mut HostEngine::new(board));
        Row {
            student: None,
            task: None,
            work: Some(Work::of(source)),
            machine: plant
                .as_ref()
                .and_then(|plant| what_first(plant, &exercise.seeds, &program.bytes, board)),
            passed: grade.count(),
            tries: None,
            fail: grade.failing.map(|failing| Fail {
                case: failing.scenario.about(messages::spoken()).to_owned(),
                why: why(&failing.report.verdict, source),
                shown: Shown::Run(Box::new(failing)),
            }),
            file: source.name.clone(),
        }
    }

    /// That of an answer: which part of the machine fails, and how.
    fn of_answer(written: &Written, hidden: &Hidden) -> Row<'c> {
        let answer = Answer::of(&String::from_utf8_lossy(&written.bytes), hidden);
        let machine = match answer {
            Answer { is_found: true, .. } => None,
            Answer { tries: 0, .. } => Some(messages::names_no_fault()),
            Answer { tries, .. } => Some(messages::fault_not_found(tries)),
        };
        Row {
            file: written.name.clone(),
            student: None,
            task: None,
            work: None,
            passed: 0,
            fail: None,
            machine,
            tries: Some(answer.tries),
        }
    }

    fn of_refused(refused: &Refused) -> Row<'c> {
        let (renderer, speak) = (Renderer::plain(), messages::spoken());
        match refused {
            Refused::NoProgram { name, why } => Row::no_program(name.clone(), *why),
            Refused::Numeric { written, faults } => {
                let Written { name, bytes, .. } = &**written;
                let why = faults.first().map(|fault| {
                    let told = diagnosis::tell(bytes, fault, speak);
                    in_line(told.line.unwrap_or(1) as usize, told.message)
                });
                let excerpt = diagnosis::show(name, bytes, faults, speak, &renderer);
                Row::refused(name.clone(), why.unwrap_or_default(), excerpt)
            }
            Refused::Text {
                name,
                text,
                diagnostics,
            } => {
                let why = first_error(text, diagnostics);
                let excerpt = lang::show(name, text, diagnostics, speak, &renderer);
                Row::refused(name.clone(), why, excerpt)
            }
        }
    }

    fn no_program(name: String, why: NoProgram) -> Row<'c> {
        let why = match why {
            NoProgram::Empty => messages::file_empty(),
            NoProgram::Binary => messages::file_binary(),
            NoProgram::Other => messages::file_other(),
        };
        Row::refused(name, why, String::new())
    }

    fn refused(file: String, why: String, excerpt: String) -> Row<'c> {
        Row {
            file,
            student: None,
            task: None,
            work: None,
            passed: 0,
            tries: None,
            machine: Some(messages::not_compiled()),
            fail: Some(Fail {
                case: messages::not_compiled(),
                why,
                shown: Shown::Excerpt(excerpt),
            }),
        }
    }

    /// Whether it passed all cases, and did what the machine asks.
    pub fn is_passed(&self) -> bool {
        self.fail.is_none() && self.machine.is_none()
    }
}

impl Work {
    /// Whoever draws, or writes what is a ladder line by line, sees that again; the others see their text.
    fn of(source: &Source) -> Work {
        match source.language.written_in() {
            WrittenIn::Il | WrittenIn::Numeric | WrittenIn::Xml => {
                Work::Ladder(list::svg(source, WIDTH, messages::spoken()))
            }
            WrittenIn::Typed(_) => Work::Text(source.text.clone()),
        }
    }
}

/// Why a case was not passed, in a line; a fault in the line of the text that has it.
fn why(verdict: &Verdict, source: &Source) -> String {
    let fault = match verdict {
        Verdict::WrongStop {
            came: Some((_, refusal)),
            ..
        } => refusal.fault(),
        _ => None,
    };
    let told = fault.and_then(|fault| {
        let (line, _) = source.line_of(fault.line?)?;
        Some(in_line(line, messages::fault(fault.cause)))
    });
    told.unwrap_or_else(|| verdict.reason(messages::spoken()))
}

/// The first error of a text, with its line.
fn first_error(text: &str, told: &Told) -> String {
    let error = told.iter().find(|one| one.severity() == Severity::Error);
    error.map_or_else(String::new, |error| {
        let (line, _) = Lines::new(text).place(text, error.span.start);
        in_line(line as usize, error.message(messages::spoken()))
    })
}

fn in_line(line: usize, message: impl std::fmt::Display) -> String {
    messages::in_line(line, message)
}
