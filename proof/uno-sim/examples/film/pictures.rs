//! What an animation shows: a machine that the firmware controls.

use anyhow::{Result, anyhow};
use std::fs;
use unoclp_core::{Board, Millis};
use unoclp_host_sim::engine::Engine;
use unoclp_plant::{Outputs, Picture, Run, picture, read};
use unoclp_program::{Lang, Written};
use unoclp_uno_sim::Program;
use unoclp_uno_sim::engine::{Clock, UnoEngine};

/// The pictures of a machine, one after so many ms each, for so long, ms: a scan and a step in each of them.
pub fn pictures(
    firmware: Program,
    program: &str,
    machine: &str,
    span: u64,
    every: u64,
) -> Result<Vec<Picture>> {
    let written = Written::new(program.to_owned(), fs::read(program)?, Board::UNO);
    let source = written.check(None);
    let source = source.map_err(|_| anyhow!("{program} has errors; unoclp check shows them"))?;
    let plant = read(&fs::read_to_string(machine)?, Board::UNO);
    let plant = plant.map_err(|told| {
        let first = told.first().map(|one| one.text(machine, Lang::En));
        anyhow!(first.unwrap_or_default())
    })?;
    let mut uno = UnoEngine::new(firmware, Clock::Lockstep)?;
    uno.load(&source.code)?
        .map_err(|refusal| anyhow!("{refusal}"))?;
    let mut run = Run::new(&plant, plant.seed);
    let (mut outputs, mut pictures) = (Outputs::default(), Vec::new());
    while run.now() <= span {
        if run.now().is_multiple_of(every) {
            pictures.push(picture(&run, Lang::En));
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
    Ok(pictures)
}

/// A line that is another one as soon as a picture is another one.
pub fn mark(pictures: &[Picture]) -> String {
    // FNV-1a, which no version of a library changes.
    let mix = |sum: u64, byte: u8| (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3);
    let bytes = pictures
        .iter()
        .flat_map(|picture| picture.svg().into_bytes());
    let sum = bytes.fold(0xCBF2_9CE4_8422_2325, mix);
    format!("unoclp: {} pictures, {sum:016x}", pictures.len())
}
