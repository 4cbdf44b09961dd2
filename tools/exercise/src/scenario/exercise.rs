//! What a scenario file asks of somebody who writes a program: an exercise, and the cases that show whether it is done.
//!
//! Owns what an exercise says of itself, and which of it a file may leave out. Must not know how a case runs, nor what is
//! shown of it.

use super::keys::{CaseKeys, FaultKeys, FileKeys, Slip, slip};
use super::timeline::{Rhythm, known_fault};
use super::{Both, Equivalent, Given, Goal, Place, ProgramFile, Scenario, Wrong};
use crate::find::Hidden;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use toml::Spanned;
use unoclp_core::Board;
use unoclp_host_sim::engine::Refusal;

/// A machine has no more runs with hidden chances.
const MOST_SEEDS: usize = 20;

/// A scenario file whose every value has passed its checks.
#[derive(Clone, Debug)]
pub struct Exercise {
    /// The path of the file.
    pub name: String,
    /// The board that its points are of: the one it names, or else the one it was read for.
    pub board: Board,
    /// Whether it names one.
    pub names_board: bool,
    /// What it is called; what the scenario shows, where the file has no title.
    pub title: Both,
    /// What the program shall do; none in a file that is a test alone.
    pub task: Option<Both>,
    /// What helps, from the first push to almost all.
    pub hints: Vec<Both>,
    /// What is connected to each point: `I1`, `A0`, `Q4` …
    pub names: BTreeMap<String, Both>,
    /// The inputs, from 1, whose buttons are normally closed: they open as somebody presses them.
    pub normally_closed: Vec<u8>,
    /// The changes of that program that make no wrong one.
    pub equivalent: Vec<Equivalent>,
    /// The file of a program that passes, where one is named.
    pub program: Option<PathBuf>,
    /// The file of the machine that a program controls, where one is named.
    pub plant: Option<PathBuf>,
    /// What chance begins with in further runs of the machine, which a student does not see.
    pub seeds: Vec<u32>,
    /// The program that is to be written in another language, where one is given.
    pub given: Option<Given>,
    /// The fault that is to be found, where that is the task.
    pub find: Option<Hidden>,
    cases: Vec<Case>,
}

/// A run of an exercise.
#[derive(Clone, Debug)]
pub struct Case {
    /// What it shows.
    pub title: Both,
    /// Whether a student learns its title alone.
    pub hidden: bool,
    goal: Goal,
}

impl Exercise {
    /// The cases, at least one but where a fault is to be found.
    pub fn cases(&self) -> &[Case] {
        &self.cases
    }

    /// Each case with this program.
    pub fn scenarios(&self, program: &ProgramFile) -> Vec<Scenario> {
        let scenario = |case: &Case| Scenario {
            name: self.name.clone(),
            about: case.title.clone(),
            program: program.clone(),
            goal: case.goal.clone(),
        };
        self.cases.iter().map(scenario).collect()
    }

