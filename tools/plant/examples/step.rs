//! How long a millisecond of each shipped plant takes, its rules among it, while outputs of chance drive it.
//!
//! `cargo run --release -p unoclp-plant --example step` prints them, of which the target is 5 µs for the largest; with
//! `--json` it says the longest in a form that `cargo xtask bench` writes into a page.

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;
use unoclp_core::{Board, Image};
use unoclp_plant::{Outputs, Plant, Run, read};

/// The quickest of so many rounds counts; each is so many ms, with other outputs from time to time.
const ROUNDS: u32 = 20;
const STEPS: u32 = 10_000;
const STAYS: u32 = 700;

/// µs for a step, on average over a round.
fn time(plant: &Plant) -> f64 {
    let mut run = Run::new(plant, 1);
    let mut quickest = f64::INFINITY;
    let mut outputs = Outputs::default();
    for round in 0..ROUNDS {
        let begin = Instant::now();
        for step in 0..STEPS {
            if step % STAYS == 0 {
                // Each of the sixteen patterns comes.
                outputs.points = Image(u128::from((round * 7 + step / STAYS) % 16));
                outputs.pwm = [(step / STAYS * 40) as u8; 100];
            }
            black_box(run.step(black_box(&outputs)));
        }
        let took = begin.elapsed().as_secs_f64() * 1e6 / f64::from(STEPS);
        quickest = quickest.min(took);
    }
    quickest
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/plants");
    let mut rows = Vec::new();
    for entry in fs::read_dir(folder)? {
        let file = entry?.path();
        if file.extension().is_some_and(|end| end == "toml") {
            let name = file.file_stem().unwrap_or_default().display().to_string();
            let plant = read(&fs::read_to_string(&file)?, Board::UNO);
            let plant = plant.map_err(|_| format!("{name} has mistakes"))?;
            rows.push((time(&plant), name));
        }
    }
    rows.sort_by(|(one, _), (other, _)| one.total_cmp(other));
    let Some((longest, of)) = rows.last() else {
        return Err("there is no plant".into());
    };
    if std::env::args().any(|word| word == "--json") {
        println!("{{\"step\":{longest},\"stepOf\":\"{of}\"}}");
        return Ok(());
    }
    for (time, name) in &rows {
        println!("{name}: {time:.2} µs a step");
    }
    Ok(())
}
