//! Machines controlled by the firmware: in each millisecond it does what the core does, so that the machine moves alike.
//!
//! The model solutions of the machines run beside the core, a scan and a step each millisecond. As long as both give the same
//! outputs they give the machine the same trace, so that one machine serves for both. On the core all of them pass to the
//! end of their scripts (`tools/exercise/tests/it/plants.rs`); here their first seconds are compared.

use crate::{BOARD, common};
use std::fs;
use std::path::{Path, PathBuf};
use unoclp_core::{Board, Millis};
use unoclp_exercise::scenario::Exercise;
use unoclp_host_sim::engine::{Engine, HostEngine};
use unoclp_plant::{Outputs, Plant, Run, read};
use unoclp_program::Written;
use unoclp_uno_sim::Uno;
use unoclp_uno_sim::avr8js::Avr8js;
use unoclp_uno_sim::engine::{Clock, FirmwareEngine, Simulated};

/// A pulse of the PWM takes up to 2 ms, and a scan in lockstep less than 1 ms: after so many scans a new duty is measured.
const SETTLED: u32 = 30;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/plants")
}

/// A machine with its model solution.
type Solved = (String, Plant, Vec<u8>);

/// The machines of the exercises for this board that are none of the gallery, each with the model solution of its exercise.
fn of_exercises() -> Vec<Solved> {
    let folder = folder().join("../exercises");
    let entries = fs::read_dir(&folder).unwrap();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|end| end == "toml"));
    files.sort();
    let load = |file: PathBuf| {
        let exercise = Exercise::load(&file, Board::UNO).unwrap();
        let plant = exercise.plant.filter(|plant| {
            exercise.board == BOARD && plant.starts_with(folder.join("machines"))
        })?;
        let plant = read(&fs::read_to_string(&plant).unwrap(), BOARD);
        let program = exercise.program.unwrap();
        Some((plant.unwrap(), program))
    };
    let solved = |(plant, program): (Plant, PathBuf)| {
        let name = program.display().to_string();
        let written = Written::new(name.clone(), fs::read(&program).unwrap(), BOARD);
        let source = written.check(None).unwrap_or_else(|_| panic!("{name}"));
        (name, plant, source.code)
    };
    files.into_iter().filter_map(load).map(solved).collect()
}

/// Each machine of the gallery that is wired to this board, with its model solution.
fn plants() -> Vec<Solved> {
    let entries = fs::read_dir(folder()).unwrap();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|end| end == "toml"));
    files.sort();
    let load = |file: PathBuf| {
        let plant = read(&fs::read_to_string(&file).unwrap(), Board::UNO);
        let plant = plant.unwrap_or_else(|_| panic!("{file:?}"));
        if plant.board != BOARD {
            return None;
        }
        let model = file.with_extension("st");
        let name = model.display().to_string();
        let written = Written::new(name.clone(), fs::read(&model).unwrap(), BOARD);
        let code = written
            .check(None)
            .unwrap_or_else(|_| panic!("{name}"))
            .code;
        Some((name, plant, code))
    };
    files.into_iter().filter_map(load).collect()
}

/// Compares the firmware with the core for so long, ms.
fn compare<S: Simulated>(plants: &[Solved], span: u64) {
    let mut uno = FirmwareEngine::<S>::new(common::firmware(), Clock::Lockstep).unwrap();
    let mut moved = 0;
    for (name, plant, code) in plants {
        let mut core = HostEngine::new(BOARD);
        assert_eq!(core.load(code), Ok(Ok(())), "{name}");
        uno.load(code)
            .unwrap()
            .unwrap_or_else(|refusal| panic!("{name}: {refusal}"));
        let mut run = Run::new(plant, plant.seed);
        let begin = run.hash();
        let mut outputs = Outputs::default();
        // How long each duty has stood, scans.
        let mut stood = [0; 16];
        while run.now() < span.min(plant.until) {
            let now = run.now() as Millis;
            let scanned = core.scan(run.inputs(), now).unwrap().unwrap();
            let came = uno.scan(run.inputs(), now).unwrap().unwrap();
            assert_eq!(came, scanned, "{name}: at {now} ms");
            moved += usize::from(scanned != outputs.points);
            outputs.points = scanned;
            for output in plant.board.pwm_outputs() {
                let place = usize::from(output);
                let duty = core.pwm(output).unwrap();
                stood[place] = if duty == outputs.pwm[place] {
                    stood[place] + 1
                } else {
                    0
                };
                outputs.pwm[place] = duty;
                if stood[place] >= SETTLED {
                    assert_eq!(
                        uno.pwm(output).unwrap(),
                        duty,
                        "{name}: P{output} at {now} ms"
                    );
                }
            }
            run.step(&outputs);
        }
        assert_ne!(run.hash(), begin, "{name}: nothing happened");
    }
    assert!(moved > plants.len(), "the machines stood: {moved}");
}

#[test]
fn the_firmware_controls_machines_as_the_core_does() {
    let plants = plants();
    assert_eq!(plants.len(), if BOARD == Board::UNO { 16 } else { 4 });
    compare::<Uno>(&plants, 6000);
}

#[test]
fn the_firmware_controls_the_machines_of_the_exercises() {
    let plants = of_exercises();
    assert_eq!(plants.len(), if BOARD == Board::UNO { 28 } else { 5 });
    compare::<Uno>(&plants, 2500);
}

#[test]
fn the_firmware_on_avr8js_controls_machines_as_the_core_does() {
    compare::<Avr8js>(&plants(), 3000);
}
