//! A scan in slow motion: at each seam of each program of the project, the firmware stands as the core does.

use crate::{BOARD, common};
use std::path::{Path, PathBuf};
use unoclp_core::isa::Opcode;
use unoclp_core::{Inputs, Scan};
use unoclp_host_sim::engine::{Engine, HostEngine};
use unoclp_host_sim::random::{Random, random_inputs_on, random_program_on};
use unoclp_program::Written;
use unoclp_testing::{held, rounds};
use unoclp_uno_sim::avr8js::{Avr8js, Seam};
use unoclp_uno_sim::engine::{Clock, FirmwareEngine};

/// Scans of each program, and random programs.
const SCANS: u32 = 4;
const PROGRAMS: u32 = 60;

#[test]
fn each_program_stands_at_each_seam_as_the_core_does() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs");
    let mut files = Vec::new();
    collect(&root, &mut files);
    let mut slow = SlowMotion::new();
    let mut compared = 0;
    for file in &files {
        let name = file.to_string_lossy().into_owned();
        let bytes = std::fs::read(file).unwrap();
        let written = Written::new(name.clone(), bytes, BOARD);
        let Ok(source) = written.check(None) else {
            continue;
        };
        compared += usize::from(slow.compare(&source.code, &name));
    }
    assert!(
        compared > 100,
        "only {compared} of {} programs",
        files.len()
    );
    assert!(slow.seams > 20 * compared, "{} seams", slow.seams);
}

#[test]
fn random_programs_stand_at_each_seam_as_the_core_does() {
    let mut slow = SlowMotion::new();
    let mut run = |seed: u32| {
        let program = random_program_on(&mut Random::new(seed.into()), BOARD);
        slow.compare(program.as_bytes(), &format!("seed {seed}:\n{program}"));
    };
    (0..rounds(PROGRAMS)).for_each(|seed| held(|| run(seed)));
}

/// The firmware on the page's board, and what has been compared.
struct SlowMotion {
    uno: FirmwareEngine<Avr8js>,
    seams: usize,
}

impl SlowMotion {
    fn new() -> SlowMotion {
        SlowMotion {
            uno: FirmwareEngine::new(common::firmware(), Clock::Lockstep).unwrap(),
            seams: 0,
        }
    }

    /// Compares some scans of a program, unless the board refuses it.
    fn compare(&mut self, file: &[u8], name: &str) -> bool {
        let mut host = HostEngine::new(BOARD);
        let (Ok(Ok(())), Ok(Ok(()))) = (host.load(file), self.uno.load(file)) else {
            return false;
        };
        self.uno.uno().unwrap().go_slowly().unwrap();
        let random = &mut Random::new(file.len() as u64);
        let plc = host.machine().unwrap().plc();
        let needs = plc.needs();
        let opcodes: Vec<Opcode> = plc.steps().map(|step| step.opcode).collect();
        let (mut inputs, mut now) = (Inputs::default(), 0);
        for scan in 0..SCANS {
            inputs = random_inputs_on(random, (needs, BOARD), inputs);
            now += random.below(40);
            let expected = stands(&mut host, inputs, now);
            let came = self.uno.scan(&inputs, now).unwrap();
            let seams = self.uno.uno().unwrap().trail().unwrap();
            self.seams += seams.len();
            alike(&seams, &expected, &opcodes, &format!("{name}, scan {scan}"));
            if came.is_err() {
                break;
            }
        }
        true
    }
}

/// How the core stands before each instruction of a scan that it runs, and after the last.
fn stands(host: &mut HostEngine, inputs: Inputs, now: u32) -> Vec<Seam> {
    let mut stands = Vec::new();
    host.with_plc(|plc| {
        let stand = |scan: &Scan| {
            let found = scan.found();
            Seam {
                step: scan.next(),
                acc: found.acc,
                pushed: scan.pushed().len() as u8,
                value: found.value,
            }
        };
        let mut scan = plc.begin(inputs, now);
        stands.push(stand(&scan));
        while let Ok(Some(_)) = plc.step(&mut scan) {
            stands.push(stand(&scan));
        }
    });
    stands
}

/// Each seam is one of the core's, in their order. The engine runs labels, ELS and END where it jumps to one, and they make
/// acc 1; the core passes over them, so they are not compared: it may come to the same one later, in another turn of a loop.
fn alike(seams: &[Seam], core: &[Seam], opcodes: &[Opcode], name: &str) {
    let mut rest = core.iter();
    for seam in seams {
        let joins = matches!(
            opcodes.get(seam.step),
            Some(Opcode::Label | Opcode::Else | Opcode::EndIf)
        );
        if joins {
            continue;
        }
        match rest.find(|core| core.step == seam.step) {
            Some(core) => assert_eq!(seam, core, "{name}"),
            None => panic!("{name}: the core is never at {seam:?}: {core:?}"),
        }
    }
    assert!(!seams.is_empty(), "{name}: no seam");
}

/// The programs below a folder.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.extension().and_then(|end| end.to_str()) {
            _ if path.is_dir() => collect(&path, files),
            Some("txt" | "il" | "st" | "scl" | "iscl" | "lce") => files.push(path),
            _ => {}
        }
    }
}
