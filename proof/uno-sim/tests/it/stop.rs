//! RUN/STOP: A5 to ground.

use crate::common::{card, ms_until, to_run, uno};
use unoclp_uno_sim::{CYCLES_PER_MS, Pin, Slot};

/// Input 01 sets output 01 for good; input 02 for 300 ms lights output 02.
const TEXT: &str = "0\n827301\n83877901\n787600\n827302\n847978\n300\n7902\n";

#[test]
fn stop_turns_the_outputs_off_and_run_begins_anew() {
    let mut uno = uno(Slot::Card(card(TEXT)));
    to_run(&mut uno);
    uno.set_inputs(0b0011);
    uno.run_ms(310).unwrap();
    assert_eq!(uno.outputs(), 0b0011);

    uno.set_inputs(0b0010);
    uno.set_stop(true);
    uno.run_ms(2).unwrap();
    assert_eq!(uno.outputs(), 0);
    uno.take_serial();

    uno.take_edges();
    uno.run_ms(5000).unwrap();
    let led: Vec<_> = uno.take_edges();
    assert!(led.iter().all(|edge| edge.pin == Pin::Led), "{led:?}");
    let flashes: Vec<u64> = led
        .windows(2)
        .filter(|pair| pair[0].high)
        .map(|pair| (pair[1].cycle - pair[0].cycle) / CYCLES_PER_MS)
        .collect();
    assert!((4..=5).contains(&flashes.len()), "{flashes:?}");
    assert!(
        flashes.iter().all(|ms| (90..=110).contains(ms)),
        "{flashes:?}"
    );

    // As after power-up: what was set is forgotten, and the timer begins again.
    uno.set_stop(false);
    uno.run_ms(280).unwrap();
    assert_eq!(uno.outputs(), 0);
    uno.run_ms(40).unwrap();
    assert_eq!(uno.outputs(), 0b0010);
    assert!(uno.led());
    assert_eq!(uno.serial(), "");
}

#[test]
fn stop_at_power_up_lets_nothing_run() {
    let mut uno = uno(Slot::Card(card("0\n877901\n")));
    uno.set_stop(true);
    ms_until(&mut uno, &["STOP\r\n"]);
    uno.run_ms(1000).unwrap();
    assert!(!uno.edges().iter().any(|edge| edge.pin != Pin::Led));
    uno.set_stop(false);
    uno.run_ms(2).unwrap();
    assert_eq!(uno.outputs(), 0b0001);
}
