//! The power, or the reset button, at any moment of a save.

use crate::common::state::{
    BLOCK, FOLLOW, KEPT, assert_only_state_changed, assert_sound, run_to_save, running, template,
};
use crate::common::to_run;
use std::collections::BTreeSet;
use unoclp_card::image::{Fat, Image};
use unoclp_testing::cases;
use unoclp_uno_sim::sd::{CardLog, Kind, SdCard, Timing};
use unoclp_uno_sim::{CYCLES_PER_MS, Slot, Uno};

/// A volume with files before and after STATE.TXT.
fn image(fat: Fat) -> Image {
    Image::new(fat)
        .file("FIRST.BIN", vec![b'1'; 3000])
        .file("PROGRAM.TXT", FOLLOW)
        .fragmented_file("STATE.TXT", [template(), vec![b'2'; 1000]].concat())
        .file("a last file, with a long name.txt", vec![b'3'; 700])
}

fn log(uno: &Uno) -> &CardLog {
    uno.card().unwrap().log()
}

/// Runs to the first scan, at which a save begins.
fn run_to_first_scan(uno: &mut Uno) {
    let scan = uno.symbol("scan_begin").unwrap().address;
    uno.run_until(scan, 3000 * CYCLES_PER_MS)
        .unwrap_or_else(|halt| panic!("{halt}: {:?}", uno.serial()));
}

/// Moments of a save, in cycles from the first scan on: 200 of them evenly, two or three in the time of
/// a step of 8 bytes; and, where the commands and the end of the block come, each few bytes.
fn moments(uno: &mut Uno) -> BTreeSet<u64> {
    uno.power_up();
    run_to_first_scan(uno);
    let begun = uno.cycles();
    let seen = |uno: &Uno| {
        let log = log(uno);
        log.count(24) + log.writes.len() + log.count(13)
    };
    let first = seen(uno);
    let (mut marks, mut last) = (Vec::new(), first);
    while last < first + 3 {
        uno.step().unwrap();
        if seen(uno) > last {
            last = seen(uno);
            marks.push(uno.cycles() - begun);
        }
    }
    let end = marks[2] + 2 * CYCLES_PER_MS;
    let close = marks
        .iter()
        .flat_map(|mark| (mark.saturating_sub(900)..mark + 900).step_by(90));
    (0..end).step_by(end as usize / 200).chain(close).collect()
}

/// Each restart finds the program, and its next save is whole.
fn expect_run_and_save(uno: &mut Uno, inputs: u8, case: &str) {
    let said = to_run(uno);
    assert!(said.contains("program: 12 codes"), "{case}: {said:?}");
    assert!(said.contains(KEPT), "{case}: {said:?}");
    let saved = run_to_save(uno);
    assert_eq!((saved.inputs, saved.outputs), (inputs, inputs), "{case}");
    assert_eq!(uno.outputs(), inputs, "{case}");
}

#[test]
fn a_power_cut_in_a_save_damages_nothing() {
    cut_power(Kind::SdscV2, &image(Fat::Fat16).bare(), 1);
}

#[test]
fn a_power_cut_in_a_save_damages_nothing_on_fat32() {
    cut_power(Kind::Sdhc, &image(Fat::Fat32), 8);
}

