//! The Modbus server: every function in RUN, STOP and FAULT, commands, forcing.

use crate::BOARD;
use crate::common::modbus::{
    FORM, ask, bits, input, long, serving, to_serving, words, write, write_coil, write_words,
};
use crate::common::{card, ms_until, to_run, uno};
use unoclp_uno_sim::{CYCLES_PER_MS, Pin, Slot, Uno};

/// Output 01 follows input 01; output 02 follows output 01 of the scan before; nothing writes output 03.
const FOLLOW: &str = "0\n827901\n877902\n787600\n827301\n877901\n";

const RUN: u16 = 1;
const STOP: u16 = 2;
const FAULT: u16 = 3;
const SINGLE_SCAN: u16 = 3;
const RESTART: u16 = 4;
const UPLOAD: u16 = 5;

fn in_state(state: u16) -> Uno {
    let text = if state == FAULT { "1\n" } else { FOLLOW };
    let mut uno = uno(Slot::Card(card(text)));
    uno.set_stop(state == STOP);
    ms_until(&mut uno, &["RUN\r\n", "STOP\r\n", "start\r\n"]);
    uno.run_ms(5).unwrap();
    uno
}

#[test]
fn every_function_in_every_state() {
    for state in [RUN, STOP, FAULT] {
        let mut uno = in_state(state);
        uno.set_inputs(0b0101);
        uno.run_ms(1).unwrap();
        // 2 and 1
        assert_eq!(bits(&mut uno, 2, 0, 4), 0b0101, "{state}");
        let follows = if state == RUN { 0b0011 } else { 0 };
        assert_eq!(bits(&mut uno, 1, 0, 4), follows, "{state}");
        // 5 and 15
        write_coil(&mut uno, 2, true).unwrap();
        assert_eq!(bits(&mut uno, 1, 2, 1), 1, "{state}");
        let reply = ask(&mut uno, &[1, 15, 0, 2, 0, 2, 1, 0b10]).unwrap();
        assert_eq!(reply, [1, 15, 0, 2, 0, 2]);
        assert_eq!(bits(&mut uno, 1, 2, 2), 0b10, "{state}");
        let pins = if state == RUN { 0b1011 } else { 0 };
        assert_eq!(uno.outputs(), pins, "{state}");
        // 3, 4, 6 and 16
        assert_eq!(words(&mut uno, 3, 400, 1), [state]);
        assert_eq!(input(&mut uno, 16), state);
        write(&mut uno, 403, 3).unwrap();
        write_words(&mut uno, 404, &[0, 5]).unwrap();
        assert_eq!(words(&mut uno, 3, 402, 4), [0, 3, 0, 5]);
        // 43/14
        let reply = ask(&mut uno, &[1, 0x2B, 14, 1, 0]).unwrap();
        assert_eq!(reply[..8], [1, 0x2B, 14, 1, 0x81, 0, 0, 3]);
        let version = env!("CARGO_PKG_VERSION");
        let product = format!("unoclp {}", BOARD.name);
        let objects = (0..).zip(["unoclp", &product, version]);
        let texts =
            objects.flat_map(|(n, text)| [&[n, text.len() as u8], text.as_bytes()].concat());
        assert_eq!(reply[8..], texts.collect::<Vec<u8>>());
        // Any other.
        assert_eq!(ask(&mut uno, &[1, 7]), Some(vec![1, 0x87, 1]));
        assert_eq!(uno.resets(), 0);
    }
}

#[test]
fn diagnostics() {
    let mut uno = serving(FOLLOW);
    let told = words(&mut uno, 4, 16, 17);
    println!("{told:?}");
    // State, bits, fault, start, line.
    assert_eq!(told[..6], [RUN, FORM, 0, 1, 0, 0]);
    let ms = long(&told[6..8]);
    let now = u32::from_le_bytes({
        let clock = uno.symbol("MILLIS").unwrap();
        uno.read_ram(clock.address, 4).unwrap().try_into().unwrap()
    });
    assert!(now - ms < 10, "{now} {ms}");
    // Free stack: what the simulator has seen, but for what happened to look like the paint, and for the end
    // of frames that nobody wrote to.
    let free = i32::from(told[11]);
    let most = if BOARD.inputs > 16 { 64 } else { i32::MAX };
    let expected = uno.stack_free().min(most);
    assert!((-4..=24).contains(&(free - expected)), "{free} {expected}");
    // Five codes after the start, and their checksum as in the EEPROM.
    let header = uno.read_eeprom(0, 8).unwrap();
    assert_eq!(told[12], 5);
    assert_eq!(told[13], u16::from_le_bytes([header[6], header[7]]));
    assert_eq!(told[15..], [0, 0]);

    uno.reset();
    to_serving(&mut uno);
    let told = words(&mut uno, 4, 16, 17);
    assert_eq!((told[3], told[15]), (2, 1));

    let mut wrong = in_state(FAULT);
    assert_eq!(words(&mut wrong, 4, 16, 6), [FAULT, FORM, 22, 1, 0, 1]);
    assert_eq!(input(&mut wrong, 32), 1);
    assert_eq!(words(&mut wrong, 4, 28, 2), [0, 0]);
}

