//! What is written as Structured Text compiles, and does in each scan what the numeric code does.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use unoclp_checked::{Checked, numeric};
use unoclp_core::{Board, Inputs};
use unoclp_host_sim::engine::Machine;
use unoclp_host_sim::random::{Random, random_inputs, random_pause, random_program};
use unoclp_lang::{Code, Lang, Severity, TextLanguage, compile_text, to_st};
use unoclp_testing::{held, rounds};

/// A board with more memory than any: what is compiled again may be longer.
const LARGE: Board = Board {
    stored_bytes: 60_000,
    linked_bytes: 60_000,
    ..Board::UNO
};

const SCANS: u32 = 200;

/// What has come of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Came {
    /// It was written, and has done the same.
    Same,
    /// It was written, and takes more markers, registers or labels than a board has.
    TooMany,
    /// It was refused.
    Refused(u16),
}

/// Writes a program, compiles it again, and runs both side by side.
fn beside(name: &str, file: &[u8], seed: u64) -> Came {
    let (original, map) =
        numeric(file, LARGE).unwrap_or_else(|faults| panic!("{name}: {faults:?}"));
    let text = match to_st(original.program(), &map) {
        Ok(text) => text,
        Err(refused) => return Came::Refused(refused.code.number()),
    };
    let made = compile_text(&text, TextLanguage::St, LARGE);
    let errors = made
        .diagnostics
        .iter()
        .filter(|d| d.severity() == Severity::Error);
    let errors: Vec<_> = errors.collect();
    let few = [
        Code::BoardNoneLeft,
        Code::BoardRow,
        Code::BoardLabels,
        Code::BoardTooLarge,
    ];
    if !errors.is_empty() && errors.iter().all(|d| few.contains(&d.code)) {
        return Came::TooMany;
    }
    let told: Vec<String> = errors
        .iter()
        .map(|d| format!("{} {}", d.code, d.message(Lang::En)))
        .collect();
    let Some((again, _)) = made.program else {
        panic!(
            "{name}: {told:#?}\n{}\n{text}",
            String::from_utf8_lossy(file)
        );
    };
    run(name, &text, file, [original, again], seed);
    Came::Same
}

/// The numbers of the variables in this text that stand at such addresses under the address's own name.
fn at<'t>(text: &'t str, letter: &'t str, address: &'t str) -> impl Iterator<Item = u8> + 't {
    let lines = text
        .lines()
        .map(str::trim)
        .filter(move |line| line.starts_with(letter));
    lines.filter_map(move |line| {
        let (_, behind) = line.split_once(address)?;
        behind.split(' ').next()?.parse().ok()
    })
}

fn run(name: &str, text: &str, file: &[u8], programs: [Checked; 2], seed: u64) {
    let needs = programs[0].program().needs();
    let mut machines = programs.map(Machine::new);
    let markers = at(text, "M", "AT %MX").fold(0_u128, |mask, n| mask | 1 << (n - 1));
    let registers: Vec<u8> = at(text, "D", "AT %MD").collect();
    let random = &mut Random::new(seed);
    let (mut now, mut inputs) = (0, Inputs::default());
    for scan in 0..SCANS {
        inputs = random_inputs(random, needs, inputs);
        let scans = machines
            .each_mut()
            .map(|machine| machine.scan_observed(inputs, now, |_, _| ()));
        let [Ok(_), Ok(_)] = scans else {
            // What is compiled has another size, so its loops come to the limit elsewhere.
            return;
        };
        let seen = machines.each_ref().map(|machine| {
            let plc = machine.plc();
            let held: Vec<i32> = registers
                .iter()
                .map(|n| plc.registers()[usize::from(n - 1)])
                .collect();
            (
                plc.outputs(),
                [1, 4].map(|n| plc.pwm(n)),
                plc.markers() & markers,
                held,
            )
        });
        assert_eq!(
            seen[1],
            seen[0],
            "{name}, scan {scan}, {now} ms: registers {registers:?}, inputs {inputs:?}\n{}\n{text}",
            String::from_utf8_lossy(file)
        );
        now = now.wrapping_add(random_pause(random));
    }
}

#[test]
fn random_programs_do_the_same() {
    let programs = rounds(1_000);
    let mut came: BTreeMap<Came, u32> = BTreeMap::new();
    for seed in 0..programs {
        let same = held(|| {
            let file = random_program(&mut Random::new(seed.into()));
            beside(&format!("seed {seed}"), file.as_bytes(), 1)
        });
        *came.entry(same).or_default() += 1;
    }
    // They take any instruction as often as any other, those that Structured Text lacks too.
    let same = came.get(&Came::Same).copied().unwrap_or_default();
    assert!(same * 100 >= programs * 70, "{came:?}");
}

/// All programs in numeric code below this folder.
fn programs(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => programs(&path, into),
            false if path.extension().is_some_and(|end| end == "txt") => into.push(path),
            false => {}
        }
    }
}

#[test]
fn samples_and_tests_do_the_same() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut all = Vec::new();
    for folder in ["programs", "proof/suite"] {
        programs(&root.join(folder), &mut all);
    }
    let mut ran = 0;
    for path in all {
        let file = fs::read(&path).unwrap();
        // Some are there for their faults.
        if Checked::read(&file, LARGE).is_err() {
            continue;
        }
        ran += 1;
        let name = path.strip_prefix(&root).unwrap().display().to_string();
        assert_eq!(beside(&name, &file, 1), Came::Same, "{name}");
    }
    assert!(ran > 80, "{ran}");
}

/// What a person reads: the samples in `tests/to_st`.
#[test]
fn samples_are_written_as_they_shall_be() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut all = Vec::new();
    for entry in fs::read_dir(root.join("tests/to_st")).unwrap() {
        all.push(entry.unwrap().path());
    }
    assert!(all.len() > 3);
    for path in all {
        let name = path
            .file_stem()
            .unwrap()
            .to_str()
            .unwrap()
            .replacen('-', "/", 1);
        let file = fs::read(
            root.join("../../programs")
                .join(&name)
                .with_extension("txt"),
        )
        .unwrap();
        let (program, map) = numeric(&file, Board::UNO).unwrap();
        let text = to_st(program.program(), &map).unwrap();
        let expected = fs::read_to_string(&path).unwrap();
        assert_eq!(
            text,
            expected,
            "if this is right: unoclp list programs/{name}.txt --as st > {}\n{text}",
            path.display()
        );
    }
}

/// The refusal of this program: its code and its line.
fn refused(file: &str) -> (u16, String) {
    let (program, map) = numeric(file.as_bytes(), Board::UNO).unwrap();
    let refused = to_st(program.program(), &map).expect_err(file);
    (refused.code.number(), refused.message(Lang::En))
}

#[test]
fn what_has_no_words_is_refused_with_its_line() {
    let retentive = refused("0\n827301\n847982\n5\n7901\n");
    assert_eq!(retentive.0, 221);
    assert!(retentive.1.starts_with("line 3: "), "{retentive:?}");
    let into = refused("0\n827301\n74778001\n787600\n827302\n7370\n766601\n877901\n697868\n");
    assert_eq!(into.0, 222);
    assert!(into.1.starts_with("line 3: "), "{into:?}");
    let looped = refused("0\n766601\n827301\n847978\n5\n7901\n74778001\n");
    assert_eq!(looped.0, 223);
    let early = refused("0\n76688401\n838401\n787600\n827301\n847978\n5\n7901\n");
    assert_eq!(early.0, 224);
    let part = refused("0\n756802\n766800\n0\n76688801\n3\n838404\n");
    assert_eq!(part.0, 226);
}
