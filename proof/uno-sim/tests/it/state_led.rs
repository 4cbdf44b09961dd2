//! LED L and the clock of the card are one pin on a UNO: who has it while STATE.TXT is written.

use crate::common::state::{run_to_save, running, state_card};
use unoclp_uno_sim::{CYCLES_PER_MS, Edge, Pin};

/// Output 04 changes in every scan, so that there is always something to save.
const TOGGLE: &str = "0\n827301\n877901\n787600\n-827904\n877904\n";

/// Whatever moves the clock line while the card is selected is a clock to it. LED L hangs on that
/// line, so the bus must have it before the card is selected, and as long as it is.
#[test]
fn the_bus_has_the_clock_line_as_long_as_the_card_is_selected() {
    const PORTB: u32 = 0x25;
    const SPCR: u32 = 0x4C;
    const CS: u8 = 1 << 2;
    const ON_AND_MASTER: u8 = 1 << 6 | 1 << 4;
    let mut uno = running(state_card(TOGGLE).with_write_time(3 * CYCLES_PER_MS));
    let (mut selected, end) = (0u64, uno.cycles() + 60 * CYCLES_PER_MS);
    while uno.cycles() < end {
        uno.step().unwrap();
        let register = |address| uno.read_ram(address, 1).unwrap()[0];
        if register(PORTB) & CS == 0 {
            selected += 1;
            assert_eq!(register(SPCR) & ON_AND_MASTER, ON_AND_MASTER, "{uno:?}");
        }
    }
    assert_eq!(uno.card().unwrap().log().count(13), 1);
    println!("{selected} instructions with the card selected, the bus on at each");
    assert!(selected > 10_000);
}

/// LED L is dark while a block goes to the card, and no longer.
#[test]
fn led_l_is_dark_for_a_few_ms_a_save() {
    let mut uno = running(state_card("0\n827301\n877901\n").with_write_time(250 * CYCLES_PER_MS));
    run_to_save(&mut uno);
    uno.run_ms(1500).unwrap();
    assert!(uno.led());
    uno.take_edges();
    uno.set_input(0, true);
    run_to_save(&mut uno);
    uno.run_ms(1).unwrap();
    let led: Vec<Edge> = uno
        .take_edges()
        .into_iter()
        .filter(|edge| edge.pin == Pin::Led)
        .collect();
    let dark: u64 = led
        .chunks(2)
        .map(|pair| pair[1].cycle - pair[0].cycle)
        .sum();
    println!("LED L is dark for {} us a save of 250 ms", dark / 16);
    assert!(
        !led[0].high && dark > 0 && dark < 30 * CYCLES_PER_MS,
        "{dark}"
    );
}