#[test]
fn stop_single_scan_and_run_by_command() {
    let mut uno = serving(FOLLOW);
    uno.set_inputs(1);
    uno.run_ms(2).unwrap();
    assert_eq!(uno.outputs(), 0b11);
    write(&mut uno, 400, STOP).unwrap();
    assert_eq!(uno.outputs(), 0);
    assert_eq!(words(&mut uno, 3, 400, 1), [STOP]);
    assert_eq!(words(&mut uno, 4, 16, 2), [STOP, FORM | 0b10]);
    // From the beginning, scan by scan, and no pin moves.
    uno.take_edges();
    for expected in [0b00, 0b01, 0b11, 0b11] {
        assert_eq!(bits(&mut uno, 1, 0, 4), expected);
        write(&mut uno, 400, SINGLE_SCAN).unwrap();
    }
    assert!(uno.take_edges().iter().all(|edge| edge.pin == Pin::Led));
    write(&mut uno, 400, STOP).unwrap();
    write(&mut uno, 400, RUN).unwrap();
    assert_eq!(uno.outputs(), 0b11);
    assert_eq!(words(&mut uno, 3, 400, 1), [RUN]);
    write(&mut uno, 400, RUN).unwrap();
    assert_eq!(write(&mut uno, 400, UPLOAD), Err(4));
    for wrong in [0, 6, 0xFFFF] {
        assert_eq!(write(&mut uno, 400, wrong), Err(3));
    }
}

/// Output 01 is set by input 01 and never reset, output 02 follows it; T 01 runs while input 02 is closed.
const HOLDS: &str =
    "0\n827301\n83877901\n787600\n827901\n877902\n787600\n827302\n847978\n70000\n7903\n";

#[test]
fn a_single_scan_in_run_goes_on_from_where_the_program_is() {
    let mut uno = serving(HOLDS);
    uno.set_inputs(0b11);
    uno.run_ms(40).unwrap();
    uno.set_inputs(0b10);
    uno.run_ms(20).unwrap();
    assert_eq!(uno.outputs(), 0b11);
    write(&mut uno, 400, SINGLE_SCAN).unwrap();
    uno.run_ms(5).unwrap();
    assert_eq!(words(&mut uno, 4, 16, 2), [STOP, FORM | 0b10]);
    assert_eq!(uno.outputs(), 0, "on no pin");
    assert_eq!(bits(&mut uno, 1, 0, 4), 0b11, "in the image");
    let elapsed = |uno: &mut Uno| long(&words(uno, 4, 128, 2));
    let first = elapsed(&mut uno);
    assert!((50..100).contains(&first), "{first}");
    write(&mut uno, 400, SINGLE_SCAN).unwrap();
    uno.run_ms(5).unwrap();
    assert_eq!(bits(&mut uno, 1, 0, 4), 0b11);
    assert!(elapsed(&mut uno) >= first);
    // RUN and STOP begin as after power-up.
    write(&mut uno, 400, RUN).unwrap();
    uno.run_ms(5).unwrap();
    assert_eq!(uno.outputs(), 0);
}

#[test]
fn the_switch_wins() {
    let mut uno = serving(FOLLOW);
    uno.set_inputs(1);
    uno.set_stop(true);
    uno.run_ms(2).unwrap();
    assert_eq!(words(&mut uno, 4, 16, 2), [STOP, FORM | 0b01]);
    for refused in [RUN, SINGLE_SCAN] {
        assert_eq!(write(&mut uno, 400, refused), Err(4));
    }
    write(&mut uno, 400, STOP).unwrap();
    assert_eq!(words(&mut uno, 4, 16, 2), [STOP, FORM | 0b11]);
    uno.set_stop(false);
    uno.run_ms(5).unwrap();
    assert_eq!((uno.outputs(), input(&mut uno, 16)), (0, STOP));
    write(&mut uno, 400, RUN).unwrap();
    assert_eq!((uno.outputs(), input(&mut uno, 16)), (0b11, RUN));
    uno.set_stop(true);
    uno.run_ms(2).unwrap();
    assert_eq!(uno.outputs(), 0);
    uno.set_stop(false);
    uno.run_ms(2).unwrap();
    assert_eq!(uno.outputs(), 0b11);
}

