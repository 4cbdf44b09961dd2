//! Scenarios: a program, inputs over time, and what is expected over time of outputs and memory, or
//! the fault expected.
//!
//! A scenario is a case of a TOML file, read by [`Scenario::load`], or for another program by [`Scenario::load_for`].
//! [`check`] runs it on any [`Engine`] and gives a [`Report`]. Because the same files run on every engine, adding a case
//! is adding a file. A file as a whole is an [`Exercise`]; [`grade`] says how a program does in all of its cases.

mod alike;
mod both;
mod check;
mod equivalent;
mod exercise;
mod file;
mod grade;
mod keys;
mod place;
mod plan;
mod program;
mod report;
mod shown;
mod timeline;
mod within;
mod words;
mod wrong;

pub use alike::Given;
pub use both::Both;
pub use check::check;
pub use equivalent::Equivalent;
pub use exercise::{Case, Exercise};
pub use grade::{Failing, Grade, grade, passes};
pub use place::Place;
pub use plan::{Course, Plan};
pub use program::{LONGEST, ProgramFile, Unreadable};
pub use report::{Change, Columns, Report, Unmet, Verdict};
pub use wrong::{LoadError, Wrong};

use std::num::NonZeroU32;
use unoclp_core::{Board, Millis, Point};
#[cfg(doc)]
use unoclp_host_sim::engine::Engine;
use unoclp_host_sim::engine::{Cell, Refusal};
use unoclp_program::Lang;

/// A scenario whose file has passed every check: the points exist on the board, and the steps
/// stand in rising order, each at the time of a scan.
#[derive(Clone, Debug)]
pub struct Scenario {
    name: String,
    about: Both,
    program: ProgramFile,
    goal: Goal,
}

/// What a scenario shows about its program.
#[derive(Clone, Debug)]
enum Goal {
    /// It runs, and does this.
    Run(Timeline),
    /// It is refused so.
    Refusal(Refusal),
}

/// The most scans that a file may ask for, in all its cases: 33 minutes of scans each millisecond. So whatever a file
/// says, running it comes to an end.
pub const MOST_SCANS: u64 = 2_000_000;

/// The scans of a run, what they see and what they must give.
#[derive(Clone, Debug)]
struct Timeline {
    /// Reading of the millisecond clock at the first scan.
    start: Millis,
    /// ms from scan to scan.
    period: NonZeroU32,
    /// In rising order of their times.
    steps: Vec<Step>,
    /// No scan comes after this time, in ms after the first scan.
    until: Millis,
    /// The fault that the run ends in; its scan is then the last.
    stop: Option<Stop>,
    /// The board whose points it names.
    board: Board,
}

/// A fault at run time.
#[derive(Clone, Copy, Debug)]
struct Stop {
    /// The scan, in ms after the first.
    at: Millis,
    refusal: Refusal,
}

/// What changes at one moment of a scenario.
#[derive(Clone, Debug)]
struct Step {
    /// ms after the first scan.
    at: Millis,
    /// Whether the power is cut before all else.
    restart: bool,
    /// What is set before this scan.
    set: Vec<Setting>,
    /// Places, and the value that each scan from this one on must give them; none: any.
    expect: Vec<(Place, Option<i32>)>,
}

/// What a step sets.
#[derive(Clone, Copy, Debug)]
enum Setting {
    /// An input has this state from this scan on.
    Input(Point, bool),
    /// The analogue input with this number, from 0, reads so from this scan on.
    Analogue(u8, u16),
    /// A cell is given this value once.
    Cell(Cell, i32),
}

impl Step {
    /// One in which nothing happens.
    fn at(at: Millis) -> Step {
        Step {
            at,
            restart: false,
            set: Vec::new(),
            expect: Vec::new(),
        }
    }

    /// Whether the step needs a board that stands still between its scans: it looks into memory, sets
    /// it, or reads a voltage.
    fn holds_still(&self) -> bool {
        let outside = |setting: &Setting| matches!(setting, Setting::Input(..));
        let output = |(place, _): &(Place, _)| place.output().is_some();
        self.restart || !self.set.iter().all(outside) || !self.expect.iter().all(output)
    }
}

impl Scenario {
    /// The path of the scenario's file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// One sentence on what the scenario shows.
    pub fn about(&self, lang: Lang) -> &str {
        self.about.text(lang)
    }

    /// The program that the scenario is about.
    pub fn program(&self) -> &ProgramFile {
        &self.program
    }

    /// How long the run takes from the first scan to the last, in ms; 0 where nothing runs.
    pub fn duration(&self) -> Millis {
        match &self.goal {
            Goal::Refusal(_) => 0,
            Goal::Run(timeline) => timeline.until,
        }
    }

    /// Whether the scenario looks into memory, sets it or uses analogue inputs, and so can be run only
    /// where the scans are those of the scenario and no others.
    pub fn is_for_lockstep(&self) -> bool {
        match &self.goal {
            Goal::Refusal(_) => false,
            Goal::Run(timeline) => timeline.steps.iter().any(Step::holds_still),
        }
    }

    /// The refusal that the scenario expects; none where the program must run.
    pub fn expected_refusal(&self) -> Option<Refusal> {
        match self.goal {
            Goal::Refusal(refusal) => Some(refusal),
            Goal::Run(_) => None,
        }
    }
}

/// The points 01 to this number.
pub fn points(count: u8) -> impl Iterator<Item = Point> {
    (1..=count).filter_map(move |number| Point::new(number, count))
}
