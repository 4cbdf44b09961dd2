//! STATE.TXT: where it may lie, what it says, and when it is written.

use crate::common::modbus::words;
use crate::common::state::{
    FOLLOW, KEPT, Saved, assert_only_state_changed, run_to_save, running, saves, state_card,
    template,
};
use crate::common::{card, firmware, to_run};
use unoclp_card::image::{Fat, Image};
use unoclp_uno_sim::sd::{Kind, SdCard};
use unoclp_uno_sim::{CYCLES_PER_MS, Slot, Uno};

const SECOND: u64 = 1000 * CYCLES_PER_MS;
/// A save is over so long after it began, with a card that is quickly ready.
const SAVE: u64 = 50 * CYCLES_PER_MS;

/// Where STATE.TXT may stand on a card.
type Case = (&'static str, fn(Image) -> Image);

const CASES: &[Case] = &[
    ("the template", |image| image.file("STATE.TXT", template())),
    ("lower case", |image| image.file("state.txt", template())),
    ("1,000 bytes", |image| image.file("STATE.TXT", long(1000))),
    ("large clusters", |image| {
        image.cluster_blocks(2).file("STATE.TXT", long(3000))
    }),
    ("100 KB behind other files", |image| {
        image
            .file("a file with a long name.txt", long(700))
            .deleted_file("XTATE.TXT", long(600))
            .file("STATE.TXT", long(100_000))
    }),
    ("fragmented", |image| {
        image
            .fragmented_file("STATE.TXT", long(5000))
            .file("LAST.TXT", "5")
    }),
];

fn long(bytes: usize) -> Vec<u8> {
    vec![b'5'; bytes]
}

fn begun(uno: &Uno) -> Vec<u64> {
    let commands = &uno.card().unwrap().log().commands;
    let writing = commands.iter().filter(|command| command.index == 24);
    writing.map(|command| command.time).collect()
}

#[test]
fn every_card_and_volume() {
    let firmware = firmware();
    let mut kept = 0;
    for fat in [Fat::Fat16, Fat::Fat32] {
        for bare in [false, true] {
            for (name, build) in CASES {
                let image = build(Image::new(fat).file("PROGRAM.TXT", FOLLOW));
                let image = if bare { image.bare() } else { image }.build().unwrap();
                for kind in [Kind::SdscV2, Kind::Sdhc] {
                    let case = format!("{fat:?}, bare {bare}, {kind:?}, {name}");
                    let card = SdCard::new(kind, image.clone()).unwrap();
                    let mut uno = Uno::with_program(firmware.clone(), Slot::Card(card)).unwrap();
                    uno.set_inputs(0b0110);
                    let said = to_run(&mut uno);
                    assert!(said.contains(KEPT), "{case}: {said:?}");
                    let saved = run_to_save(&mut uno);
                    assert_eq!((saved.inputs, saved.outputs), (0b0110, 0b0110), "{case}");
                    assert_only_state_changed(&image, uno.card().unwrap(), &case);
                    kept += 1;
                }
            }
        }
    }
    println!("STATE.TXT kept on {kept} cards, nothing else changed on them");
}

/// Inputs that change in the middle of a save do not tear what it says.
#[test]
fn a_save_is_of_one_scan_and_comes_once_a_second() {
    let mut uno = running(state_card(FOLLOW));
    let mut inputs = 0b0101;
    let (mut seen, mut other) = (0, 0);
    let begin = uno.cycles();
    while uno.cycles() < begin + 10 * SECOND {
        // 100 Hz: two changes in 10 ms, at any place of a scan.
        inputs ^= 0b1111;
        uno.set_inputs(inputs);
        uno.run_cycles(5 * CYCLES_PER_MS + 77).unwrap();
        if saves(&uno) == seen {
            continue;
        }
        seen = saves(&uno);
        let card = uno.card().unwrap();
        let saved = Saved::last(card);
        assert_eq!(saved.inputs, saved.outputs, "{saved:?}");
        other += usize::from(saved.inputs == 0b0101);
        let written = card.log().writes[seen - 1].time;
        let lag = written.checked_sub(saved.uptime * SECOND);
        assert!(
            lag.is_some_and(|lag| lag < SECOND + SAVE),
            "{saved:?} at {written}"
        );
        assert!(
            saved.least <= saved.last && saved.last <= saved.most,
            "{saved:?}"
        );
    }
    let begun = begun(&uno);
    assert!((10..=11).contains(&begun.len()), "{begun:?}");
    let apart: Vec<u64> = begun.windows(2).map(|pair| pair[1] - pair[0]).collect();
    println!(
        "inputs changed 200 times a second: {seen} saves in 10 s, {} to {} us apart",
        apart.iter().min().unwrap() / 16,
        apart.iter().max().unwrap() / 16
    );
    for apart in apart {
        assert!(
            (SECOND - CYCLES_PER_MS..SECOND + SAVE).contains(&apart),
            "{begun:?}"
        );
    }
    assert!(
        other > 0 && other < seen,
        "always the same inputs: {other} of {seen}"
    );
}

#[test]
fn a_change_is_saved_at_once_or_a_second_after_the_last_save() {
    let mut uno = running(state_card(FOLLOW));
    run_to_save(&mut uno);
    let (mut changes, mut slowest) = (0, 0);
    for (inputs, after_ms) in [(1, 1500), (3, 20), (2, 500), (0, 900), (4, 990), (15, 1010)] {
        uno.run_ms(after_ms).unwrap();
        let before = *begun(&uno).last().unwrap();
        let due = uno.cycles().max(before + SECOND);
        uno.set_inputs(inputs);
        let saved = run_to_save(&mut uno);
        let case = format!("{inputs:04b} after {after_ms} ms");
        assert_eq!((saved.inputs, saved.outputs), (inputs, inputs), "{case}");
        let begun = *begun(&uno).last().unwrap();
        assert!(begun + CYCLES_PER_MS >= due, "{case}: too soon");
        assert!(uno.cycles() <= due + SAVE, "{case}: too late");
        slowest = slowest.max(uno.cycles() - due);
        changes += 1;
    }
    println!(
        "{changes} changes saved, the slowest {} us after it was due",
        slowest / 16
    );
}

/// Without a change it is written each minute; one that is taken back in time is none.
#[test]
fn a_still_board_saves_each_minute() {
    let mut uno = running(state_card(FOLLOW));
    run_to_save(&mut uno);
    uno.run_ms(300).unwrap();
    uno.set_inputs(0b0010);
    uno.run_ms(200).unwrap();
    uno.set_inputs(0);
    uno.run_ms(59_000).unwrap();
    let first = begun(&uno);
    assert_eq!(first.len(), 1, "{first:?}");
    let saved = run_to_save(&mut uno);
    assert_eq!((saved.inputs, saved.outputs), (0, 0));
    assert!((60..=61).contains(&saved.uptime), "{saved:?}");
    let minute = begun(&uno)[1] - first[0];
    println!("a still board saves after {} ms", minute / CYCLES_PER_MS);
    assert!(
        (60 * SECOND - CYCLES_PER_MS..60 * SECOND + SAVE).contains(&minute),
        "{minute}"
    );
}

#[test]
fn stop_saves_outputs_that_are_off() {
    let mut uno = running(state_card(FOLLOW));
    let images = |uno: &mut Uno| {
        let saved = run_to_save(uno);
        (saved.inputs, saved.outputs)
    };
    assert_eq!(images(&mut uno), (0, 0));
    uno.set_inputs(0b1011);
    assert_eq!(images(&mut uno), (0b1011, 0b1011));
    uno.set_stop(true);
    assert_eq!(images(&mut uno), (0b1011, 0));
    uno.set_inputs(0b0001);
    assert_eq!(images(&mut uno), (0b0001, 0));
    assert_eq!(uno.outputs(), 0);
    uno.set_stop(false);
    assert_eq!(images(&mut uno), (0b0001, 0b0001));

    uno.set_stop(true);
    uno.set_inputs(0b0100);
    uno.power_up();
    assert_eq!(images(&mut uno), (0b0100, 0), "STOP at power-up");
}

#[test]
fn scan_times_are_those_that_stop_tells() {
    let mut uno = running(state_card(FOLLOW));
    uno.run_ms(500).unwrap();
    uno.set_inputs(0b0001);
    run_to_save(&mut uno);
    uno.run_ms(500).unwrap();
    uno.set_inputs(0b0010);
    let saved = run_to_save(&mut uno);
    uno.set_stop(true);
    uno.run_ms(2).unwrap();
    let [least, most] = words(&mut uno, 4, 25, 2)[..] else {
        panic!("two words")
    };
    let (least, most) = (u64::from(least), u64::from(most));
    println!("{saved:?}; then STOP: least {least}, most {most}");
    assert!(least <= saved.least && saved.most <= most);
    assert!(saved.least <= saved.last && saved.last <= saved.most);
}

/// The program is the stored one; the card has STATE.TXT and nothing else.
#[test]
fn a_stored_program_keeps_it_too() {
    let mut uno = Uno::with_program(firmware(), Slot::Card(card(FOLLOW))).unwrap();
    to_run(&mut uno);
    let image = Image::new(Fat::Fat16)
        .file("STATE.TXT", template())
        .build()
        .unwrap();
    uno.swap_slot(Slot::Card(SdCard::new(Kind::Sdhc, image.clone()).unwrap()));
    uno.set_inputs(0b1000);
    uno.power_up();
    let said = to_run(&mut uno);
    assert!(
        said.contains("the program that was stored runs\r\n"),
        "{said:?}"
    );
    assert!(said.contains(KEPT), "{said:?}");
    let saved = run_to_save(&mut uno);
    assert_eq!((saved.inputs, saved.outputs), (0b1000, 0b1000));
    assert_only_state_changed(&image, uno.card().unwrap(), "only STATE.TXT");
}
