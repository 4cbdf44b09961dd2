//! `bench`: measures the firmware, and what it is compared with, on simulated boards; prints the result and writes
//! `docs/benchmarks.md`. Run by `cargo xtask bench`.
//!
//! Everything is seen from outside, on the ELF file that is flashed: a pin that toggles once in each scan, the symbol
//! `scan_begin`, the interrupt vector of timer 1, the stack pointer, the serial port. How the firmware works inside is
//! not known here.

mod jobs;
mod mega;
mod meter;
mod modes;
mod polling;
mod programs;
mod report;
mod scans;
mod table;
mod targets;
mod timers;
mod work;
mod yardsticks;

use anyhow::{Context, Result};
use clap::Parser;
use report::Figures;
use signal_hook::consts::SIGPIPE;
use signal_hook::flag::register_conditional_default;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use unoclp_uno_sim::Program;
use yardsticks::Workshop;

#[derive(Parser)]
#[command(about = "Measures the firmware on simulated boards, beside what it is compared with")]
struct Arguments {
    /// The firmware, as `cargo xtask firmware` leaves it
    #[arg(long)]
    elf: PathBuf,
    /// That of the Mega
    #[arg(long)]
    mega: PathBuf,
    /// The page to write
    #[arg(long)]
    page: PathBuf,
}

fn main() -> Result<()> {
    // Whoever reads no more of the output wants no more of it.
    register_conditional_default(SIGPIPE, Arc::new(AtomicBool::new(true)))?;
    let Arguments { elf, mega, page } = Arguments::parse();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = root
        .ancestors()
        .nth(2)
        .context("this crate stands two folders deep")?;
    let figures = measure(&Program::read(&elf)?, &Program::read(&mega)?, root)?;
    print!("\n{}", targets::table(&figures));
    std::fs::write(&page, report::page(&figures))
        .with_context(|| format!("cannot write {}", page.display()))?;
    println!(
        "\nAll figures, and how they were measured: {}",
        page.display()
    );
    Ok(())
}

fn measure(firmware: &Program, mega: &Program, root: &Path) -> Result<Figures> {
    let template = root.join("programs/STATE.TXT");
    println!("the yardsticks …");
    let logic = |rungs: &[programs::Rung]| scans::logic(firmware, rungs);
    let workshop = Workshop::new(root);
    let yardsticks = workshop.measure(logic)?;
    println!("pieces of work …");
    let work = work::measure(firmware, &workshop)?;
    println!("scans …");
    let scans = scans::measure(firmware)?;
    println!("timers …");
    let timers = timers::measure(firmware)?;
    println!("background jobs …");
    let jobs = jobs::measure(firmware, &template)?;
    println!("a Modbus client …");
    let polling = polling::measure(firmware)?;
    println!("modes and memories …");
    let modes = modes::measure(firmware, &template)?;
    println!("a Mega …");
    let mega = mega::measure(mega)?;
    Ok(Figures {
        yardsticks,
        work,
        scans,
        timers,
        jobs,
        polling,
        modes,
        mega,
    })
}
