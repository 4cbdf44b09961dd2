//! What the lines of a running program show: each file of `tests/live` says it after its lines.

use serde::Deserialize;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use unoclp_core::{Image, Inputs, Snapshot};
use unoclp_exercise::live::{Lines, Mark, Twin};
use unoclp_host_sim::engine::Machine;
use unoclp_program::{Source, Written};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    case: Vec<Case>,
}

/// A program, and what its lines show of a board that has run it so.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    /// What it shows.
    about: String,
    /// The name of its file, whose end says its language.
    file: String,
    /// Its text; after `⟵` stands what a line shows: `on`, `off`, `= 5`; nothing where it shows nothing.
    text: String,
    /// The inputs that are on, and how long, ms; a scan each.
    steps: Vec<Step>,
    /// What the analogue inputs give, A 00 first.
    #[serde(default)]
    analogue: Vec<u16>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Step {
    ms: u32,
    #[serde(default)]
    on: Vec<u8>,
}

/// A board that has run the steps, and the inputs and the time of its next scan.
fn run(source: Source, case: &Case) -> (Machine, Inputs, u32) {
    let mut board = Machine::new(source.checked);
    let (mut inputs, mut now) = (Inputs::default(), 0);
    for step in &case.steps {
        let on = step
            .on
            .iter()
            .fold(0, |bits, input| bits | 1 << (input - 1));
        inputs = Inputs::from(Image(on));
        for (to, from) in inputs.analogue.iter_mut().zip(&case.analogue) {
            *to = *from;
        }
        for _ in 0..step.ms {
            board.scan_observed(inputs, now, |_, _| ()).unwrap();
            now += 1;
        }
    }
    (board, inputs, now)
}

/// The text with what each of its lines shows.
fn shown(case: &Case, text: &str) -> String {
    let open = || {
        let written = Written::new(case.file.clone(), text.into(), unoclp_core::Board::UNO);
        let open = written.check(None);
        open.unwrap_or_else(|refused| panic!("{}: {refused:?}", case.about))
    };
    let lines = Lines::new(&open());
    let (board, inputs, now) = run(open(), case);
    let plc = board.plc();
    let timers: Vec<_> = plc.timers(now).map(|t| (t.elapsed, t.preset)).collect();
    let counters: Vec<_> = plc.counters().map(|c| (c.value, c.preset)).collect();
    let snapshot = Snapshot {
        outputs: plc.outputs(),
        markers: plc.markers(),
        registers: plc.registers(),
        timers: &timers,
        counters: &counters,
    };
    let mut twin = Twin::new(Machine::new(open().checked));
    // The first reading is none of a scan that begins.
    twin.flow(&snapshot, inputs, now);
    let flow = twin.flow(&snapshot, inputs, now);
    let mut shown = String::new();
    for (text, mark) in text.lines().zip(lines.marks(&flow)) {
        let mark = match mark {
            Mark::Power(Some(true)) => " ⟵ on".to_owned(),
            Mark::Power(Some(false)) => " ⟵ off".to_owned(),
            Mark::Value(Some(value)) => format!(" ⟵ = {value}"),
            Mark::Power(None) | Mark::Value(None) => String::new(),
        };
        writeln!(shown, "{text}{mark}").unwrap();
    }
    shown
}

#[test]
fn lines_show_what_they_test_and_store() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/live");
    let mut paths: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.sort();
    assert!(!paths.is_empty());
    let mut wrong = Vec::new();
    for path in paths {
        let file: File = toml::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        for case in file.case {
            let plain = |line: &str| line.split(" ⟵").next().unwrap_or_default().to_owned();
            let text: Vec<String> = case.text.lines().map(plain).collect();
            let shown = shown(&case, &(text.join("\n") + "\n"));
            if shown.trim_end() != case.text.trim_end() {
                wrong.push(format!("{}: {}:\n{shown}", path.display(), case.about));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
