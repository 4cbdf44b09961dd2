//! What is exported is imported again as the same program.

use std::fs;
use std::path::{Path, PathBuf};
use unoclp_core::{Board, Loader};
use unoclp_draw::edit::Document;
use unoclp_host_sim::random::{Random, random_program};
use unoclp_lang::Code;
use unoclp_plcopen::{Exported, export, export_blocks, import};

/// The document of a program file; none where a board refuses it.
pub(crate) fn document(file: &[u8]) -> Option<Document> {
    let mut memory = vec![0; usize::from(Board::UNO.linked_bytes)];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    file.iter().try_for_each(|&byte| loader.push(byte)).ok()?;
    let program = loader.finish().ok()?;
    Some(Document::of_steps(program.steps()))
}

/// Exports a document, which comes back as it was; whether a ladder holds it, and no Instruction List has to.
pub(crate) fn comes_back(document: &Document) -> bool {
    is_back(document, export(document, "test", Board::UNO))
}

/// The same as a block diagram; whether one holds it.
fn comes_back_as_blocks(document: &Document) -> bool {
    is_back(document, export_blocks(document, "test", Board::UNO))
}

fn is_back(document: &Document, exported: Result<Exported, Vec<unoclp_plcopen::Lost>>) -> bool {
    let exported = exported.unwrap_or_else(|lost| panic!("{lost:?}"));
    let fine = |lost: &unoclp_plcopen::Lost| (1..=document.rungs().len()).contains(&lost.rung);
    assert!(exported.beyond.iter().all(fine), "{:?}", exported.beyond);
    let text = exported.text;
    let made = import(&text, Board::UNO);
    let (program, _) = made.program.unwrap_or_else(|| panic!("{text}"));
    if let (false, Some(document_of)) = (exported.beyond.is_empty(), &made.document) {
        assert_eq!(said(document_of), said(document), "{text}");
        return false;
    }
    if !exported.beyond.is_empty() {
        let steps = program.program().steps();
        let codes: Vec<i32> = steps.flat_map(|step| step.codes()).collect();
        assert_eq!(codes, document.codes().unwrap()[1..], "{text}");
        return false;
    }
    // A rung without an output, a label without a jump and a program without a point are told, and come back.
    let idle = [Code::XmlNoSink, Code::XmlNoJump, Code::XmlNoPoint];
    let mut told = made.diagnostics.iter();
    assert!(
        told.all(|told| idle.contains(&told.code)),
        "{:?}\n{text}",
        made.diagnostics
    );
    assert_eq!(said(&made.document.unwrap()), said(document), "{text}");
    true
}

/// Its instructions, but for the beginning of rungs on which nothing stands.
fn said(document: &Document) -> Vec<Vec<i32>> {
    let instructions = document.instructions().unwrap();
    let lines: Vec<_> = instructions.into_iter().map(|(_, lines)| lines).collect();
    let rungs = lines.split(|lines| lines[..] == [787_600]);
    let rungs: Vec<_> = rungs.filter(|rung| !rung.is_empty()).collect();
    rungs.join(&vec![787_600])
}

fn programs(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            programs(&path, found);
        } else if path.extension().is_some_and(|end| end == "txt") {
            found.push(path);
        }
    }
}

/// Those that become Instruction List, since no ladder of PLCopen XML has a form for what they hold: IF, REAL numbers, tables, settings, presets that change, the first
/// scan, readings in markers, counters that something else sets.
const IN_LIST: [&str; 17] = [
    "08-bounds.txt",
    "08-parking.txt",
    "10-crossing.txt",
    "10-flicker.txt",
    "11-set-point.txt",
    "11-thermometer.txt",
    "12-mean.txt",
    "12-restless.txt",
    "13-boiler.txt",
    "13-current.txt",
    "average.txt",
    "dosing.txt",
    "oven.txt",
    "pressure.txt",
    "spread.txt",
    "tank.txt",
    "volume.txt",
];

/// Those that a ladder holds and no block diagram.
const NO_BLOCKS: [&str; 0] = [];

#[test]
fn the_sample_programs_come_back() {
    let mut paths = Vec::new();
    programs(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs"),
        &mut paths,
    );
    let (mut same, mut in_list) = (0, Vec::new());
    let mut no_blocks = Vec::new();
    for path in &paths {
        let Some(document) = document(&fs::read(path).unwrap()) else {
            continue;
        };
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        match comes_back(&document) {
            true if !comes_back_as_blocks(&document) => {
                same += 1;
                no_blocks.push(name);
            }
            true => same += 1,
            false => in_list.push(name),
        }
    }
    in_list.sort();
    assert_eq!(in_list, IN_LIST);
    no_blocks.sort();
    assert_eq!(no_blocks, NO_BLOCKS);
    assert!(same >= 61, "{same}");
}

#[test]
fn random_programs_come_back() {
    let (mut drawn, mut as_blocks) = (0, 0);
    let rounds = unoclp_testing::rounds(1_000);
    for seed in 0..rounds {
        let [ladder, blocks] = unoclp_testing::held(|| {
            let file = random_program(&mut Random::new(seed.into()));
            let document = document(file.as_bytes()).unwrap();
            [comes_back(&document), comes_back_as_blocks(&document)]
        });
        drawn += u32::from(ladder);
        as_blocks += u32::from(blocks);
    }
    println!("all of {rounds} come back, {drawn} as a ladder, {as_blocks} as a block diagram");
    // A rung without an output has no place in a block diagram.
    assert!(
        as_blocks > 0 && as_blocks >= drawn * 9 / 10,
        "{as_blocks} of {drawn}"
    );
}

#[test]
fn a_timer_that_is_called_again_comes_back() {
    // A list holds the second call.
    for (first, target) in [(1000, 7901), (1000, 7701), (0, 7701)] {
        for second in [1000, 2000] {
            let file = format!(
                "0\n827301\n847978\n{first}\n{target}\n787600\n827302\n847978\n{second}\n8401\n787600\n828401\n877902\n"
            );
            let document = document(file.as_bytes()).unwrap();
            assert!(!comes_back(&document) && !comes_back_as_blocks(&document));
            let lost = export(&document, "test", Board::UNO).unwrap().beyond;
            let lost: Vec<(usize, &str)> = lost.iter().map(|l| (l.rung, &*l.what)).collect();
            assert_eq!(lost, [(2, "TON, 8401")]);
        }
    }
}

#[test]
fn a_counter_of_several_rungs_is_one_block() {
    let rungs = [
        "827301\n67848501\n5",
        "827302\n67846801\n5",
        "827304\n83876701",
        "827303\n82876701",
        "826701\n877901",
        "829001\n877902",
    ];
    let of = |rungs: &[&str]| document(format!("0\n{}\n", rungs.join("\n787600\n")).as_bytes());
    let counter = of(&rungs).unwrap();
    let text = export(&counter, "test", Board::UNO).unwrap().text;
    assert_eq!(text.matches("typeName=\"CTUD\"").count(), 1, "{text}");
    assert!(comes_back(&counter));
    // Without some of its inputs, and where another rung stands between them.
    for left in [[0, 2, 4], [1, 3, 5], [0, 3, 5]] {
        assert!(comes_back(&of(&left.map(|rung| rungs[rung])).unwrap()));
    }
    assert!(!comes_back(&of(&[rungs[0], rungs[4], rungs[1]]).unwrap()));
}
