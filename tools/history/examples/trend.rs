//! How long a trend of 30 days takes in a history of so many samples: `trend [SAMPLES] [FOLDER]`. Says it as JSON. The figures are in
//! `docs/site-benchmarks.md`.
//!
//! A thousand points change at regular intervals over 30 days, and are written in the order of time, as a gateway does.

use std::path::PathBuf;
use std::time::Instant;
use unoclp_history::{Query, Sample, Sqlite, Store};

const POINTS: usize = 1_000;
const DAYS: i64 = 30;
const DAY: i64 = 86_400_000;
/// Samples of one transaction.
const AT_ONCE: usize = 100_000;
/// Trends that are asked for, each of another point.
const ASKED: usize = 25;
/// Rows of a trend: as many as a screen is wide.
const ROWS: i64 = 600;

fn main() -> Result<(), String> {
    let mut words = std::env::args().skip(1);
    let samples: usize = match words.next() {
        Some(word) => word.parse().map_err(|_| format!("{word} is no number"))?,
        None => 100_000_000,
    };
    let folder = words.next().map_or_else(std::env::temp_dir, PathBuf::from);
    let file = folder.join(format!("unoclp-trend-{}.db", std::process::id()));
    let outcome = measured(&file, samples);
    for end in ["", "-wal", "-shm"] {
        let mut name = file.clone().into_os_string();
        name.push(end);
        // What is not there need not go.
        let _ = std::fs::remove_file(name);
    }
    println!("{}", outcome.map_err(|failure| format!("{failure:?}"))?);
    Ok(())
}

fn measured(file: &std::path::Path, samples: usize) -> Result<String, unoclp_history::Failure> {
    let rounds = samples / POINTS;
    let step = DAYS * DAY / i64::try_from(rounds.max(1)).unwrap_or(i64::MAX);
    let begun = Instant::now();
    let mut store = Sqlite::open(file)?;
    let mut batch = Vec::with_capacity(AT_ONCE);
    for round in 0..rounds {
        for point in 0..POINTS {
            let at = step * i64::try_from(round).unwrap_or_default();
            batch.push(Sample {
                board: format!("board{}", point / 32),
                point: format!("point{point}"),
                at,
                value: Some(((round * 37 + point * 11) % 1_000) as f64),
            });
        }
        if batch.len() >= AT_ONCE || round + 1 == rounds {
            store.append(&batch)?;
            batch.clear();
        }
    }
    drop(store);
    let written = begun.elapsed();
    // As a gateway asks: another connection, which only reads.
    let mut store = Sqlite::read(file)?;
    let mut times = Vec::new();
    let mut rows = 0;
    for number in 0..ASKED {
        let point = number * POINTS / ASKED;
        let query = Query {
            board: format!("board{}", point / 32),
            point: format!("point{point}"),
            from: 0,
            to: DAYS * DAY,
            step: DAYS * DAY / ROWS,
            most: 1_000,
        };
        let asked = Instant::now();
        rows = store.rows(&query)?.len();
        times.push(asked.elapsed().as_secs_f64() * 1_000.0);
    }
    times.sort_by(f64::total_cmp);
    let bytes = std::fs::metadata(file).map_or(0, |about| about.len());
    let of = |at: usize| times.get(at).copied().unwrap_or_default();
    Ok(format!(
        "{{\"samples\":{},\"seconds\":{:.0},\"bytes\":{bytes},\"rows\":{rows},\"median\":{:.1},\"longest\":{:.1}}}",
        rounds * POINTS,
        written.as_secs_f64(),
        of(ASKED / 2),
        of(ASKED - 1),
    ))
}
