//! Random function block diagrams: what the board does beside what a naive interpreter does, which computes them as OpenPLC
//! Editor and Beremiz write them down.

mod made;
mod model;
mod naive;
mod xml;

use crate::project;
use made::random_diagram;
use model::{BITS, NUMBERS};
use naive::Naive;
use unoclp_core::{Board, Image, Inputs, Plc};
use unoclp_lang::Lang;
use unoclp_plcopen::import;
use unoclp_testing::Random;

/// The outputs of a scan, bit 0 of each; then the numbers, as far as an output shows them.
const SCANS: u32 = 60;

fn large() -> Board {
    Board {
        stored_bytes: 30_000,
        linked_bytes: 30_000,
        ..*Board::ALL.last().unwrap()
    }
}

/// A project of one random diagram.
pub(crate) fn random_project(random: &mut Random) -> String {
    let diagram = random_diagram(random, true);
    project(&diagram.variables(), &diagram.body())
}

#[test]
fn random_diagrams_do_what_openplc_makes_of_them() {
    let (mut changed, mut ladders) = (0, 0);
    for seed in 0..unoclp_testing::rounds(400) {
        let mut random = Random(u64::from(seed) + 1);
        // Half of them may be ladders.
        let diagram = random_diagram(&mut random, seed % 2 == 1);
        let text = project(&diagram.variables(), &diagram.body());
        let made = import(&text, large());
        let told: Vec<String> = made
            .diagnostics
            .iter()
            .map(|told| format!("{} {}", told.code, told.message(Lang::En)))
            .collect();
        let Some((mut program, _)) = made.program else {
            panic!("seed {seed}: {told:#?}\n{text}");
        };
        ladders += usize::from(made.document.is_some());
        let mut plc = Plc::new(program.lend());
        let mut naive = Naive::new(&diagram);
        let (mut inputs, mut now, mut last) = (0_u128, 0_u32, 0);
        for scan in 0..SCANS {
            inputs ^= random.turns(BITS, 25);
            now += random.below(25) as u32;
            let wanted = naive.scan(inputs, now.into());
            let image = Inputs {
                points: Image(inputs),
                ..Inputs::default()
            };
            let got = plc.scan(image, now).unwrap().0;
            assert_eq!(
                got, wanted,
                "seed {seed}, scan {scan}, inputs {inputs:b}, {now} ms\n{text}"
            );
            changed |= got ^ last;
            last = got;
        }
    }
    assert!(
        ladders > 0 || unoclp_testing::rounds(400) < 400,
        "no diagram is a ladder"
    );
    // Numbers are shown by comparisons with a constant.
    assert_eq!(
        changed,
        (1 << (BITS + NUMBERS)) - 1,
        "an output never changes"
    );
}
