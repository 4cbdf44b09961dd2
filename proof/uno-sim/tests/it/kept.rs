//! Numbers that outlast a power cut (NC-21).

use crate::common::modbus::{long, to_serving, words, write};
use crate::common::{card, ms_until, place, to_run, uno};
use unoclp_modbus::eeprom::{numbers, program};
use unoclp_modbus::map::holding;
use unoclp_uno_sim::{Slot, Space, Uno};

/// Each press of input 01 adds 0x01010101 to D 01, so that every byte changes, and 1 to C 01; D 02 shows C 01.
const PRESSES: &str = "0\n756801\n756701\n827301\n67848501\n1000\n787600\n\
    827301\n6985\n766801\n65686800\n16843009\n838401\n787600\n76686701\n838402\n";
/// What one press adds.
const PRESS: i32 = 0x0101_0101;
/// How many presses of [`PRESSES`] come to be kept before there is a delay: 16, but for what is left to STOP.
const AT_ONCE: i32 = 12;
/// Counts its scans, and keeps how many.
const SCANS: &str = "0\n756801\n766801\n65686800\n1\n838401\n";
/// The command that restarts the board.
const RESTART: u16 = 4;
/// `rjmp .-2`: forever here.
const STALL: [u8; 2] = [0xFF, 0xCF];
/// A record of two numbers.
const RECORD: usize = 11;
/// ms that a record takes, and a number to be looked at.
const WRITTEN: u64 = 60;

/// A board that runs this from a card; then the card is gone.
fn running(text: &str) -> Uno {
    let mut uno = uno(Slot::Card(card(text)));
    to_run(&mut uno);
    uno.swap_slot(Slot::Empty);
    uno
}

/// D 01 or D 02.
fn register(uno: &mut Uno, number: u16) -> i32 {
    let first = holding::FIRST_REGISTERS.first + 2 * (number - 1);
    long(&words(uno, 3, first, 2)).cast_signed()
}

fn press(uno: &mut Uno) {
    uno.set_inputs(1);
    uno.run_ms(WRITTEN).unwrap();
    uno.set_inputs(0);
    uno.run_ms(2).unwrap();
}

/// Cuts the power; gives the presses that were kept. Both numbers are of one moment.
fn after_power_cut(uno: &mut Uno) -> i32 {
    uno.set_inputs(0);
    uno.power_up();
    to_run(uno);
    // All records are looked through before the first scan.
    uno.run_ms(20).unwrap();
    let presses = register(uno, 2);
    assert_eq!(register(uno, 1), presses * PRESS);
    presses
}

#[test]
fn numbers_outlast_a_power_cut() {
    let mut uno = running(PRESSES);
    assert_eq!(after_power_cut(&mut uno), 0);
    for presses in 1..=5 {
        press(&mut uno);
        assert_eq!(after_power_cut(&mut uno), presses);
    }
}

/// NC-21: after a power cut at any byte it is the old record or the new one.
#[test]
fn a_power_cut_at_any_byte_leaves_the_old_record_or_the_new() {
    for nth in 1..=RECORD {
        for middle in [false, true] {
            let mut uno = running(PRESSES);
            press(&mut uno);
            if middle {
                uno.cut_power_during_eeprom_write(nth);
            } else {
                uno.cut_power_after_eeprom_write(nth);
            }
            uno.set_inputs(1);
            assert!(uno.run_ms(2 * WRITTEN).is_err(), "the power was not cut");
            let came = after_power_cut(&mut uno);
            let new = nth == RECORD && !middle;
            assert!(
                came == 1 && !new || came == 2 && nth == RECORD,
                "{nth} {middle}: {came}"
            );
            // It goes on from there.
            press(&mut uno);
            assert_eq!(after_power_cut(&mut uno), came + 1);
        }
    }
}

#[test]
fn another_program_begins_with_0() {
    let mut uno = running(PRESSES);
    press(&mut uno);
    uno.swap_slot(Slot::Card(card(&other())));
    assert_eq!(after_power_cut(&mut uno), 0);
    press(&mut uno);
    assert_eq!(after_power_cut(&mut uno), 1);
}

#[test]
fn a_program_that_is_stored_again_goes_on_with_what_it_kept() {
    let mut uno = running(PRESSES);
    (0..3).for_each(|_| press(&mut uno));
    uno.swap_slot(Slot::Card(card(PRESSES)));
    assert_eq!(after_power_cut(&mut uno), 3);
    // After another one that has kept nothing.
    for (text, presses) in [(other().as_str(), 0), (PRESSES, 3)] {
        uno.swap_slot(Slot::Card(card(text)));
        assert_eq!(after_power_cut(&mut uno), presses);
    }
}

/// [`PRESSES`] but for a byte.
fn other() -> String {
    PRESSES.replace("1000", "1001")
}

