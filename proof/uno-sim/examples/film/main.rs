//! A machine that the firmware controls, as a moving picture: README's is made so.
//!
//! `cargo run --release -p unoclp-uno-sim --example film -- programs/plants/filling.st programs/plants/filling.toml docs/machine.gif 12`
//! runs the program on the simulated UNO, a scan and a step of the machine each millisecond, for so many seconds.

use anyhow::{Context, Result, anyhow};
use std::env;
use std::fs;
use unoclp_cli::film::{Film, every};
use unoclp_core::{Board, Millis};
use unoclp_host_sim::engine::Engine;
use unoclp_plant::{Outputs, Run, picture, read};
use unoclp_program::{Lang, Written};
use unoclp_uno_sim::engine::{Clock, UnoEngine};
use unoclp_uno_sim::{Program, firmware_file};

fn main() -> Result<()> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [program, machine, film, seconds] = &arguments[..] else {
        return Err(anyhow!("PROGRAM MACHINE.toml OUT.gif SECONDS"));
    };
    let seconds: u64 = seconds.parse().context("SECONDS is a whole number")?;
    let span = seconds * 1000;
    let written = Written::new(program.clone(), fs::read(program)?, Board::UNO);
    let source = written.check(None);
    let source = source.map_err(|_| anyhow!("{program} has errors; unoclp check shows them"))?;
    let plant = read(&fs::read_to_string(machine)?, Board::UNO);
    let plant = plant.map_err(|told| {
        let first = told.first().map(|one| one.text(machine, Lang::En));
        anyhow!(first.unwrap_or_default())
    })?;
    let firmware = Program::read(&firmware_file()?)?;
    let mut uno = UnoEngine::new(firmware, Clock::Lockstep)?;
    uno.load(&source.code)?
        .map_err(|refusal| anyhow!("{refusal}"))?;
    let mut run = Run::new(&plant, plant.seed);
    let (mut outputs, mut pictures) = (Outputs::default(), Film::new());
    while run.now() <= span {
        if run.now().is_multiple_of(every(span)) {
            let seen = picture(&run, Lang::En);
            pictures.add(&seen).map_err(|why| anyhow!(why))?;
        }
        let scanned = uno.scan(run.inputs(), run.now() as Millis)?;
        outputs.points = scanned.map_err(|refusal| anyhow!("{refusal}"))?;
        for output in plant.board.pwm_outputs().filter(|_| plant.dims()) {
            if let Some(place) = outputs.pwm.get_mut(usize::from(output)) {
                *place = uno.pwm(output)?;
            }
        }
        run.step(&outputs);
    }
    let bytes = pictures.finish(every(span)).map_err(|why| anyhow!(why))?;
    fs::write(film, bytes).with_context(|| film.clone())
}
