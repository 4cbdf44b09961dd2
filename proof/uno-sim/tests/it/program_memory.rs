//! The program that the board keeps in its EEPROM: with a card, without one, and when the power
//! fails while it changes.

use crate::BOARD;
use crate::common::{card, empty_card, to_run, to_run_or_fault, uno};
use unoclp_testing::cases;
use unoclp_uno_sim::sd::{At, SdCard, What};
use unoclp_uno_sim::{Halt, Slot, Uno};

/// Output 01 follows input 01.
const OLD: &str = "0\n827301\n877901\n787600\n827302\n847978\n3000\n7903\n";
/// Output 02 follows input 01; longer than the old one, and other in most of its bytes.
const NEW: &str =
    "0\n787600\n-827304\n877904\n787600\n827301\n877902\n787600\n827302\n847978\n9000\n7903\n";

/// A board that has run a program from a card and now has no power.
fn board_with(text: &str) -> Uno {
    let mut uno = uno(Slot::Card(card(text)));
    to_run(&mut uno);
    uno
}

/// Powers the board again with this in its slot; gives what the serial port says.
fn power_up(uno: &mut Uno, slot: Slot) -> String {
    uno.take_serial();
    uno.swap_slot(slot);
    uno.power_up();
    uno.take_edges();
    to_run_or_fault(uno)
}

/// Which program runs: the output that follows input 01.
fn running(uno: &mut Uno) -> u8 {
    uno.set_inputs(0b0001);
    uno.run_ms(5).unwrap();
    let outputs = uno.outputs() & 0b0011;
    uno.set_inputs(0);
    outputs
}

const IS_OLD: u8 = 0b01;
const IS_NEW: u8 = 0b10;

#[test]
fn a_board_without_a_card_runs_what_it_last_accepted() {
    let mut uno = board_with(OLD);
    for slot in [Slot::Empty, Slot::Card(empty_card())] {
        let said = power_up(&mut uno, slot);
        assert!(said.contains("\r\ncard: "), "{said:?}");
        let end = format!(
            "the program that was stored runs\r\nprogram: 6 codes, 10 bytes used, {} free, 1 timer\r\nRUN\r\n",
            BOARD.stored_bytes - 10
        );
        assert!(said.ends_with(&end), "{said:?}");
        assert_eq!(running(&mut uno), IS_OLD);
    }
}

#[test]
fn a_board_that_never_had_a_program_says_what_is_missing() {
    for (slot, fault) in [
        (Slot::Empty, "fault 51"),
        (Slot::Card(empty_card()), "fault 55"),
    ] {
        let mut uno = uno(slot);
        let said = to_run_or_fault(&mut uno);
        assert!(said.contains(fault), "{said:?}");
        assert_eq!(uno.outputs(), 0);
    }
}

#[test]
fn whatever_else_a_card_does_is_a_fault_and_changes_nothing() {
    let dead = || card(OLD).with_fault(At::Command(3), What::NeverReady);
    let blank = || SdCard::new(unoclp_uno_sim::sd::Kind::Sdhc, vec![0; 1 << 20]).unwrap();
    let mut uno = board_with(OLD);
    let before = uno.read_eeprom(0, uno.chip().eeprom_len()).unwrap();
    for (slot, fault) in [
        (card("0\n827301\n877917\n"), "fault 26, line 3"),
        (card("0\n41\n"), "fault 31, line 2"),
        (dead(), "fault 52"),
        (blank(), "fault 54"),
    ] {
        let said = power_up(&mut uno, Slot::Card(slot));
        assert!(said.contains(fault), "{fault}: {said:?}");
        uno.set_inputs(0b1111);
        uno.run_ms(20).unwrap();
        assert_eq!(uno.outputs(), 0, "{fault}");
        uno.set_inputs(0);
        assert_eq!(
            uno.read_eeprom(0, uno.chip().eeprom_len()).unwrap(),
            before,
            "{fault}"
        );
    }
    power_up(&mut uno, Slot::Empty);
    assert_eq!(running(&mut uno), IS_OLD);
}

#[test]
fn only_bytes_that_differ_are_written() {
    let mut uno = board_with(OLD);
    let first = uno.eeprom_writes().len();
    // Another board start with the same program: nothing.
    power_up(&mut uno, Slot::Card(card(OLD)));
    assert_eq!(uno.eeprom_writes().len(), first);
    // One contact becomes another: that byte, the two of the checksum, and the mark twice.
    power_up(&mut uno, Slot::Card(card(&OLD.replace("827302", "827303"))));
    let writes = &uno.eeprom_writes()[first..];
    assert!((4..=5).contains(&writes.len()), "{writes:?}");
    assert!(
        writes.iter().all(|write| write.before != write.after),
        "{writes:?}"
    );
}

/// After every byte that a change of program writes, and in the middle of it, the power fails.
/// Then the board starts with the card and without it.
#[test]
fn a_power_cut_leaves_the_old_program_the_new_one_or_none() {
    let mut whole = board_with(OLD);
    let before = whole.eeprom_writes().len();
    power_up(&mut whole, Slot::Card(card(NEW)));
    let writes = whole.eeprom_writes().len() - before;
    assert!(writes > 15, "{writes}");

    let (mut old, mut new, mut none) = (0, 0, 0);
    for nth in 1..=writes {
        for middle in [false, true] {
            for with_card in [false, true] {
                let case = format!("write {nth}, middle {middle}, card {with_card}");
                let mut uno = board_with(OLD);
                uno.swap_slot(Slot::Card(card(NEW)));
                uno.power_up();
                if middle {
                    uno.cut_power_during_eeprom_write(nth);
                } else {
                    uno.cut_power_after_eeprom_write(nth);
                }
                assert_eq!(uno.run_ms(5000), Err(Halt::PowerCut), "{case}");

                let slot = if with_card {
                    Slot::Card(card(NEW))
                } else {
                    Slot::Empty
                };
                let said = power_up(&mut uno, slot);
                let which = running(&mut uno);
                match which {
                    IS_OLD if !with_card => old += 1,
                    IS_NEW => new += 1,
                    0 if !with_card => {
                        assert!(
                            said.contains("fault 65") || said.contains("fault 51"),
                            "{case}: {said:?}"
                        );
                        none += 1;
                    }
                    _ => panic!("{case}: outputs {which:02b}, {said:?}"),
                }
            }
        }
    }
    let cuts = writes * 4;
    println!(
        "{} of {cuts} power cuts: {old} times the old program, {new} the new one, {none} none",
        old + new + none
    );
    assert_eq!(old + new + none, cuts);
    assert!(new > 0 && none > 0);
}

/// Every bit of header and program, turned: it never runs.
#[test]
fn a_turned_bit_never_runs() {
    let mut uno = board_with(OLD);
    let length = 8 + 10;
    let kept = uno.read_eeprom(0, length).unwrap();
    let mut turned = 0;
    for (place, bit) in cases((0..length).flat_map(|place| (0..8).map(move |bit| (place, bit)))) {
        let byte = kept[place] ^ 1 << bit;
        uno.write_eeprom(place as u16, &[byte]).unwrap();
        let said = power_up(&mut uno, Slot::Empty);
        assert!(
            said.contains("fault 65"),
            "byte {place}, bit {bit}: {said:?}"
        );
        assert_eq!(running(&mut uno), 0, "byte {place}, bit {bit}");
        uno.write_eeprom(place as u16, &kept[place..=place])
            .unwrap();
        turned += 1;
    }
    power_up(&mut uno, Slot::Empty);
    assert_eq!(running(&mut uno), IS_OLD);
    println!("{turned} of {turned} turned bits never ran");
}
