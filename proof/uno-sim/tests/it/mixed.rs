//! Random projects with bodies in all five languages: the firmware does what the core does, and what the core makes of the same
//! in Structured Text, scan by scan.

use crate::common;
use crate::starts::Starts;
use crate::typed::board::with_plc;
use unoclp_core::{Board, Image, Inputs};
use unoclp_host_sim::engine::Engine;
use unoclp_lang::{TextLanguage, compile_text};
use unoclp_plcopen::import;
use unoclp_testing::{Random, held, mixed_project, rounds};
use unoclp_uno_sim::Uno;
use unoclp_uno_sim::avr8js::Avr8js;
use unoclp_uno_sim::engine::{Clock, FirmwareEngine};

const PROJECTS: u32 = 500;
/// There a project takes longer.
const ON_AVR8JS: u32 = 150;
const SCANS: u32 = 20;

/// Holds the project of this seed to its text; none where the board has no room for one of them.
fn compared<S: Starts>(uno: &mut FirmwareEngine<S>, seed: u64) -> Option<()> {
    let (project, text) = mixed_project(seed);
    let (mut drawn, _) = import(&project, Board::UNO).program?;
    let (mut written, _) = compile_text(&text, TextLanguage::St, Board::UNO).program?;
    let started = S::start(uno, drawn.program()).unwrap();
    assert!(started.is_ok(), "seed {seed}: {started:?}\n{project}");
    with_plc(&mut drawn, |drawn| {
        with_plc(&mut written, |written| {
            let random = &mut Random(seed ^ 0x3A17);
            let mut now = random.below(1 << 31) as u32;
            let mut points = 0;
            for scan in 0..SCANS {
                points ^= random.turns(4, 25);
                let inputs = Inputs {
                    points: Image(points),
                    ..Inputs::default()
                };
                let came = uno.scan(&inputs, now).unwrap().ok();
                assert!(drawn.scan(inputs, now).is_ok() && written.scan(inputs, now).is_ok());
                let told = format!("seed {seed}, scan {scan}, {now} ms\n{project}\n{text}");
                assert_eq!(came, Some(drawn.outputs()), "{told}");
                assert_eq!(came, Some(written.outputs()), "{told}");
                now += random.below(30) as u32;
            }
        });
    });
    Some(())
}

#[test]
fn random_projects_of_all_languages_are_alike_on_the_firmware() {
    compare::<Uno>(PROJECTS);
}

/// The same projects on avr8js, which the page runs the firmware on.
#[test]
fn random_projects_of_all_languages_are_alike_on_avr8js() {
    compare::<Avr8js>(ON_AVR8JS);
}

fn compare<S: Starts>(projects: u32) {
    let projects = rounds(projects);
    let mut uno = FirmwareEngine::<S>::new(common::firmware(), Clock::Lockstep).unwrap();
    let seeds = (0..).take(4 * projects as usize);
    let ran = seeds.filter_map(|seed| held(|| compared(&mut uno, seed)));
    let ran = ran.take(projects as usize).count();
    assert_eq!(ran, projects as usize);
}