/// Cuts the power at each `step`th of the moments of a save.
fn cut_power(kind: Kind, image: &Image, step: usize) {
    let before = image.build().unwrap();
    assert_sound(&before, "before");
    let card = SdCard::new(kind, before.clone()).unwrap();
    let mut uno = running(card.with_write_time(2 * CYCLES_PER_MS));
    let moments: Vec<u64> = moments(&mut uno).into_iter().step_by(step).collect();
    let place = log(&uno).writes[0].block * BLOCK;
    let block = |uno: &Uno| uno.card().unwrap().image()[place..][..BLOCK].to_vec();
    let (mut sound, mut cuts) = (BTreeSet::new(), [0; 3]);
    for (n, &moment) in moments.iter().enumerate() {
        let case = format!("{kind:?}, cut {moment} cycles after the first scan");
        // Others each time, so that the new block differs from the old one.
        let inputs = n as u8 & 0b1111;
        uno.set_inputs(inputs);
        uno.power_up();
        run_to_first_scan(&mut uno);
        let (old, written, asked) = (block(&uno), log(&uno).writes.len(), log(&uno).count(13));
        uno.run_cycles(moment).unwrap();

        // The power goes here.
        let left = block(&uno);
        let card = uno.card().unwrap();
        let whole = log(&uno).writes.len() > written;
        assert!(whole || left == old, "{case}");
        assert!(card.image()[..place] == before[..place], "{case}");
        let behind = place + BLOCK..before.len();
        assert!(card.image()[behind.clone()] == before[behind], "{case}");
        if sound.insert(left.clone()) {
            assert_only_state_changed(&before, card, &case);
            assert_sound(&card.image()[..before.len()], &case);
        }
        // While it is busy with the block, a card may be left with anything in it.
        let torn = whole && log(&uno).count(13) == asked;
        cuts[usize::from(whole) + usize::from(torn)] += 1;
        if torn {
            let mut image = card.image().to_vec();
            image[place + BLOCK / 2..][..BLOCK / 2].copy_from_slice(&old[BLOCK / 2..]);
            let card = SdCard::new(kind, image).unwrap();
            uno.swap_slot(Slot::Card(card.with_write_time(2 * CYCLES_PER_MS)));
        }
        uno.power_up();
        uno.take_serial();
        expect_run_and_save(&mut uno, inputs, &case);
    }
    let [old, new, torn] = cuts;
    println!(
        "{kind:?}: {} of {} power cuts left the old block ({old}), a torn one ({torn}) or the new one ({new}) and all else untouched; fsck.fat found nothing in {} images",
        old + new + torn,
        moments.len(),
        sound.len()
    );
    assert!(old > 0 && new > 0 && torn > 0);
}

/// The reset button leaves the card its power, and in the middle of a packet or busy: it takes what
/// the next start-up sends for the rest of the block.
#[test]
fn a_reset_in_a_save_ends_in_run() {
    let before = image(Fat::Fat16).build().unwrap();
    // The slow card takes most of the second that the specification allows it (4.2.3).
    for (name, busy_ms, init_polls, step) in [
        ("a fast card", 2, 3, 3),
        ("a card busy for 250 ms", 250, 3, 10),
        ("a card slow to start", 2, 1000, 50),
    ] {
        let timing = Timing {
            init_polls,
            ..Timing::default()
        };
        let card = SdCard::new(Kind::Sdhc, before.clone())
            .unwrap()
            .with_timing(timing);
        let mut uno = running(card.with_write_time(busy_ms * CYCLES_PER_MS));
        let moments: Vec<u64> = cases(moments(&mut uno).into_iter().step_by(step)).collect();
        let (mut slowest, mut usual) = (0, 0);
        for (n, &moment) in moments.iter().enumerate() {
            let case = format!("{name}, reset {moment} cycles after the first scan");
            let powered = uno.cycles();
            uno.power_up();
            run_to_first_scan(&mut uno);
            usual = uno.cycles() - powered;
            uno.run_cycles(moment).unwrap();
            let inputs = n as u8 & 0b1111;
            uno.set_inputs(inputs);
            uno.take_serial();
            let begun = uno.cycles();
            uno.reset();
            run_to_first_scan(&mut uno);
            slowest = slowest.max(uno.cycles() - begun);
            expect_run_and_save(&mut uno, inputs, &case);
        }
        assert_only_state_changed(&before, uno.card().unwrap(), "after all resets");
        println!(
            "{name}: {} of {} resets in a save ended in RUN, after {} ms at most, {} ms from power-up",
            moments.len(),
            moments.len(),
            slowest / CYCLES_PER_MS,
            usual / CYCLES_PER_MS
        );
    }
}
