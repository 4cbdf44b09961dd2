//! Projects as editors write them, beside Structured Text that somebody has written by hand: the same outputs on random
//! inputs, scan by scan, of the project and of the text on the core, and of the text in the interpreter.

use std::fs;
use std::path::Path;
use unoclp_core::{Board, Image, Inputs, Plc};
use unoclp_lang::run::Machine;
use unoclp_lang::typed::{Tree, Value};
use unoclp_lang::{Lang, Told, check, compile_text};
use unoclp_lang::{Severity, TextLanguage};
use unoclp_plcopen::import;
use unoclp_point::Address;
use unoclp_testing::Random;

const SCANS: u32 = 1_000;

/// A board with room for anything, so that it is not room that is compared.
fn large() -> Board {
    Board {
        stored_bytes: 30_000,
        linked_bytes: 30_000,
        ..Board::UNO
    }
}

fn said(told: &Told) -> Vec<String> {
    let said = told.iter();
    said.map(|told| format!("{} {}", told.code, told.message(Lang::En)))
        .collect()
}

/// Sets the inputs of a tree.
fn set(machine: &mut Machine<'_>, tree: &Tree, inputs: &Inputs) {
    for (cell, point) in &tree.points {
        let value = match point {
            Address::Input(number) => (inputs.points.0 >> (number - 1) & 1) as i128,
            Address::Analogue(number) => inputs.analogue[usize::from(*number)].into(),
            _ => continue,
        };
        machine.set_cell(*cell, Value::Int(value));
    }
}

/// The outputs of a tree.
fn outputs(machine: &Machine<'_>, tree: &Tree) -> u128 {
    let outputs = tree.points.iter().map(|(cell, point)| match point {
        Address::Output(number) => u128::from(machine.cell(*cell).int() != 0) << (number - 1),
        _ => 0,
    });
    outputs.sum()
}

/// Holds a project to what a text means, for so many scans; the outputs that have changed.
pub(crate) fn agree(name: &str, project: &str, text: &str, scans: u32) -> u128 {
    let made = import(project, large());
    let errors = made.diagnostics.iter();
    let errors = errors.filter(|told| told.severity() == Severity::Error);
    let told = said(&made.diagnostics);
    assert_eq!(errors.count(), 0, "{name}: {told:#?}\n{project}\n{text}");
    let (mut drawn, _) = made.program.unwrap();
    let written = compile_text(text, TextLanguage::St, large());
    let told = said(&written.diagnostics);
    let (mut written, _) = written
        .program
        .unwrap_or_else(|| panic!("{name}: {told:#?}"));
    let checked = check(text, TextLanguage::St, large());
    let tree = checked.tree.unwrap();
    let mut machine = Machine::new(&tree);
    let (mut drawn, mut written) = (Plc::new(drawn.lend()), Plc::new(written.lend()));
    let mut random = Random(name.len() as u64);
    let (mut inputs, mut now) = (Inputs::default(), 0);
    let mut changes = 0;
    let mut last = 0;
    for scan in 0..scans {
        for bit in 0..4 {
            if random.percent(20) {
                inputs.points = Image(inputs.points.0 ^ 1 << bit);
            }
        }
        if random.percent(30) {
            inputs.analogue[0] = random.below(1024) as u16;
        }
        now += random.below(25) as u32;
        set(&mut machine, &tree, &inputs);
        machine.scan(now.into()).unwrap();
        let wanted = outputs(&machine, &tree);
        let of_text = written.scan(inputs, now).unwrap().0;
        let of_project = drawn.scan(inputs, now).unwrap().0;
        assert_eq!(of_text, wanted, "{name}: the text, scan {scan}, {inputs:?}");
        assert_eq!(
            of_project, wanted,
            "{name}: scan {scan}, {inputs:?}\n{project}\n{text}"
        );
        changes |= wanted ^ last;
        last = wanted;
    }
    changes
}

/// The name, the project and the text of each pair.
pub(crate) fn projects() -> Vec<(String, String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/alike");
    let entries = fs::read_dir(folder).unwrap();
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "xml"));
    paths.sort();
    let pairs = paths.iter().map(|path| {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let text = fs::read_to_string(path.with_extension("st")).unwrap();
        (name.into_owned(), fs::read_to_string(path).unwrap(), text)
    });
    pairs.collect()
}

#[test]
fn projects_mean_what_their_texts_mean() {
    let projects = projects();
    assert!(!projects.is_empty());
    for (name, project, text) in projects {
        let changes = agree(&name, &project, &text, SCANS);
        assert_eq!(changes, 0b1111, "{name}: an output never changes");
    }
}