#[test]
fn stop_keeps_numbers_and_has_an_allowance_of_its_own() {
    let mut uno = running(PRESSES);
    for _ in 0..AT_ONCE + 2 {
        press(&mut uno);
    }
    assert_eq!(register(&mut uno, 2), AT_ONCE + 2);
    uno.set_stop(true);
    uno.run_ms(WRITTEN).unwrap();
    assert_eq!(register(&mut uno, 1), (AT_ONCE + 2) * PRESS, "kept in STOP");
    uno.set_stop(false);
    uno.run_ms(WRITTEN).unwrap();
    assert_eq!(register(&mut uno, 2), AT_ONCE + 2, "and in RUN behind it");
    assert_eq!(after_power_cut(&mut uno), AT_ONCE + 2);
}

#[test]
fn beyond_the_allowance_numbers_are_kept_as_they_were() {
    let mut uno = running(PRESSES);
    for _ in 0..AT_ONCE + 2 {
        press(&mut uno);
    }
    assert_eq!(after_power_cut(&mut uno), AT_ONCE);
}

/// Writes of the sequence number of any record.
fn records(uno: &Uno) -> usize {
    let length = u16::from_le_bytes(
        *uno.read_eeprom(program::LENGTH, 2)
            .unwrap()
            .first_chunk()
            .unwrap(),
    );
    let first = numbers::first(length);
    let record = u16::from(numbers::record(1));
    let writes = uno.eeprom_writes().iter();
    let sequences = writes.filter(|write| {
        let at = write.address;
        (first..place(program::END)).contains(&at) && (at - first).is_multiple_of(record)
    });
    sequences.count()
}

/// Uses the allowance up, restarts the board three times like this, and then by a power cut.
fn outlives(restart: fn(&mut Uno)) {
    let mut uno = running(SCANS);
    uno.run_ms(12 * 50).unwrap();
    let before = records(&uno);
    assert!(before >= 10, "{before}");
    for _ in 0..3 {
        restart(&mut uno);
        uno.run_ms(200).unwrap();
    }
    let after = records(&uno) - before;
    assert!(after <= 3, "{after}");
    uno.power_up();
    to_run(&mut uno);
    uno.run_ms(12 * 50).unwrap();
    let renewed = records(&uno) - before - after;
    assert!(renewed >= 10, "{renewed}");
}

#[test]
fn the_allowance_outlives_a_reset() {
    outlives(|uno| {
        uno.reset();
        to_run(uno);
    });
}

#[test]
fn the_allowance_outlives_a_restart_by_command() {
    outlives(|uno| {
        write(uno, holding::COMMAND.first, RESTART).unwrap();
        to_serving(uno);
    });
}

/// The watchdog bites in a scan that stands; the fault is ended by a reset.
#[test]
fn the_allowance_outlives_the_watchdog() {
    outlives(|uno| {
        let scan = uno.symbol("scan_begin").unwrap().address;
        let whole = uno.read_flash(scan, 2).unwrap().to_vec();
        uno.patch_flash(scan, &STALL).unwrap();
        let said = ms_until(uno, &["fault 61"]).1;
        assert!(said.contains("by the watchdog"), "{said:?}");
        uno.patch_flash(scan, &whole).unwrap();
        uno.take_serial();
        uno.reset();
        to_run(uno);
    });
}

/// NC-21: in the long run each place is written once in 53 minutes, whatever changes.
#[test]
fn numbers_that_always_change_do_not_wear_the_eeprom_out() {
    let mut uno = running(SCANS);
    uno.run_ms(12 * 50).unwrap();
    let length = uno.read_eeprom(program::LENGTH, 2).unwrap();
    let length = u16::from_le_bytes(*length.first_chunk().unwrap());
    // As many as a UNO has: the longer ring of another board lasts longer.
    let places = u64::from((program::END - numbers::first(length)) / u16::from(numbers::record(1)));
    let before = records(&uno) as u64;
    // The clock stands, and goes on by a second at a time: what goes on beside the scans waits for it.
    uno.stop_clock();
    let millis = uno.symbol("MILLIS").unwrap();
    assert_eq!(millis.space, Space::Data);
    let millis = millis.address;
    let age = uno.symbol("AGE").unwrap().address;
    let mut now = u32::from_le_bytes(*uno.read_ram(millis, 4).unwrap().first_chunk().unwrap());
    for _ in 0..53 * 60 {
        now = now.wrapping_add(1_000);
        uno.write_ram(millis, &now.to_le_bytes()).unwrap();
        uno.write_ram(age, &[1]).unwrap();
        uno.run_ms(4).unwrap();
    }
    let came = records(&uno) as u64 - before;
    // Give or take those that the allowance had begun with.
    assert!(
        (places - 3..=places + 3).contains(&came),
        "{came} of {places}"
    );
    let most = uno.eeprom_wear()[numbers::first(length).into()..place(program::END).into()]
        .iter()
        .copied()
        .max();
    assert!(most <= Some(2), "{most:?}");
}
