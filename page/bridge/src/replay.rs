//! What went wrong with a machine, to be seen again: its pictures about that moment, and what passed between it and the
//! program.
//!
//! Owns which moments are shown. Must not know how a page plays them.

use crate::answer::answer;
use crate::exercise::read;
use crate::machine::{Shown, plant, shown};
use crate::words::{No, both};
use std::collections::BTreeMap;
use unoclp_core::Millis;
use unoclp_exercise::diagram::Moment;
use unoclp_exercise::machine::between;
use unoclp_host_sim::engine::HostEngine;
use unoclp_plant::{live, picture};
use unoclp_program::{Lang, Source};

/// It is shown from so long before, ms, and goes on for so long.
const BEFORE: u64 = 2000;
const AFTER: u64 = 500;
/// From one picture to the next, ms.
const FRAME: u64 = 40;

answer! {
    /// A moment of a machine.
    pub struct Replay as "Replayed" {
        /// The first of its times and the last, ms after the first scan, and when it went wrong.
        from: u64,
        until: u64,
        at: u64,
        /// From one picture to the next, ms.
        every: u64,
        /// The first picture.
        svg: String,
        /// What changes with each of the others.
        frames: Vec<Vec<Shown>>,
        /// The timing diagram, and where its times are in it: the place of the first, and how far it is to the last.
        diagram: String,
        plot: [f32; 2],
    }
}

/// What a machine did about this time with a program, told in this language; `scenario` has names for the points.
///
/// # Errors
/// Where there is no machine, or the program ends before.
pub fn replay(
    source: &Source,
    (name, machine): (&str, &str),
    scenario: Option<&str>,
    (at, why): (u64, &str),
    lang: Lang,
) -> Result<Replay, No> {
    let board = source.board();
    let plant = plant(name, machine, board)?;
    let names = match scenario {
        Some(scenario) => read("exercise.toml", scenario, board)?.names,
        None => BTreeMap::new(),
    };
    // No script goes on for longer.
    let at = at.min(plant.until);
    let (from, until) = (at.saturating_sub(BEFORE), at + AFTER);
    let mut moment = Moment::new(&plant);
    let (mut svg, mut frames, mut last) = (String::new(), Vec::new(), None);
    let engine = &mut HostEngine::new(plant.board);
    let ended = between(&plant, &source.code, engine, from..=until, |run| {
        moment.note(run);
        if !(run.now() - from).is_multiple_of(FRAME) {
            return;
        }
        let now = live(run, lang);
        match &last {
            None => svg = picture(run, lang).svg(),
            Some(before) => {
                let changes = now.changes(before, run.plant());
                frames.push(changes.into_iter().map(shown).collect());
            }
        }
        last = Some(now);
    });
    // A program that has ended has shown all that there is to see.
    if let (Err(ended), None) = (ended, &last) {
        return Err(both(|lang| ended.text(lang)).into());
    }
    let marked = Millis::try_from(at).unwrap_or(Millis::MAX);
    Ok(Replay {
        from,
        until,
        at,
        every: FRAME,
        svg,
        frames,
        diagram: moment.svg(marked, why, &names, lang),
        plot: Moment::plot(),
    })
}
