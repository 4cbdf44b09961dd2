//! Random typed programs: the interpreter, the core and the firmware do the same, scan by scan.
//!
//! `UNOCLP_SEED` is the first seed.

#[path = "../../../../language/lang/tests/it/board.rs"]
#[allow(dead_code, reason = "the tests of the compiler use more of it")]
pub mod board;

use crate::common;
use board::{Twins, errors, with_plc};
use unoclp_core::isa::REGISTERS;
use unoclp_core::{Board, Plc};
use unoclp_host_sim::engine::{Cell, Engine};
use unoclp_lang::{CompiledText, TextLanguage, compile_text};
use unoclp_testing::{Random, least, rounds, typed_program};
use unoclp_uno_sim::engine::{Clock, UnoEngine};

const PROGRAMS: u32 = 500;
const SCANS: u32 = 20;

/// The largest program of this seed that the board has room for; none where it cannot have any.
fn fitting(seed: u64) -> Option<(String, CompiledText)> {
    let sizes = [8, 6, 4, 3, 2, 1];
    sizes.into_iter().find_map(|statements| {
        let text = typed_program(seed, statements);
        let made = compile_text(&text, TextLanguage::St, Board::UNO);
        errors(&made).is_none().then_some((text, made))
    })
}

/// How many scans a program makes on all three, and how many change something; none where it does not run.
///
/// # Errors
/// What differs.
fn compared(uno: &mut UnoEngine, seed: u64) -> Result<Option<(u32, u32)>, String> {
    let Some((text, made)) = fitting(seed) else {
        return Ok(None);
    };
    let places = made.places();
    let (Some(tree), Some((mut checked, _))) = (made.tree, made.program) else {
        return Ok(None);
    };
    let started = uno.start_kept(checked.program());
    let started = started.map_err(|error| format!("seed {seed}: {error}\n{text}"))?;
    if let Err(refusal) = started {
        return Err(format!("seed {seed}: refused, {refusal}\n{text}"));
    }
    with_plc(&mut checked, |plc| {
        let mut twins = Twins::new(&tree, &places);
        let random = &mut Random(seed ^ 0x5EED);
        let mut now = random.below(1 << 31) as u32;
        let (mut changes, mut before) = (0, None);
        for scan in 0..SCANS {
            if scan > 0 {
                twins.stir(plc, random);
                set_alike(uno, plc);
            }
            let told = |what: String| format!("seed {seed}, scan {scan}, {now} ms: {what}\n{text}");
            let came = uno.scan(&twins.inputs(), now);
            let came = came.map_err(|error| told(error.to_string()))?;
            let ran = twins.scan(plc, now);
            match (&ran, came) {
                (Ok(()), Ok(outputs)) if outputs == plc.outputs() => {}
                // Too many jumps.
                (Err(why), Err(_)) if why == "stopped" => return Ok(Some((scan, changes))),
                (Err(why), _) => return Err(told(why.clone())),
                (Ok(()), came) => {
                    let wanted = plc.outputs();
                    return Err(told(format!(
                        "{came:?} on the firmware, {wanted:?} on the core"
                    )));
                }
            }
            difference(uno, plc).map_or(Ok(()), |what| Err(told(what)))?;
            let memory = (
                plc.outputs(),
                plc.markers(),
                plc.registers().to_vec(),
                plc.pwm(4),
            );
            changes += u32::from(before.as_ref() != Some(&memory));
            before = Some(memory);
            now += random.below(60) as u32;
        }
        Ok(Some((SCANS, changes)))
    })
}

fn cells() -> impl Iterator<Item = Cell> {
    let markers = (1..=Board::UNO.markers).map(Cell::Marker);
    markers.chain((1..=REGISTERS).map(Cell::Register))
}

fn held(plc: &Plc<'_>, cell: Cell) -> i32 {
    match cell {
        Cell::Marker(number) => (plc.markers() >> (number - 1) & 1) as i32,
        Cell::Register(number) => plc.registers()[usize::from(number) - 1],
    }
}

/// Whatever has been set on the core between two scans is set on the firmware.
fn set_alike(uno: &mut UnoEngine, plc: &Plc<'_>) {
    for cell in cells() {
        let wanted = held(plc, cell);
        if uno.look(cell).unwrap() != wanted {
            uno.poke(cell, wanted).unwrap();
        }
    }
}

fn difference(uno: &mut UnoEngine, plc: &Plc<'_>) -> Option<String> {
    let cell = cells().find(|cell| uno.look(*cell).unwrap() != held(plc, *cell));
    if let Some(cell) = cell {
        let (came, wanted) = (uno.look(cell).unwrap(), held(plc, cell));
        return Some(format!(
            "{cell:?} is {came} on the firmware, {wanted} on the core"
        ));
    }
    let (came, wanted) = (uno.pwm(4).unwrap(), plc.pwm(4));
    (came != wanted).then(|| format!("PWM 4 is {came} on the firmware, {wanted} on the core"))
}

#[test]
fn random_typed_programs_are_alike_on_all_engines() {
    let first = std::env::var("UNOCLP_SEED").map_or(1, |seed| seed.parse().expect("a number"));
    let programs = rounds(PROGRAMS);
    let mut uno = UnoEngine::new(common::firmware(), Clock::Lockstep).unwrap();
    let (mut ran, mut scans, mut changes, mut wrong) = (0, 0, 0, Vec::new());
    for seed in (first..).take(10 * programs as usize) {
        match compared(&mut uno, seed) {
            Ok(None) => continue,
            Ok(Some((made, changed))) => {
                ran += 1;
                scans += made;
                changes += changed;
            }
            Err(why) => wrong.push((why, seed)),
        }
        if ran == programs || wrong.len() > 20 {
            break;
        }
    }
    println!(
        "{ran} random typed programs, {scans} scans alike, {changes} of them with changes; seeds from {first}"
    );
    wrong.sort_by_key(|(why, _)| why.len());
    if let Some((shortest, seed)) = wrong.first() {
        let lines = wrong.iter().filter_map(|(why, _)| why.lines().next());
        let lines: Vec<&str> = lines.collect();
        let least = least(|| compared(&mut uno, *seed)).err();
        panic!(
            "{}\nthe least of the shortest:\n{}",
            lines.join("\n"),
            least.as_ref().unwrap_or(shortest)
        );
    }
    assert_eq!(ran, programs);
    assert!(
        changes * 3 > scans,
        "the programs do too little to be compared: {changes}"
    );
}
