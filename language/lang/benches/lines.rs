//! The page `docs/compile-benchmarks.md`: how long it takes to check a text in Structured Text, and in how much memory.
//! Run by `cargo xtask bench`.
//!
//! Each text is checked in a process of its own, for what Linux tells of a process's memory is its peak.

use std::env;
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::hint::black_box;
use std::process::Command;
use std::time::{Duration, Instant};
use unoclp_lang::{TextLanguage, check};

mod text;

const LINES: [usize; 3] = [1_000, 10_000, 100_000];
/// Of so many measurements the shortest counts: the others were disturbed.
const TIMES: usize = 7;
/// In the process that measures: how many lines.
const CHILD: &str = "UNOCLP_BENCH_LINES";

const HEAD: &str = "\
# Benchmarks of the compiler

This page shows how much time and memory it takes to check a text in Structured Text, up to the typed tree. A program
writes this page: do not edit it; run the benchmark again.

```
cargo xtask bench
```

This command measures a release build. The texts are function blocks of ten lines each, without mistakes. Each time is the
shortest of seven runs on the computer that runs the benchmark, so another computer gives other figures. The memory is the
peak of the whole process. The target is 10,000 lines in 150 ms and 32 MB. The column *per line* shows whether the time
grows faster than the number of lines.

| lines | bytes | time | per line | memory |
| ---: | ---: | ---: | ---: | ---: |
";

fn main() -> Result<(), Box<dyn Error>> {
    if let Ok(lines) = env::var(CHILD) {
        return measure(lines.parse()?);
    }
    let words: Vec<String> = env::args().collect();
    let page = words.iter().position(|word| word == "--page");
    let page = page.and_then(|at| words.get(at + 1));
    let mut text = HEAD.to_owned();
    for lines in LINES {
        let mut child = Command::new(env::current_exe()?);
        let output = child.env(CHILD, lines.to_string()).output()?;
        let told = String::from_utf8(output.stdout)?;
        let row = told.lines().last().ok_or("nothing was measured")?;
        writeln!(text, "{row}")?;
    }
    match page {
        Some(page) => fs::write(page, text)?,
        None => print!("{text}"),
    }
    Ok(())
}

fn measure(lines: usize) -> Result<(), Box<dyn Error>> {
    let text = text::structured(lines);
    let mut least = Duration::MAX;
    for _ in 0..TIMES {
        let begin = Instant::now();
        black_box(check(
            black_box(&text),
            TextLanguage::St,
            unoclp_core::Board::UNO,
        ));
        least = least.min(begin.elapsed());
    }
    let (ms, us) = (least.as_secs_f64() * 1e3, least.as_secs_f64() * 1e6);
    let (bytes, memory) = (text.len(), peak()?);
    let per_line = us / lines as f64;
    println!("| {lines} | {bytes} | {ms:.1} ms | {per_line:.2} µs | {memory:.1} MB |");
    Ok(())
}

/// The most memory that this process has had, in MB.
fn peak() -> Result<f64, Box<dyn Error>> {
    let status = fs::read_to_string("/proc/self/status")?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes: f64 = line
        .and_then(|line| line.split_whitespace().next())
        .ok_or("Linux does not tell the peak")?
        .parse()?;
    Ok(kilobytes / 1024.0)
}