#[test]
fn a_fault_can_only_be_restarted() {
    let mut uno = in_state(FAULT);
    for refused in [RUN, STOP, SINGLE_SCAN] {
        assert_eq!(write(&mut uno, 400, refused), Err(4));
    }
    uno.swap_slot(Slot::Card(card(FOLLOW)));
    uno.card_mut().unwrap().power_cycle();
    write(&mut uno, 400, RESTART).unwrap();
    to_serving(&mut uno);
    assert_eq!(input(&mut uno, 16), RUN);
}

#[test]
fn a_restart_is_the_whole_start_up() {
    for boot_loader in [false, true] {
        let mut uno = serving(FOLLOW);
        uno.set_boot_loader(boot_loader);
        write_words(&mut uno, 402, &[1, 1, 8, 8]).unwrap();
        uno.run_ms(2).unwrap();
        assert_eq!(uno.outputs(), 0b1011);
        write(&mut uno, 400, RESTART).unwrap();
        let said = to_run(&mut uno);
        assert!(
            said.contains("restart 1 since power-up, by command, 0 faults"),
            "{said:?}"
        );
        assert!(said.contains("program: 6 codes"), "{said:?}");
        uno.run_ms(2).unwrap();
        assert_eq!(uno.outputs(), 0);
        assert_eq!(words(&mut uno, 3, 402, 4), [0; 4]);
        assert_eq!(words(&mut uno, 4, 16, 4), [RUN, FORM, 0, 5]);
    }
    // Nobody answers a broadcast, and it is done.
    let mut uno = serving(FOLLOW);
    assert_eq!(ask(&mut uno, &[0, 6, 1, 0x90, 0, RESTART as u8]), None);
    let said = to_run(&mut uno);
    assert!(said.contains("by command"), "{said:?}");
}

#[test]
fn forcing_stands_between_pins_and_program() {
    let mut uno = serving(FOLLOW);
    // Input 01 to 1, input 02 to 0.
    uno.set_inputs(0b0110);
    write_words(&mut uno, 402, &[0b0011, 0b0001]).unwrap();
    assert_eq!(bits(&mut uno, 2, 0, 4), 0b0101);
    assert_eq!(uno.outputs(), 0b0011);
    assert_eq!(words(&mut uno, 4, 16, 2), [RUN, FORM | 0b100]);
    // Output 01 to 0, which the program reads in the next scan; output 04 to 1.
    write_words(&mut uno, 404, &[0b1001, 0b1000]).unwrap();
    uno.run_ms(1).unwrap();
    assert_eq!(uno.outputs(), 0b1000);
    assert_eq!(bits(&mut uno, 1, 0, 4), 0b1000);
    // A coil that is forced stays as it is forced.
    write_coil(&mut uno, 3, false).unwrap();
    uno.run_ms(1).unwrap();
    assert_eq!(uno.outputs(), 0b1000);
    // STOP: no pin moves; the forces stay.
    write(&mut uno, 400, STOP).unwrap();
    assert_eq!(uno.outputs(), 0);
    write_words(&mut uno, 404, &[0b1111, 0b0110]).unwrap();
    uno.run_ms(2).unwrap();
    assert_eq!(uno.outputs(), 0);
    write(&mut uno, 400, RUN).unwrap();
    assert_eq!(uno.outputs(), 0b0110);
    // Freed, output 03 keeps what it had, since nothing writes it; the others are the program's again.
    write_words(&mut uno, 402, &[0; 4]).unwrap();
    uno.run_ms(1).unwrap();
    assert_eq!(uno.outputs(), 0b0100);
    assert_eq!(words(&mut uno, 4, 16, 2), [RUN, FORM]);
    // Only points that exist.
    if BOARD.inputs > 16 {
        assert_eq!(write(&mut uno, 407, 0x100), Err(3));
        assert_eq!(write_words(&mut uno, 405, &[1, 0, 0, 0x100]), Err(3));
    } else {
        assert_eq!(write(&mut uno, 402, 0x100), Err(3));
        assert_eq!(write(&mut uno, 404, 0x10), Err(3));
        assert_eq!(write(&mut uno, 405, 0x10), Err(3));
        assert_eq!(write_words(&mut uno, 402, &[1, 1, 1, 0x100]), Err(3));
    }
    assert_eq!(words(&mut uno, 3, 402, 4), [0; 4]);
}

