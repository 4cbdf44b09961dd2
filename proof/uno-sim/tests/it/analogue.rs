//! Analogue inputs, their pins as digital inputs, and PWM, on the board (NC-18).

use crate::common::{card, to_run, uno};
use unoclp_uno_sim::{Analogue, Pin, Slot, Uno};

fn running(text: &str) -> Uno {
    let mut uno = uno(Slot::Card(card(text)));
    to_run(&mut uno);
    uno
}

/// Output 01 is on where this analogue input reads at least so much.
fn threshold(channel: usize, least: u16) -> String {
    format!("0\n766865{channel:02}\n716900\n{least}\n877901\n")
}

#[test]
fn every_channel_reads_what_is_on_its_pin() {
    for channel in 0..5 {
        for reading in [0, 1, 511, 512, 1023] {
            let mut uno = running(&threshold(channel, 512));
            uno.set_analogue(channel, Analogue::Reading(reading));
            uno.run_ms(16).unwrap();
            assert_eq!(
                uno.outputs(),
                u8::from(reading >= 512),
                "A{channel} at {reading}"
            );
        }
    }
}

/// Each output is on where its channel reads less than it should.
#[test]
fn every_channel_has_been_measured_before_the_first_scan() {
    let rung = |channel: usize| {
        format!(
            "787600\n766865{channel:02}\n768400\n900\n8779{:02}\n",
            channel + 1
        )
    };
    let text: String = (0..4).map(rung).collect();
    let mut uno = uno(Slot::Card(card(&format!("0\n{text}"))));
    for channel in 0..4 {
        uno.set_analogue(channel, Analogue::Reading(1000));
    }
    to_run(&mut uno);
    uno.take_edges();
    uno.run_ms(50).unwrap();
    let edges = uno.take_edges();
    assert!(edges.iter().all(|edge| edge.pin == Pin::Led), "{edges:?}");
}

#[test]
fn channels_do_not_disturb_one_another() {
    // All five, each with an output of its own but for A4.
    let rung = |channel: usize, output: usize| {
        format!("787600\n766865{channel:02}\n716900\n512\n8779{output:02}\n")
    };
    let text: String = (0..4).map(|n| rung(n, n + 1)).collect();
    let mut uno = running(&format!("0\n{text}787600\n76686504\n838401\n"));
    for pattern in [0b0101, 0b1010, 0b0110, 0b1111, 0b0000] {
        for channel in 0..4 {
            let reading = if pattern >> channel & 1 != 0 { 1023 } else { 0 };
            uno.set_analogue(channel, Analogue::Reading(reading));
        }
        uno.set_analogue(4, Analogue::Reading(600));
        uno.run_ms(16).unwrap();
        assert_eq!(uno.outputs(), pattern);
    }
}

#[test]
fn a0_to_a3_are_buttons_where_the_program_reads_them_so() {
    let text: String = (1..5)
        .map(|n| format!("787600\n8273{:02}\n8779{n:02}\n", n + 4))
        .collect();
    let mut uno = running(&format!("0\n{text}"));
    for pattern in [0b0001, 0b1000, 0b0110, 0b1111, 0b0000] {
        uno.set_inputs(pattern << 4);
        uno.run_ms(16).unwrap();
        assert_eq!(uno.outputs(), pattern);
    }
}

#[test]
fn a_weak_supply_is_seen_beside_analogue_inputs() {
    let mut uno = running(&threshold(0, 512));
    uno.set_supply(4000);
    uno.run_ms(20).unwrap();
    assert!(!uno.led() || uno.outputs() == 0);
    uno.set_analogue(0, Analogue::Reading(1023));
    uno.run_ms(20).unwrap();
    assert_eq!(uno.outputs(), 0, "the outputs are off in a fault");
}

/// The reading of A0 in 256ths is the PWM of both outputs.
const DIMMER: &str = "0\n76686500\n83728202\n83848001\n83848004\n";

#[test]
fn pwm_follows_a_number() {
    let mut uno = running(DIMMER);
    for (reading, duty) in [(0, 0.0), (4, 0.004), (512, 0.5), (1023, 1.0), (2, 0.0)] {
        uno.set_analogue(0, Analogue::Reading(reading));
        uno.run_ms(16).unwrap();
        for output in [0, 3] {
            let came = uno.pwm(output).map_or(0.0, |pwm| pwm.duty());
            assert!((came - duty).abs() < 0.005, "{reading}: {came}");
            assert_eq!(uno.pwm(output).is_none(), duty == 0.0);
        }
        assert_eq!(uno.outputs(), 0);
    }
}

#[test]
fn pwm_is_off_in_stop_and_after_a_restart() {
    let mut uno = running(DIMMER);
    uno.set_analogue(0, Analogue::Reading(600));
    uno.run_ms(16).unwrap();
    assert!(uno.pwm(0).is_some() && uno.pwm(3).is_some());
    uno.set_stop(true);
    uno.run_ms(10).unwrap();
    assert!(uno.pwm(0).is_none() && uno.pwm(3).is_none());
    assert_eq!(uno.outputs(), 0);
    uno.set_stop(false);
    uno.run_ms(10).unwrap();
    assert!(uno.pwm(0).is_some());
}
