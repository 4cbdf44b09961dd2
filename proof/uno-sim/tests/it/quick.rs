//! Many instructions at once are the same as simavr's own steps, one after the other, on the firmware.

use crate::common;
use std::path::Path;
use unoclp_testing::Random;
use unoclp_uno_sim::{RAM_END, Slot, Uno};

/// Cycles from power-up: the card is read, and thousands of scans run.
const SPAN: u64 = 40_000_000;
/// Timers and counters; whole numbers; REAL.
const PROGRAMS: [&str; 3] = [
    "programs/traffic.txt",
    "programs/languages/average.txt",
    "programs/languages/oven.txt",
];

/// All that a program can see of the chip, and what others see of the board.
fn assert_same(quick: &Uno, slow: &Uno, name: &str) {
    let at = slow.cycles();
    assert_eq!(quick.cycles(), at, "{name}");
    assert_eq!(quick.pc(), slow.pc(), "{name} at {at}");
    let [ours, theirs] = [quick, slow].map(|uno| uno.read_ram(0, RAM_END as usize + 1).unwrap());
    let other = ours.iter().zip(theirs).position(|(a, b)| a != b);
    assert_eq!(other, None, "{name} at {at}: the first byte that differs");
    assert_eq!(quick.edges(), slow.edges(), "{name} at {at}");
    assert_eq!(quick.serial_log(), slow.serial_log(), "{name} at {at}");
    assert_eq!(quick.min_sp(), slow.min_sp(), "{name} at {at}");
}

#[test]
fn the_firmware_does_the_same_one_step_after_the_other() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let random = &mut Random(7);
    for name in PROGRAMS {
        let text = std::fs::read_to_string(root.join(name)).unwrap();
        let [mut quick, mut slow] = [(); 2].map(|()| common::uno(Slot::Card(common::card(&text))));
        while slow.cycles() < SPAN {
            let cycles = 1 + random.below(20_000) as u64;
            let end = slow.cycles() + cycles;
            quick.run_cycles(cycles).unwrap();
            while slow.cycles() < end {
                slow.step().unwrap();
            }
            assert_same(&quick, &slow, name);
            let inputs = random.bits() as u8;
            // A request for the coils, whole or not, comes in between.
            let request = common::modbus::with_crc(&[1, 1, 0, 0, 0, random.below(9) as u8]);
            for uno in [&mut quick, &mut slow] {
                uno.set_inputs(inputs);
                if cycles < 2_000 {
                    uno.send_serial(&request);
                }
            }
        }
    }
}
