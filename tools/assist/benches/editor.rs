//! The page `docs/editor-benchmarks.md`: how long an editor waits for what it asks. Run by `cargo xtask bench`.

use std::env;
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::hint::black_box;
use std::time::{Duration, Instant};
use unoclp_assist::{complete, declared, hover, rename, uses};
use unoclp_core::Board;
use unoclp_lang::Lang;
use unoclp_program::Written;
use unoclp_workspace::Workspace;

const LINES: usize = 2_000;
const UNITS: usize = 20;
/// Of so many measurements the shortest counts: the others were disturbed.
const TIMES: usize = 7;

const HEAD: &str = "\
# Benchmarks of the editor

This page shows how long an editor waits for an answer. A program writes this page: do not edit it; run the benchmark again.

```
cargo xtask bench
```

This command measures a release build. The text has 2,000 lines of Structured Text in function blocks. The project has 20
programs in Ladder Diagram, Function Block Diagram, Sequential Function Chart and Structured Text, which share a variable and
a block. The time of a rename includes compiling the project before and after it, to check that the codes are the same. Each
time is the shortest of seven runs on the computer that runs the benchmark.

| request | time | target |
| :--- | ---: | ---: |
";

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = env::args().collect();
    let page = words.iter().position(|word| word == "--page");
    let page = page.and_then(|at| words.get(at + 1));
    let mut told = HEAD.to_owned();

    let text = structured();
    let at = text.rfind("level := 5").ok_or("a call")? as u32;
    let written = Written::new("long.st".to_owned(), text.into_bytes(), Board::PC);
    let analysis = Workspace::default().open(written.clone());
    black_box(analysis.check());
    let mut row = |what: &str, target: &str, asked: &mut dyn FnMut() -> bool| {
        let time = least(asked)?;
        writeln!(
            told,
            "| {what} | {:.1} ms | {target} |",
            time.as_secs_f64() * 1e3
        )?;
        Ok::<(), Box<dyn Error>>(())
    };
    row("completion in 2,000 lines", "≤ 30 ms", &mut || {
        !complete(&written, at, Lang::En).1.is_empty()
    })?;
    row("hover in 2,000 lines", "≤ 30 ms", &mut || {
        hover(&analysis, at + 1, Lang::En).is_some()
    })?;

    let project = project();
    let written = Written::new("plc.xml".to_owned(), project.into_bytes(), Board::PC);
    let analysis = Workspace::default().open(written.clone());
    if analysis.source().is_none() {
        return Err(format!("{:?}", analysis.check()).into());
    }
    let at = declared(&written, None, "run").ok_or("a variable")?;
    row("all uses in 20 programs", "≤ 100 ms", &mut || {
        uses(&written, at).len() > UNITS
    })?;
    row("rename in 20 programs", "≤ 100 ms", &mut || {
        rename(&analysis, at, "works").is_ok_and(|edits| edits.len() > UNITS)
    })?;
    match page {
        Some(page) => fs::write(page, told)?,
        None => print!("{told}"),
    }
    Ok(())
}

/// The least time of something that shall come to something.
fn least(asked: &mut dyn FnMut() -> bool) -> Result<Duration, Box<dyn Error>> {
    let mut least = Duration::MAX;
    for _ in 0..TIMES {
        let begin = Instant::now();
        let came = black_box(asked());
        least = least.min(begin.elapsed());
        if !came {
            return Err("nothing came of it".into());
        }
    }
    Ok(least)
}

/// Function blocks of ten lines each, as a person would write them.
fn structured() -> String {
    let block = |number: usize| {
        format!(
            "FUNCTION_BLOCK Drive{number}\nVAR_INPUT go : BOOL; level : INT; END_VAR\nVAR_OUTPUT run : BOOL; END_VAR\n\
             VAR i : INT; END_VAR\nIF go AND level > 100 OR run THEN\n  run := go;\n\
             ELSIF level MOD 7 = 3 THEN\n  i := i + level * 3 / (i + 1);\nEND_IF;\nEND_FUNCTION_BLOCK\n"
        )
    };
    let blocks: String = (0..LINES / 10).map(block).collect();
    blocks + "PROGRAM main\nVAR d : Drive0; END_VAR\nd(level := 5);\nEND_PROGRAM\n"
}

/// The project of the tests with its four programs again and again, each a unit of its own.
fn project() -> String {
    let one = include_str!("../tests/it/units.xml");
    let mut all = one.to_owned();
    for again in 1..UNITS / 4 {
        for name in ["drawn", "boxes", "written", "chart"] {
            let pou = format!("<pou name=\"{name}\"");
            let unit = one.find(&pou).map(|at| &one[at..]).unwrap_or_default();
            let end = unit.find("</pou>").map_or(0, |end| end + "</pou>".len());
            let unit = unit[..end].replace(&pou, &format!("<pou name=\"{name}{again}\""));
            all = all.replace("</pous>", &format!("{unit}\n</pous>"));
            let run = format!(
                "<pouInstance name=\"{name}{again}\" typeName=\"{name}{again}\"/>\n</task>"
            );
            all = all.replace("</task>", &run);
        }
    }
    all
}