/// Output 01 is PWM at half, output 02 on where output 01 reads as 1, which it never does.
#[test]
fn an_output_that_is_pwm_is_forced_too() {
    let mut uno = serving("0\n766800\n128\n83848001\n787600\n76687900\n66738400\n877902\n");
    assert!(uno.pwm(0).is_some());
    for (values, pins) in [(0, 0), (1, 1)] {
        write_words(&mut uno, 404, &[1, values]).unwrap();
        uno.run_ms(2).unwrap();
        assert!(uno.pwm(0).is_none(), "{values}");
        assert_eq!(uno.outputs() & 1, pins, "{values}");
        assert_eq!(bits(&mut uno, 1, 0, 4), pins);
        write_words(&mut uno, 404, &[0, 0]).unwrap();
        uno.run_ms(2).unwrap();
        assert_eq!(bits(&mut uno, 1, 0, 4), 0);
        assert_eq!(uno.outputs() & 0b1110, 0);
        let duty = uno.pwm(0).unwrap().duty();
        assert!((duty - 0.5).abs() < 0.01, "{duty}");
    }
    // Its coil can be written, and is 0 all the same.
    write_coil(&mut uno, 0, true).unwrap();
    uno.run_ms(2).unwrap();
    assert_eq!(bits(&mut uno, 1, 0, 4), 0);
}

#[test]
fn a_forced_input_passes_by_the_filter() {
    let mut uno = serving("0\n707399\n787600\n827301\n877901\n");
    for (value, pins) in [(1, 1), (0, 0)] {
        write_words(&mut uno, 402, &[1, value]).unwrap();
        uno.run_ms(1).unwrap();
        assert_eq!(uno.outputs(), pins);
    }
}

#[test]
fn inputs_are_told_as_they_are_forced_in_a_fault_too() {
    let mut uno = in_state(FAULT);
    uno.set_inputs(0b0001);
    write_words(&mut uno, 402, &[0b0001_0011, 0b0001_0010]).unwrap();
    assert_eq!(bits(&mut uno, 2, 0, 8), 0b0001_0010);
}

/// The low word of the time goes over while both words are read.
#[test]
fn two_words_of_the_time_belong_together() {
    let mut uno = serving(FOLLOW);
    let millis = uno.symbol("MILLIS").unwrap().address;
    let scan = uno.symbol("scan_begin").unwrap().address;
    // It takes some 2.5 ms until the request is read; the two words, 15 us.
    for phase in 0..200 {
        uno.run_cycles(CYCLES_PER_MS / 200).unwrap();
        // Not while the clock's interrupt is counting.
        uno.run_until(scan, CYCLES_PER_MS).unwrap();
        uno.write_ram(millis, &0xFFFD_u32.to_le_bytes()).unwrap();
        let time = long(&words(&mut uno, 4, 22, 2));
        assert!((0xFFFE..0x1_0010).contains(&time), "{phase}: {time:#x}");
    }
}

#[test]
fn the_led_shows_forcing() {
    let mut uno = serving(FOLLOW);
    uno.take_edges();
    uno.run_ms(2000).unwrap();
    assert_eq!(uno.take_edges(), []);
    write(&mut uno, 402, 1).unwrap();
    // The first moment may have begun already.
    uno.run_ms(200).unwrap();
    uno.take_edges();
    uno.run_ms(4000).unwrap();
    let edges = uno.take_edges();
    let dark: Vec<u64> = edges
        .windows(2)
        .filter(|pair| !pair[0].high)
        .map(|pair| (pair[1].cycle - pair[0].cycle) / CYCLES_PER_MS)
        .collect();
    assert!((3..=4).contains(&dark.len()), "{dark:?}");
    assert!(dark.iter().all(|ms| (90..=110).contains(ms)), "{dark:?}");
    write(&mut uno, 402, 0).unwrap();
    uno.run_ms(200).unwrap();
    uno.take_edges();
    uno.run_ms(2000).unwrap();
    assert!(uno.take_edges().is_empty() && uno.led());
}
