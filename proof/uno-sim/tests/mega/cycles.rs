//! How fast a Mega is, counted from one `scan_begin` to the next.

use crate::common::{card, to_run, uno};
use unoclp_uno_sim::{CYCLES_PER_MS, Slot, Uno};

/// The longest scan that is waited for, cycles.
const LONGEST: u64 = 10 * CYCLES_PER_MS;
/// Scans that are looked at.
const SCANS: usize = 200;

/// A Mega that runs this.
fn running(text: &str) -> Uno {
    let mut mega = uno(Slot::Card(card(text)));
    to_run(&mut mega);
    mega.run_ms(20).unwrap();
    mega
}

/// Cycles of the shortest scan and of the mean one.
fn scans(text: &str) -> [u64; 2] {
    let mut mega = running(text);
    let begin = mega.symbol("scan_begin").unwrap().address;
    mega.run_until(begin, LONGEST).unwrap();
    let lengths: Vec<u64> = (0..SCANS)
        .map(|_| {
            let begun = mega.cycles();
            mega.run_until(begin, LONGEST).unwrap();
            mega.cycles() - begun
        })
        .collect();
    let sum: u64 = lengths.iter().sum();
    [*lengths.iter().min().unwrap(), sum / SCANS as u64]
}

/// Rungs of four contacts and a coil, of these points.
fn rungs(count: usize, inputs: [u8; 4], output: u8) -> String {
    let contacts = inputs.map(|input| format!("8273{input:02}\n")).concat();
    let rung = format!("787600\n{contacts}8779{output:02}\n");
    format!("0\n{}", rung.repeat(count))
}

/// Cycles that one such rung adds to the shortest scans.
fn rung(inputs: [u8; 4], output: u8) -> u64 {
    let [few, many] = [10, 100].map(|count| scans(&rungs(count, inputs, output))[0]);
    (many - few) / 90
}

#[test]
fn a_rung_of_four_contacts_and_a_coil() {
    let near = rung([1, 2, 3, 4], 1);
    let beyond = rung([9, 10, 11, 12], 9);
    println!("inputs 01 to 04, output 01: {near} cycles; inputs 09 to 12, output 09: {beyond}");
    assert!(near <= 20, "{near}");
}

/// All inputs are read and all outputs are written in it.
#[test]
fn a_small_scan() {
    let [least, mean] = scans("0\n827301\n827302\n877901\n");
    println!("two contacts and a coil: {least} cycles at least, {mean} in the mean");
    assert!(mean <= 250, "{mean}");
}
