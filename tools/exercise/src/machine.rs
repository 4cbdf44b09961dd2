//! A plant controlled by a program, on any engine: a scan each millisecond, and a step of the plant after each.
//!
//! Owns how the two are tied together. Must not know what either does.

use crate::scenario::words;
use std::fmt;
use std::ops::RangeInclusive;
use unoclp_core::Millis;
use unoclp_host_sim::engine::{Engine, Refusal};
use unoclp_plant::{Broken, Missed, Outputs, Plant, Run, Unit, Verdict};
use unoclp_program::diagnosis;
use unoclp_words::Lang;

/// Why a program has not controlled a plant to the end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ended {
    /// The program was refused.
    Refused(Refusal),
    /// It ended in a fault, at this time in ms after the first scan.
    Stopped(u64, Refusal),
    /// The engine did not do its work.
    Broken(String),
}

impl Ended {
    /// It in a line.
    pub fn text(&self, lang: Lang) -> String {
        let fault = |refusal: &Refusal| match refusal.fault() {
            Some(fault) => {
                let number = words::fault(lang, fault.cause.number());
                format!("{number}: {}", diagnosis::cause(fault.cause, lang))
            }
            None => refusal.to_string(),
        };
        match self {
            Ended::Refused(refusal) => fault(refusal),
            Ended::Stopped(at, refusal) => {
                words::stopped_in(lang, Unit::Ms.shown(*at as i64), fault(refusal))
            }
            Ended::Broken(why) => why.clone(),
        }
    }
}

/// English, for developers.
impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Lang::En))
    }
}

/// Lets a program control a plant through its script; `watch` sees the plant before the first step and after each.
///
/// # Errors
/// [`Ended`], where the program does not come to the end.
pub fn control<E: Engine>(
    plant: &Plant,
    seed: u64,
    program: &[u8],
    engine: &mut E,
    mut watch: impl FnMut(&Run<'_>),
) -> Result<Verdict, Ended> {
    let run = Run::new(plant, seed);
    controlled(run, plant.until, program, engine, |run| {
        watch(run);
        true
    })
}

/// The same from one time to another alone, ms: `watch` sees the plant in each of them, and it runs no further. It may go
/// on after its script has ended.
///
/// # Errors
/// [`Ended`], where the program does not come so far.
pub fn between<E: Engine>(
    plant: &Plant,
    program: &[u8],
    engine: &mut E,
    span: RangeInclusive<u64>,
    mut watch: impl FnMut(&Run<'_>),
) -> Result<(), Ended> {
    let run = Run::new(plant, plant.seed);
    let end = span.end().saturating_add(1);
    controlled(run, end, program, engine, |run| {
        if span.contains(&run.now()) {
            watch(run);
        }
        true
    })?;
    Ok(())
}

/// A number for all that a plant is in each of so many ms while a program controls it: the same trace gives the same number.
///
/// # Errors
/// [`Ended`], where the program does not come so far.
pub fn trace<E: Engine>(
    plant: &Plant,
    program: &[u8],
    engine: &mut E,
    span: u64,
) -> Result<u64, Ended> {
    let run = Run::new(plant, plant.seed);
    let mut trace = 0_u64;
    controlled(run, span, program, engine, |run| {
        trace = trace.rotate_left(5) ^ run.hash();
        true
    })?;
    Ok(trace)
}

/// What goes wrong first with a machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum First {
    /// A rule.
    Broken(Broken),
    /// A goal.
    Missed(Missed),
}

impl First {
    /// When it went wrong, ms after the first step.
    pub fn at(&self) -> u64 {
        match self {
            First::Broken(broken) => broken.at,
            First::Missed(missed) => missed.at,
        }
    }

    /// It in a line: when, and which.
    pub fn text(&self, plant: &Plant, lang: Lang) -> String {
        let seconds = |at: u64| Unit::Ms.shown(at as i64);
        match self {
            First::Broken(Broken { rule, at, .. }) => {
                let never = plant.nevers.get(*rule);
                let text = never.map_or("", |never| never.text.text(lang));
                words::rule_broken(lang, seconds(*at), text)
            }
            First::Missed(Missed {
                goal, at, since, ..
            }) => {
                let goal = plant.goals.get(*goal);
                let text = goal.map_or("", |goal| goal.text.text(lang));
                words::goal_missed(lang, seconds(*at), text, seconds(*since))
            }
        }
    }
}

/// What goes wrong first with a plant that a program controls, which runs no further; nothing, where all is well to the
/// end of its script.
///
/// # Errors
/// [`Ended`], where the program does not come so far.
pub fn first_wrong<E: Engine>(
    plant: &Plant,
    seed: u64,
    program: &[u8],
    engine: &mut E,
) -> Result<Option<First>, Ended> {
    let run = Run::new(plant, seed);
    let goes_on = |run: &Run<'_>| run.verdict().is_passed();
    let verdict = controlled(run, plant.until, program, engine, goes_on)?;
    let broken = verdict.broken.into_iter().next().map(First::Broken);
    let missed = verdict.missed.into_iter().next().map(First::Missed);
    Ok(broken.or(missed))
}

/// What goes wrong with the machine of an exercise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WentWrong {
    /// What goes wrong first.
    pub first: First,
    /// What chance began with, where that is hidden from the student; none with the plant's own.
    pub hidden: Option<u32>,
}

impl WentWrong {
    /// It in a line, with the chances that are hidden from a student.
    pub fn text(&self, plant: &Plant, lang: Lang) -> String {
        let why = self.first.text(plant, lang);
        match self.hidden {
            Some(seed) => words::hidden_chance(lang, seed, why),
            None => why,
        }
    }
}

/// What goes wrong with a machine as its file says it, then with chances that begin with each of these; nothing, where all
/// is well.
///
/// # Errors
/// [`Ended`], where the program does not come so far.
pub fn with_chances<E: Engine>(
    plant: &Plant,
    seeds: &[u32],
    program: &[u8],
    engine: &mut E,
) -> Result<Option<WentWrong>, Ended> {
    let hidden = seeds.iter().map(|seed| (u64::from(*seed), Some(*seed)));
    for (seed, hidden) in std::iter::once((plant.seed, None)).chain(hidden) {
        if let Some(first) = first_wrong(plant, seed, program, engine)? {
            return Ok(Some(WentWrong { first, hidden }));
        }
    }
    Ok(None)
}

/// Lets a program control a plant until this time, ms, or until `goes_on` says that it shall not.
fn controlled<E: Engine>(
    mut run: Run<'_>,
    until: u64,
    program: &[u8],
    engine: &mut E,
    mut goes_on: impl FnMut(&Run<'_>) -> bool,
) -> Result<Verdict, Ended> {
    let plant = run.plant();
    let broken = |error: E::Error| Ended::Broken(error.to_string());
    engine
        .load(program)
        .map_err(broken)?
        .map_err(Ended::Refused)?;
    let mut outputs = Outputs::default();
    while goes_on(&run) && run.now() < until {
        let now = run.now();
        let scanned = engine.scan(run.inputs(), now as Millis).map_err(broken)?;
        outputs.points = scanned.map_err(|refusal| Ended::Stopped(now, refusal))?;
        for output in plant.board.pwm_outputs() {
            let duty = engine.pwm(output).map_err(broken)?;
            if let Some(place) = outputs.pwm.get_mut(usize::from(output)) {
                *place = duty;
            }
        }
        run.step(&outputs);
    }
    Ok(run.verdict().clone())
}
