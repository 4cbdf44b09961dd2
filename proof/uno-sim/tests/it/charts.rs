//! Random charts: the firmware does what the standard says and what the core does, scan by scan.
//!
//! `UNOCLP_SEED` is the first seed.

use crate::common;
use crate::starts::Starts;
use crate::typed::board::{errors, with_plc};
use unoclp_core::{Board, Image, Inputs};
use unoclp_host_sim::engine::{Cell, Engine};
use unoclp_lang::{TextLanguage, compile_text};
use unoclp_testing::chart::{Naive, sketch};
use unoclp_testing::{Random, least, rounds};
use unoclp_uno_sim::Uno;
use unoclp_uno_sim::avr8js::Avr8js;
use unoclp_uno_sim::engine::{Clock, FirmwareEngine};

const CHARTS: u32 = 500;
/// There a chart takes longer.
const ON_AVR8JS: u32 = 150;
const SCANS: u32 = 20;

/// Where the board keeps a symbol.
fn cell(place: &str) -> Option<Cell> {
    let (letter, number) = place.split_once(' ')?;
    let number = number.parse().ok()?;
    match letter {
        "M" => Some(Cell::Marker(number)),
        "D" => Some(Cell::Register(number)),
        _ => None,
    }
}

/// How many scans the chart of this seed makes; none where the board has no room for it.
///
/// # Errors
/// What differs.
fn compared<S: Starts>(uno: &mut FirmwareEngine<S>, seed: u64) -> Result<Option<u32>, String> {
    let chart = sketch(seed);
    let text = chart.text(false);
    let made = compile_text(&text, TextLanguage::St, Board::UNO);
    if errors(&made).is_some() {
        return Ok(None);
    }
    let places = made.places();
    let (Some(tree), Some((mut checked, _))) = (made.tree, made.program) else {
        return Ok(None);
    };
    let started = S::start(uno, checked.program());
    let started = started.map_err(|error| format!("seed {seed}: {error}\n{text}"))?;
    if let Err(refusal) = started {
        return Err(format!("seed {seed}: refused, {refusal}\n{text}"));
    }
    let place = |name: &str| {
        let at = tree.symbols.iter().position(|symbol| symbol.name == name)?;
        cell(places.get(at)?.as_deref()?)
    };
    let steps = 0..chart.steps.len();
    let steps: Vec<_> = steps.map(|step| place(&format!("s{step}.X"))).collect();
    let variables = 0..chart.variables;
    let variables: Vec<_> = variables
        .map(|number| place(&format!("v{number}")))
        .collect();
    let bodies = 0..chart.bodies.len();
    let counts: Vec<_> = bodies.map(|number| place(&format!("n{number}"))).collect();
    with_plc(&mut checked, |plc| {
        let mut naive = Naive::new(&chart);
        let random = &mut Random(seed ^ 0xC4A7);
        let mut now = random.below(1 << 31) as u32;
        let mut points = 0;
        for scan in 0..SCANS {
            points ^= random.turns(4, 20);
            let inputs = Inputs {
                points: Image(points),
                ..Inputs::default()
            };
            naive.scan(
                [0, 1, 2, 3].map(|input| points >> input & 1 != 0),
                now.into(),
            );
            let told = |what: String| format!("seed {seed}, scan {scan}, {now} ms: {what}\n{text}");
            let came = uno
                .scan(&inputs, now)
                .map_err(|error| told(error.to_string()))?;
            let ran = plc.scan(inputs, now).is_ok();
            if !ran || came.ok() != Some(plc.outputs()) {
                return Err(told("the outputs differ".to_owned()));
            }
            let wanted = naive.active.iter().chain(&naive.variables);
            let wanted = wanted.map(|is| i32::from(*is));
            let wanted = wanted.chain(naive.counts.iter().map(|count| *count as i32));
            let cells = steps.iter().chain(&variables).chain(&counts);
            for (cell, wanted) in cells.zip(wanted) {
                let Some(cell) = *cell else { continue };
                let is = uno.look(cell).map_err(|error| told(error.to_string()))?;
                if is != wanted {
                    return Err(told(format!(
                        "{cell:?} is {is}, but {wanted} by the standard"
                    )));
                }
            }
            now += random.below(30) as u32;
        }
        Ok(Some(SCANS))
    })
}

#[test]
fn random_charts_are_alike_on_the_firmware() {
    compare::<Uno>(CHARTS);
}

/// The same charts on avr8js, which the page runs the firmware on.
#[test]
fn random_charts_are_alike_on_avr8js() {
    compare::<Avr8js>(ON_AVR8JS);
}

fn compare<S: Starts>(charts: u32) {
    let first = std::env::var("UNOCLP_SEED").map_or(1, |seed| seed.parse().expect("a number"));
    let charts = rounds(charts);
    let mut uno = FirmwareEngine::<S>::new(common::firmware(), Clock::Lockstep).unwrap();
    let (mut ran, mut scans, mut wrong) = (0, 0, Vec::new());
    for seed in (first..).take(4 * charts as usize) {
        match compared(&mut uno, seed) {
            Ok(None) => continue,
            Ok(Some(made)) => {
                ran += 1;
                scans += made;
            }
            Err(why) => wrong.push((why, seed)),
        }
        if ran == charts || wrong.len() > 20 {
            break;
        }
    }
    println!("{ran} random charts, {scans} scans alike; seeds from {first}");
    wrong.sort_by_key(|(why, _)| why.len());
    if let Some((shortest, seed)) = wrong.first() {
        let least = least(|| compared(&mut uno, *seed)).err();
        panic!(
            "{} differ; the least of the shortest:\n{}",
            wrong.len(),
            least.as_ref().unwrap_or(shortest)
        );
    }
    assert_eq!(ran, charts);
}