    /// That of a file of this name, in this folder.
    pub(super) fn of_keys(
        name: &str,
        keys: &FileKeys,
        folder: &Path,
        usual: Board,
    ) -> Result<Exercise, Slip> {
        let board = keys.board(usual)?;
        let about = keys.about.as_deref().map(Both::same);
        let Some(title) = keys.title.clone().or_else(|| about.clone()) else {
            return Err(slip(None, Wrong::NoTitle));
        };
        for point in keys.names.keys() {
            if !is_point(point.get_ref(), board) {
                let name = point.get_ref().clone();
                return Err(slip(
                    Some(point.span()),
                    Wrong::NotNamed {
                        name,
                        board: board.into(),
                    },
                ));
            }
        }
        let closed = keys.normally_closed.iter().map(|input| {
            let name = input.get_ref().clone();
            let number = (1..=board.inputs).find(|number| format!("I{number}") == name);
            number.ok_or_else(|| {
                slip(
                    Some(input.span()),
                    Wrong::NotNamed {
                        name,
                        board: board.into(),
                    },
                )
            })
        });
        let names = keys.names.iter();
        let program = keys.program.as_ref();
        let given = Given::of_keys(keys, board)?;
        if let (Some(find), None) = (&keys.find, &keys.plant) {
            return Err(slip(Some(find.span()), Wrong::FindWithout));
        }
        if let (Some(seeds), None) = (&keys.seeds, &keys.plant) {
            return Err(slip(Some(seeds.span()), Wrong::SeedsWithout));
        }
        let seeds = keys.seeds.as_ref().map(Spanned::get_ref);
        if let (Some(place), Some(true)) = (&keys.seeds, seeds.map(|all| all.len() > MOST_SEEDS)) {
            return Err(slip(
                Some(place.span()),
                Wrong::ManySeeds { most: MOST_SEEDS },
            ));
        }
        Ok(Exercise {
            seeds: seeds.cloned().unwrap_or_default(),
            name: name.to_owned(),
            board,
            names_board: keys.board.is_some(),
            cases: cases(
                keys,
                about.as_ref().unwrap_or(&title),
                board,
                given.as_ref(),
            )?,
            title,
            task: keys.task.clone(),
            hints: keys.hints.clone(),
            names: names
                .map(|(point, name)| (point.get_ref().clone(), name.clone()))
                .collect(),
            normally_closed: closed.collect::<Result<_, _>>()?,
            equivalent: keys.equivalent.clone(),
            program: program.map(|file| folder.join(file.get_ref())),
            given,
            find: keys.find.as_ref().map(|find| find.get_ref().clone()),
            plant: keys.plant.as_ref().map(|file| folder.join(file.get_ref())),
        })
    }
}

/// The cases of a file; one of steps alone is a single one, which is about this.
fn cases(
    keys: &FileKeys,
    about: &Both,
    board: Board,
    given: Option<&Given>,
) -> Result<Vec<Case>, Slip> {
    let rhythm = Rhythm::of(keys, board, given)?;
    let is_empty = keys.case.is_empty() && keys.step.is_empty() && keys.fault.is_none();
    if keys.find.is_some() && is_empty {
        return Ok(Vec::new());
    }
    if let Some(first) = keys.case.first() {
        let has_steps = !keys.step.is_empty() || keys.until.is_some() || keys.stops.is_some();
        if has_steps || keys.fault.is_some() {
            return Err(slip(Some(first.span()), Wrong::CasesAndSteps));
        }
        let mut scans = 0;
        let case = |case: &Spanned<CaseKeys>| {
            let keys = case.get_ref();
            let timeline = rhythm.timeline(&keys.step, keys.until.as_ref(), None);
            let timeline = timeline.and_then(|timeline| timeline.within(&mut scans));
            Ok(Case {
                title: keys.title.clone(),
                hidden: keys.hidden,
                goal: Goal::Run(timeline.map_err(|slip| slip.or_in(case.span()))?),
            })
        };
        return keys.case.iter().map(case).collect();
    }
    let goal = match &keys.fault {
        Some(fault) => Goal::Refusal(refusal(fault, keys)?),
        None => {
            let timeline = rhythm.timeline(&keys.step, keys.until.as_ref(), keys.stops.as_ref())?;
            let place = keys.until.as_ref().map(Spanned::span);
            let within = timeline.within(&mut 0);
            Goal::Run(within.map_err(|slip| match place {
                Some(place) => slip.or_in(place),
                None => slip,
            })?)
        }
    };
    Ok(vec![Case {
        title: about.clone(),
        hidden: false,
        goal,
    }])
}

fn refusal(fault: &Spanned<FaultKeys>, keys: &FileKeys) -> Result<Refusal, Slip> {
    let &FaultKeys { number, line } = fault.get_ref();
    if !keys.step.is_empty() || keys.until.is_some() || keys.stops.is_some() {
        return Err(slip(Some(fault.span()), Wrong::FaultAndSteps));
    }
    known_fault(number, line, fault.span())
}

/// Whether something can be connected to a point of this name, or watched there.
fn is_point(name: &str, board: Board) -> bool {
    let inputs = (1..=board.inputs).map(|number| format!("I{number}"));
    let mut analogue = (0..board.analogue).map(|number| format!("A{number}"));
    inputs.chain(&mut analogue).any(|point| point == name) || Place::of_name(name, board).is_some()
}
