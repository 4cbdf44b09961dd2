//! The loader meets random and damaged files without a panic:
//! `cargo run --release -p unoclp-host-sim --example torture -- 10000000`
//!
//! A second number is the first seed (default 0). Each file follows from its own seed, so
//! `… -- 1 SEED` repeats a failure.

use std::panic::catch_unwind;
use std::process::ExitCode;
use unoclp_host_sim::torture::{Tally, torture};

/// Files from one line of progress to the next.
const PROGRESS: u64 = 1_000_000;

fn main() -> ExitCode {
    let mut numbers = std::env::args().skip(1).map(|number| number.parse::<u64>());
    let (files, first) = match (numbers.next(), numbers.next().unwrap_or(Ok(0))) {
        (Some(Ok(files)), Ok(first)) => (files, first),
        _ => {
            eprintln!("usage: torture FILES [FIRST_SEED]");
            return ExitCode::from(2);
        }
    };
    let mut tally = Tally::default();
    for (done, seed) in (1..=files).zip(first..) {
        let outcome = catch_unwind(|| {
            let mut tally = tally;
            torture(seed, &mut tally).map(|()| tally)
        });
        match outcome {
            Ok(Ok(counted)) => tally = counted,
            Ok(Err(broken)) => return failed(seed, &broken),
            Err(_) => return failed(seed, "it panicked"),
        }
        if done % PROGRESS == 0 || done == files {
            let Tally {
                programs,
                refused,
                restored,
                stopped,
            } = tally;
            println!(
                "{done} files: {programs} ran, {refused} refused; {restored} ran from damaged memory; \
                 {stopped} ended in a fault"
            );
        }
    }
    ExitCode::SUCCESS
}

fn failed(seed: u64, why: &str) -> ExitCode {
    eprintln!("seed {seed}: {why}");
    ExitCode::FAILURE
}
