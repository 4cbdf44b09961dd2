//! How many points a gateway reads: `scale PROGRAM BOARDS SECONDS`, with the program `unoclp` as it is handed out, or with the folder in
//! which Node-RED is installed; and how much of a line it uses: `scale PROGRAM BOARDS SECONDS RATE`. Says it as JSON. The figures are in
//! `docs/site-benchmarks.md`.
//!
//! The boards are simulated in this process, behind Modbus TCP, twenty on each line. Each has a program with 32 names, and is read every
//! 500 ms. One in eight of its points changes from reading to reading.
//!
//! - `boards`: the boards; `process`: what a program takes of the machine
//! - `line`: boards at an RS-485 line
//! - `unoclp`: gateways of 200 boards, each with a history; `node_red`: Node-RED, which reads the same points and keeps nothing

mod boards;
mod line;
mod node_red;
mod process;
mod unoclp;

use boards::{Lines, POINTS};
use process::Process;
use std::fs;
use std::io;
use std::path::PathBuf;
use std::thread;
use std::time::{Duration, Instant};

/// Until all boards are read, at most.
const PATIENCE: Duration = Duration::from_secs(120);

/// What reads boards.
struct Readers {
    processes: Vec<Process>,
    folder: PathBuf,
}

impl Drop for Readers {
    fn drop(&mut self) {
        self.processes.clear();
        // What is left there is nobody's concern.
        let _ = fs::remove_dir_all(&self.folder);
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut words = std::env::args().skip(1);
    let program = PathBuf::from(words.next().ok_or("which program?")?);
    let boards: usize = words.next().ok_or("how many boards?")?.parse()?;
    let seconds: u64 = words.next().ok_or("how long?")?.parse()?;
    let time = Duration::from_secs(seconds);
    let folder = std::env::temp_dir().join(format!("unoclp-scale-{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    let mut readers = Readers {
        processes: Vec::new(),
        folder: folder.clone(),
    };
    if let Some(rate) = words.next() {
        let boards = u8::try_from(boards)?;
        println!(
            "{}",
            line::measured(&program, &folder, boards, rate.parse()?, time)?
        );
        return Ok(());
    }
    let lines = Lines::of(boards)?;
    readers.processes = match program.is_dir() {
        true => vec![node_red::begin(&program, &folder, &lines)?],
        false => unoclp::begin(&program, &folder, &lines)?,
    };
    println!("{}", measured(&readers.processes, &lines, time)?);
    Ok(())
}

fn measured(processes: &[Process], lines: &Lines, time: Duration) -> io::Result<String> {
    let begun = Instant::now();
    while begun.elapsed() < PATIENCE && lines.read() < lines.boards {
        thread::sleep(Duration::from_millis(200));
    }
    let spent = || {
        processes
            .iter()
            .map(Process::spent)
            .sum::<io::Result<f64>>()
    };
    let (before, readings, begun) = (spent()?, lines.readings(), Instant::now());
    thread::sleep(time);
    let wall = begun.elapsed().as_secs_f64();
    let readings = (lines.readings() - readings) * POINTS;
    let processor = spent()? - before;
    let memory: u64 = processes
        .iter()
        .map(Process::memory)
        .sum::<io::Result<u64>>()?;
    Ok(format!(
        "{{\"boards\":{},\"up\":{},\"gateways\":{},\"points\":{POINTS},\"readings\":{:.0},\"core\":{:.3},\"perProcessorSecond\":{:.0},\"megabytes\":{:.0}}}",
        lines.boards,
        lines.read(),
        processes.len(),
        readings as f64 / wall,
        processor / wall,
        readings as f64 / processor,
        memory as f64 / 1_024.0,
    ))
}
