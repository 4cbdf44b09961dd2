//! A fault at every command and at every block of a start-up, of every kind: it ends in the right
//! program or in a fault with the outputs off, never in anything else.

use crate::common::{card, to_run, uno};
use unoclp_testing::cases;
use unoclp_uno_sim::sd::{At, What};
use unoclp_uno_sim::{CYCLES_PER_MS, EEPROM_WRITE_CYCLES, Pin, Slot};

/// The longest start-up, ms, beside what the EEPROM takes.
const LONGEST: u64 = 3000;

#[test]
fn every_fault_at_every_command_and_block() {
    // Output 01 follows input 01; comments make it several blocks long.
    let text = "0\n".to_string() + &"/ nothing but a comment\n".repeat(50) + "827301\n877901\n";
    let (commands, blocks) = {
        let mut healthy = uno(Slot::Card(card(&text)));
        to_run(&mut healthy);
        let log = healthy.card().unwrap().log();
        (log.commands.len(), log.blocks_read as usize)
    };
    let kinds = [
        What::NoAnswer,
        What::WrongCrc,
        What::WrongToken,
        What::Removed,
        What::Garbage,
    ];
    let places = (0..commands)
        .map(At::Command)
        .chain((0..blocks).map(At::Block));
    let all = (commands + blocks) * kinds.len();
    let (mut runs, mut faults, mut slowest) = (0, 0, 0);
    for (at, what) in cases(places.flat_map(|at| kinds.map(|what| (at, what)))) {
        let case = format!("{what:?} at {at:?}");
        let mut uno = uno(Slot::Card(card(&text).with_fault(at, what)));
        let mut ms = 0;
        while !["\r\nfault ", "RUN\r\n"]
            .iter()
            .any(|end| uno.serial().contains(end))
        {
            uno.run_ms(1).unwrap();
            let written = uno.eeprom_writes().len() as u64 * EEPROM_WRITE_CYCLES;
            ms = (uno.cycles() - written) / CYCLES_PER_MS;
            assert!(ms <= LONGEST, "{case}: {:?} after {ms} ms", uno.serial());
        }
        slowest = slowest.max(ms);
        let moved = uno.edges().iter().any(|edge| edge.pin != Pin::Led);
        assert!(!moved, "{case}: an output moved before the first scan");
        uno.set_inputs(0b1111);
        uno.run_ms(20).unwrap();
        if uno.serial().contains("RUN\r\n") {
            runs += 1;
            assert_eq!(uno.outputs(), 0b0001, "{case}: {:?}", uno.serial());
        } else {
            faults += 1;
            assert_eq!(uno.outputs(), 0, "{case}: {:?}", uno.serial());
        }
    }
    println!(
        "{} of {all} faults: {runs} ended in RUN of the right program, {faults} in a fault; the slowest after {slowest} ms",
        runs + faults
    );
    assert!(runs > 0 && faults > 0);
}
