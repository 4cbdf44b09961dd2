//! A program that is given, to be written again in another language: what it does is what is expected.
//!
//! Owns how a run of it becomes expectations. Must not know how these are compared.

use super::keys::{FileKeys, Slip, slip};
use super::{Place, Setting, Step, Wrong};
use std::collections::BTreeMap;
use unoclp_core::{Board, Inputs, Millis};
use unoclp_host_sim::engine::{Engine as _, HostEngine};
use unoclp_program::{Written, WrittenIn};

/// How many scans before the given program another may change an output: what a step or a timer does in one of them may be
/// a scan or two later in the other.
const EARLY: Millis = 3;

/// A program that a student reads, and the language to write it in.
#[derive(Clone, Debug)]
pub struct Given {
    /// Its text.
    pub text: String,
    /// The language that a program is to be written in.
    pub answer_in: WrittenIn,
    code: Vec<u8>,
    /// The outputs that are compared.
    places: Vec<Place>,
}

impl Given {
    /// That of a file; none where it gives none.
    pub(super) fn of_keys(keys: &FileKeys, board: Board) -> Result<Option<Given>, Slip> {
        let (text, language) = match (&keys.given, &keys.answer_in) {
            (Some(text), Some(language)) => (text, language),
            (None, None) => return Ok(None),
            (Some(one), None) | (None, Some(one)) => {
                return Err(slip(Some(one.span()), Wrong::GivenAlone));
            }
        };
        let Some(answer_in) = WrittenIn::named(language.get_ref()) else {
            return Err(slip(Some(language.span()), Wrong::NoLanguage));
        };
        let bytes = text.get_ref().clone().into_bytes();
        let written = Written::new("given".to_owned(), bytes, board);
        let Ok(source) = written.check(None) else {
            return Err(slip(Some(text.span()), Wrong::FaultyGiven));
        };
        let named = keys.names.keys().map(|name| name.get_ref());
        let places = named.filter_map(|name| Place::of_name(name, board));
        Ok(Some(Given {
            text: text.get_ref().clone(),
            answer_in,
            code: source.code,
            places: places.filter(|place| place.cell().is_none()).collect(),
        }))
    }

    /// The same steps, which expect from each scan on what this program does in it; in the few scans before a change, both
    /// values are right. A scan in which it fails is the last of which anything is expected.
    pub(super) fn expect(
        &self,
        steps: Vec<Step>,
        (start, period, until): (Millis, Millis, Millis),
        board: Board,
    ) -> Vec<Step> {
        let mut engine = HostEngine::new(board);
        let mut all: BTreeMap<Millis, Step> =
            steps.into_iter().map(|step| (step.at, step)).collect();
        if !matches!(engine.load(&self.code), Ok(Ok(()))) {
            return all.into_values().collect();
        }
        let mut inputs = Inputs::default();
        let mut last: BTreeMap<Place, (i32, Millis)> = BTreeMap::new();
        let mut next = Some(0);
        while let Some(at) = next.filter(|at| *at <= until) {
            if let Some(step) = all.get(&at) {
                set(step, &mut inputs, &mut engine);
            }
            let Ok(Ok(outputs)) = engine.scan(&inputs, start.wrapping_add(at)) else {
                break;
            };
            for place in &self.places {
                let value = match place.output() {
                    Some(output) => (outputs.0 >> (output - 1) & 1) as i32,
                    None => engine.pwm(place.point().number()).map_or(0, i32::from),
                };
                let before = last.get(place).copied();
                if before.is_some_and(|(before, _)| before == value) {
                    continue;
                }
                last.insert(*place, (value, at));
                let early = at.saturating_sub(EARLY.saturating_mul(period));
                if before.is_some_and(|(_, since)| since < early) {
                    let step = all.entry(early).or_insert_with(|| Step::at(early));
                    step.expect.push((*place, None));
                }
                let step = all.entry(at).or_insert_with(|| Step::at(at));
                step.expect.push((*place, Some(value)));
            }
            next = at.checked_add(period);
        }
        all.into_values().collect()
    }
}

fn set(step: &Step, inputs: &mut Inputs, engine: &mut HostEngine) {
    if step.restart {
        let Ok(()) = engine.restart();
    }
    for setting in &step.set {
        match *setting {
            Setting::Input(input, state) => inputs.points.set(input, state),
            Setting::Analogue(input, reading) => {
                if let Some(place) = inputs.analogue.get_mut(usize::from(input)) {
                    *place = reading;
                }
            }
            Setting::Cell(cell, value) => {
                let Ok(()) = engine.poke(cell, value);
            }
        }
    }
}
