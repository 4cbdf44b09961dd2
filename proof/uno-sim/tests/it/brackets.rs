//! What the brackets of NC-28 save: programs with them, beside the same programs with jumps.

use crate::common;
use std::fs;
use std::path::Path;
use unoclp_exercise::scenario::{ProgramFile, Scenario, check};
use unoclp_host_sim::engine::{Engine, HostEngine};
use unoclp_program::{Source, Written};
use unoclp_testing::in_languages;
use unoclp_uno_sim::CYCLES_PER_MS;
use unoclp_uno_sim::engine::{Clock, UnoEngine};

/// Scans of which the shortest is taken: more than there are in some milliseconds, so some have nothing beside them.
const SCANS: u32 = 500;

/// The lines of a program with a jump and a label for each bracket; none where it has no IF.
fn by_jumps(code: &str) -> Option<String> {
    let (mut lines, mut open, mut label) = (Vec::new(), Vec::new(), 32);
    for line in code.lines() {
        let text = line.split('/').next().unwrap_or_default().trim();
        let mut new = || {
            label -= 1;
            label + 1
        };
        match text {
            "7370" => {
                let behind = new();
                open.push(behind);
                lines.push(format!("-747780{behind:02}"));
            }
            "697683" => {
                let (other, behind) = (open.pop()?, new());
                open.push(behind);
                lines.extend(["787600".into(), format!("747780{behind:02}")]);
                lines.extend(["787600".into(), format!("7666{other:02}")]);
            }
            "697868" => {
                let behind = open.pop()?;
                lines.extend(["787600".into(), format!("7666{behind:02}")]);
            }
            _ => lines.push(text.to_owned()),
        }
    }
    (label < 32).then(|| lines.join("\n"))
}

fn checked(name: &str, bytes: Vec<u8>) -> Source {
    let source = Written::new(name.to_owned(), bytes, unoclp_core::Board::UNO).check(None);
    source.unwrap_or_else(|refused| panic!("{refused:?}"))
}

/// Cycles of the shortest scan with no input on.
fn cycles(board: &mut UnoEngine, source: &Source) -> u64 {
    board.load(&source.code).unwrap().unwrap();
    let uno = board.uno().unwrap();
    let begin = uno.symbol("scan_begin").unwrap().address;
    let scans = (0..SCANS).map(|_| {
        let begun = uno.cycles();
        uno.run_until(begin, 50 * CYCLES_PER_MS).unwrap();
        uno.cycles() - begun
    });
    scans.min().unwrap()
}

/// The table of `docs/decisions.md`, which this prints. Its cycles are those of the firmware of that day.
#[test]
fn brackets_take_less_than_jumps() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/decisions.md");
    let page = fs::read_to_string(page).unwrap();
    let mut board = UnoEngine::new(common::firmware(), Clock::Running).unwrap();
    let mut count = 0;
    for twins in in_languages() {
        for end in ["txt", "st"] {
            let path = twins.text(end);
            let name = format!("{}.{end}", twins.name);
            let brackets = checked(&name, fs::read(&path).unwrap());
            let code = String::from_utf8(brackets.code.clone()).unwrap();
            let Some(code) = by_jumps(&code) else {
                continue;
            };
            let jumps = checked("by jumps.txt", code.into_bytes());
            let program = ProgramFile {
                name: jumps.name.clone(),
                bytes: jumps.code.clone(),
            };
            let scenario =
                Scenario::load_for(&twins.scenario(), program, unoclp_core::Board::UNO).unwrap();
            let report = check(&scenario, &mut HostEngine::new(unoclp_core::Board::UNO));
            assert!(report.passed(), "{name}: {report}");

            let both = [&brackets, &jumps];
            let [stored, stored_by_jumps] = both.map(|source| source.size.stored_bytes);
            let [run, run_by_jumps] = both.map(|source| source.size.linked_bytes);
            let [least, least_by_jumps] = both.map(|source| cycles(&mut board, source));
            let sizes =
                format!("| `{name}` | {stored} | {stored_by_jumps} | {run} | {run_by_jumps} |");
            println!("{sizes} {least} | {least_by_jumps} |");
            assert!(stored < stored_by_jumps && run < run_by_jumps, "{name}");
            assert!(least <= least_by_jumps, "{name}: {least}, {least_by_jumps}");
            assert!(page.contains(&sizes), "docs/decisions.md needs {sizes}");
            count += 1;
        }
    }
    assert!(count >= 6, "{count}");
}
