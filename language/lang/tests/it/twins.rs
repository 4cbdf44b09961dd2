//! Each sample program has a twin in Instruction List that behaves alike.

use crate::common::{LARGE, Random, large, plc, program};
use std::fs;
use std::path::Path;
use unoclp_core::Image;
use unoclp_testing::held;

#[test]
fn twins_behave_alike() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs");
    let mut count = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let is_program = path.extension().is_some_and(|end| end == "txt");
        let Some(name) = path.file_stem().filter(|_| is_program) else {
            continue;
        };
        count += 1;
        let by_hand = fs::read_to_string(&path).unwrap();
        let text = fs::read_to_string(path.with_extension("il"))
            .unwrap_or_else(|error| panic!("{} has no twin: {error}", path.display()));
        let compiled = program(&text, &large()).file().unwrap();
        // Of the traffic light Q4 is spare: it is where the timers of the one by hand put their Q.
        let outputs = if name == "traffic" { 0b0111 } else { 0b1111 };
        for seed in 0..20 {
            held(|| {
                let (mut first, mut second) = (vec![0; 2000], vec![0; 2000]);
                let mut by_hand = plc(&by_hand, &mut first, LARGE);
                let mut compiled = plc(&compiled, &mut second, LARGE);
                let mut random = Random(seed);
                let (mut now, mut inputs) = (0, 0);
                for _ in 0..3000 {
                    let expected = by_hand.scan(Image(inputs), now).unwrap().0 & outputs;
                    let came = compiled.scan(Image(inputs), now).unwrap().0 & outputs;
                    assert_eq!(came, expected, "{name:?}, seed {seed}, {now} ms");
                    now += random.pick(&[1, 5, 50, 500, 2000]);
                    if random.percent(40) {
                        inputs ^= 1 << random.below(4);
                    }
                }
            });
        }
    }
    assert!(count >= 11, "{count}");
}
