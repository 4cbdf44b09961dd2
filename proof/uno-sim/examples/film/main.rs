//! A machine that the firmware controls, as an animation: README's is made so.
//!
//! `cargo run --release -p unoclp-uno-sim --example film -- programs/plants/filling.st programs/plants/filling.toml docs/machine.gif 12`
//! runs the program on the simulated UNO, a scan and a step of the machine each millisecond, for so many seconds. The file
//! says in a comment which pictures it shows: `tests/it/film.rs` compares them with those of the firmware of now.

mod pictures;

use anyhow::{Context, Result, anyhow};
use pictures::{mark, pictures};
use std::env;
use std::fs;
use unoclp_cli::film::{Film, every};
use unoclp_uno_sim::{Program, firmware_file};

fn main() -> Result<()> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [program, machine, file, seconds] = &arguments[..] else {
        return Err(anyhow!("PROGRAM MACHINE.toml OUT.gif SECONDS"));
    };
    let seconds: u64 = seconds.parse().context("SECONDS is a whole number")?;
    let every = every(seconds * 1000);
    let firmware = Program::read(&firmware_file()?)?;
    let seen = pictures(firmware, program, machine, seconds * 1000, every)?;
    let mut film = Film::new();
    for picture in &seen {
        film.add(picture).map_err(|why| anyhow!(why))?;
    }
    let mut bytes = film.finish(every).map_err(|why| anyhow!(why))?;
    // A comment stands before the last byte, which ends the file.
    let mark = mark(&seen);
    bytes.pop();
    bytes.extend([0x21, 0xFE, u8::try_from(mark.len())?]);
    bytes.extend(mark.bytes());
    bytes.extend([0, 0x3B]);
    fs::write(file, bytes).with_context(|| file.clone())
}
