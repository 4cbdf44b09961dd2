//! Markers that outlast a power cut (NC-12).

use crate::common::{card, to_run, uno};
use unoclp_modbus::eeprom::markers;
use unoclp_uno_sim::{CYCLES_PER_MS, Slot, Uno};

/// Input 01 sets M 57 and M 60, input 02 resets them; outputs 01 to 04 show M 57 to M 60.
const LATCH: &str = "0\n827301\n83877757\n83877760\n787600\n827302\n82877757\n82877760\n\
    787600\n827757\n877901\n787600\n827758\n877902\n787600\n827759\n877903\n787600\n827760\n877904\n";
const SET: u8 = 0b1001;
/// M 57 changes twenty times a second.
const FLICKER: &str = "0\n828303\n877757\n";

/// A board that runs this from a card; then the card is gone.
fn running(text: &str) -> Uno {
    let mut uno = uno(Slot::Card(card(text)));
    to_run(&mut uno);
    uno.swap_slot(Slot::Empty);
    uno
}

/// Presses a button until what it does has been kept.
fn press(uno: &mut Uno, inputs: u8) {
    uno.set_inputs(inputs);
    uno.run_ms(30).unwrap();
    uno.set_inputs(0);
    uno.run_ms(5).unwrap();
}

/// NC-12: 9 ms after a change the power may go, whenever it came.
#[test]
fn a_change_is_kept_within_9_ms() {
    for phase in 0..10 {
        let mut uno = running(LATCH);
        uno.run_cycles(phase * CYCLES_PER_MS / 10).unwrap();
        uno.set_inputs(1);
        uno.run_ms(9).unwrap();
        assert_eq!(after_power_cut(&mut uno), SET, "{phase}");
    }
}

/// What the markers are after a power cut.
fn after_power_cut(uno: &mut Uno) -> u8 {
    uno.power_up();
    to_run(uno);
    uno.run_ms(2).unwrap();
    uno.outputs()
}

#[test]
fn what_was_set_and_reset_is_so_after_a_power_cut() {
    let mut uno = running(LATCH);
    assert_eq!(uno.outputs(), 0);
    // More often than the ring has places.
    for _ in 0..20 {
        press(&mut uno, 0b01);
        assert_eq!(after_power_cut(&mut uno), SET);
        press(&mut uno, 0b10);
        assert_eq!(after_power_cut(&mut uno), 0);
    }
    let wear = uno.eeprom_wear();
    let most = wear[markers::FIRST.into()..].iter().max().unwrap();
    assert!((1..=2).contains(most), "{most}");
}

#[test]
fn other_markers_begin_anew() {
    let mut uno = running("0\n827301\n83877756\n787600\n827756\n877901\n");
    press(&mut uno, 0b01);
    assert_eq!(uno.outputs(), 1);
    assert_eq!(after_power_cut(&mut uno), 0);
}

#[test]
fn a_power_cut_in_a_writing_leaves_the_old_markers_or_the_new() {
    // The last one goes to a place that already holds these markers, so only the number is written.
    for (earlier, writes) in [(0, 2), (30, 2), (32, 1)] {
        for nth in 1..=writes {
            for middle in [false, true] {
                let mut uno = running(LATCH);
                // So that the writing that is cut off goes to any place of the ring.
                for press_number in 0..earlier {
                    press(&mut uno, if press_number % 2 == 0 { 0b01 } else { 0b10 });
                    if press_number % 8 == 7 {
                        after_power_cut(&mut uno);
                    }
                }
                let old = uno.outputs();
                let (button, new) = if old == 0 { (0b01, SET) } else { (0b10, 0) };
                if middle {
                    uno.cut_power_during_eeprom_write(nth);
                } else {
                    uno.cut_power_after_eeprom_write(nth);
                }
                uno.set_inputs(button);
                assert!(uno.run_ms(30).is_err(), "the power was not cut");
                uno.set_inputs(0);
                let came = after_power_cut(&mut uno);
                assert!(came == old || came == new, "{earlier} {nth}: {came:04b}");
            }
        }
    }
}

#[test]
fn a_marker_that_always_changes_does_not_wear_the_eeprom_out() {
    let mut uno = running(FLICKER);
    let before = uno.eeprom_writes().len();
    uno.run_ms(61_000).unwrap();
    let writes = uno.eeprom_writes().len() - before;
    // Sixteen at once, one more after a minute; two bytes each, or one where a place already holds the
    // markers.
    assert!((17..=34).contains(&writes), "{writes}");
}
