//! How fast a Mega is, counted from one `scan_begin` to the next.

use crate::BOARD;
use crate::common::{card, to_run, uno};
use unoclp_checked::Checked;
use unoclp_uno_sim::{CYCLES_PER_MS, Slot, Uno};

/// The longest scan that is waited for, cycles.
const LONGEST: u64 = 10 * CYCLES_PER_MS;
/// Scans that are looked at.
const SCANS: usize = 200;

/// A Mega that runs this.
fn running(text: &str) -> Uno {
    let mut mega = uno(Slot::Card(card(text)));
    to_run(&mut mega);
    // A long one is linked first.
    mega.run_ms(200).unwrap();
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
    let rungs = [
        ([1, 2, 3, 4], 1, 20),
        ([5, 6, 7, 8], 4, 20),
        ([2, 4, 5, 7], 2, 20),
        ([1, 2, 3, 4], 5, 30),
        ([5, 6, 7, 8], 8, 30),
        ([9, 10, 11, 12], 9, 30),
        ([13, 14, 15, 16], 1, 30),
        ([17, 20, 22, 24], 16, 30),
    ];
    for (inputs, output, most) in rungs {
        let cycles = rung(inputs, output);
        println!("inputs {inputs:?}, output {output}: {cycles} cycles");
        assert!(
            cycles <= most,
            "inputs {inputs:?}, output {output}: {cycles}"
        );
    }
}

#[test]
fn a_whole_scan_of_500_such_rungs() {
    let [least, mean] = scans(&rungs(500, [9, 10, 11, 12], 9));
    println!("500 rungs: {least} cycles at least, {mean} in the mean");
    assert!(mean <= CYCLES_PER_MS, "{mean}");
}

/// From its first instruction, with a program of full size that is kept, and no card.
#[test]
fn a_program_of_full_size_runs_within_a_second() {
    let timers = "787600\n847978\n100000\n7901\n".repeat(60);
    let begun = format!("0\n{timers}");
    let bytes = |text: &str| {
        let checked = Checked::read(text.as_bytes(), BOARD).unwrap();
        checked.program().stored_bytes()
    };
    let room = usize::from(BOARD.stored_bytes) - bytes(&begun);
    let text = begun + &"827301\n877901\n".repeat(room / 2);
    println!("{} B", bytes(&text));
    assert!(bytes(&text) + 2 > usize::from(BOARD.stored_bytes));
    let mut mega = uno(Slot::Card(card(&text)));
    to_run(&mut mega);
    mega.swap_slot(Slot::Empty);
    mega.power_up();
    let begun = mega.cycles();
    let begin = mega.symbol("scan_begin").unwrap().address;
    mega.run_until(begin, 2000 * CYCLES_PER_MS).unwrap();
    let ms = (mega.cycles() - begun) / CYCLES_PER_MS;
    println!("{ms} ms to the first scan");
    assert!(ms <= 1000, "{ms}");
}

/// All inputs are read and all outputs are written in it.
#[test]
fn a_small_scan() {
    let [least, mean] = scans("0\n827301\n827302\n877901\n");
    println!("two contacts and a coil: {least} cycles at least, {mean} in the mean");
    assert!(mean <= 250, "{mean}");
}
