//! Modbus and the program's memory: markers, registers, timers, counters, readings.

use crate::common::modbus::{
    ask, bits, input, long, serving, words, write, write_coil, write_words,
};
use crate::common::to_run;
use unoclp_uno_sim::{Analogue, CYCLES_PER_MS, Uno};

const STOP: u16 = 2;
const RUN: u16 = 1;
const SINGLE_SCAN: u16 = 3;
const RESTART: u16 = 4;

/// The coil of M 01, and the registers of T 01 and C 01.
const MARKER: u16 = 16;
const TIMER: u16 = 128;
const COUNTER: u16 = 320;

/// The two words of a number, the high one first.
fn halves(value: i32) -> [u16; 2] {
    [(value >> 16) as u16, value as u16]
}

/// A number of 32 bits by function 3 or 4.
fn read_long(uno: &mut Uno, function: u8, first: u16) -> i32 {
    long(&words(uno, function, first, 2)) as i32
}

/// M 01 drives output 01, input 01 drives M 02; D 02 is D 01 and 1; M 04 is as M 03.
const EXCHANGE: &str = "0\n827701\n877901\n787600\n827301\n877702\n\
    787600\n766801\n65686800\n1\n838402\n787600\n827703\n877704\n";

#[test]
fn markers_go_both_ways() {
    let mut uno = serving(EXCHANGE);
    write_coil(&mut uno, MARKER, true).unwrap();
    uno.run_ms(1).unwrap();
    assert_eq!(uno.outputs(), 1);
    write_coil(&mut uno, MARKER, false).unwrap();
    uno.run_ms(1).unwrap();
    assert_eq!(uno.outputs(), 0);
    assert_eq!(bits(&mut uno, 1, MARKER, 4), 0);
    uno.set_inputs(1);
    uno.run_ms(1).unwrap();
    assert_eq!(bits(&mut uno, 1, MARKER, 4), 0b0010);
    // What the program writes in every scan is the program's.
    write_coil(&mut uno, MARKER + 1, false).unwrap();
    assert_eq!(bits(&mut uno, 1, MARKER, 4), 0b0010);
    write_coil(&mut uno, MARKER + 2, true).unwrap();
    assert_eq!(bits(&mut uno, 1, MARKER, 4), 0b1110);
}

#[test]
fn registers_go_both_ways() {
    let mut uno = serving(EXCHANGE);
    for value in [0, 0x1_FFFF, -1, -70_000, i32::MAX] {
        write_words(&mut uno, 0, &halves(value)).unwrap();
        uno.run_ms(1).unwrap();
        assert_eq!(read_long(&mut uno, 3, 0), value);
        assert_eq!(read_long(&mut uno, 3, 2), value.wrapping_add(1));
    }
    write_words(&mut uno, 0, &halves(0x1234_5678)).unwrap();
    write(&mut uno, 1, 0xFFFF).unwrap();
    uno.run_ms(1).unwrap();
    assert_eq!(read_long(&mut uno, 3, 2), 0x1235_0000);
}

/// D 40 is D 34 and D 98; D 41 is named by nobody, and there.
const FAR: &str = "0\n766834\n65686898\n838440\n";

#[test]
fn registers_beyond_32_go_both_ways() {
    let all = |register: u16| 2000 + 2 * (register - 1);
    let mut uno = serving(FAR);
    for value in [0, 0x1_FFFF, -70_000, i32::MAX] {
        write_words(&mut uno, all(34), &halves(value)).unwrap();
        write_words(&mut uno, all(98), &halves(-5)).unwrap();
        uno.run_ms(1).unwrap();
        assert_eq!(read_long(&mut uno, 3, 2 * 33), value);
        assert_eq!(read_long(&mut uno, 3, 2 * 39), value.wrapping_sub(5));
        assert_eq!(read_long(&mut uno, 3, all(40)), value.wrapping_sub(5));
    }
    write_words(&mut uno, 2 * 40, &halves(7)).unwrap();
    assert_eq!(read_long(&mut uno, 3, all(41)), 7);
    // All of them, by two requests.
    assert_eq!(words(&mut uno, 3, 2000, 98).last(), Some(&0));
    let last = words(&mut uno, 3, all(50), 98);
    assert_eq!(long(&last[96..]) as i32, -5);
    // They are 0 when the program begins again.
    write(&mut uno, 400, STOP).unwrap();
    assert_eq!(words(&mut uno, 3, all(50), 98), [0; 98]);
}

#[test]
fn registers_that_a_program_does_not_have_are_0_and_take_nothing() {
    // D 33 is there, D 34 not: the program stands after it.
    let mut uno = serving("0\n827301\n877901\n787600\n766833\n838401\n");
    write_words(&mut uno, 64, &[0, 3, 0x1234, 0x5678, 0xFFFF, 0xFFFF]).unwrap();
    write_words(&mut uno, 2000 + 66, &[0xFFFF; 120]).unwrap();
    assert_eq!(words(&mut uno, 3, 64, 6), [0, 3, 0, 0, 0, 0]);
    assert_eq!(words(&mut uno, 3, 2000 + 64, 100)[2..], [0; 98]);
    uno.set_inputs(1);
    uno.run_ms(5).unwrap();
    assert_eq!(uno.outputs(), 1);
    assert_eq!(read_long(&mut uno, 3, 0), 3);
}

/// D 64 is what is written to it; input 01 starts T 01.
const JOINED: &str = "0\n766864\n838401\n787600\n827301\n847978\n60000\n7901\n";

#[test]
fn a_request_goes_on_from_the_registers_into_the_presets() {
    let mut uno = serving(JOINED);
    let (last, preset) = ([0x1234, 0x5678], halves(60_000));
    write_words(&mut uno, TIMER - 2, &last).unwrap();
    assert_eq!(words(&mut uno, 3, TIMER - 2, 4), [last, preset].concat());
    assert_eq!(words(&mut uno, 3, TIMER - 1, 2), [last[1], preset[0]]);
    // Over several slices, and as far as a request goes.
    for first in [TIMER - 124, TIMER - 65, TIMER - 64, TIMER - 63, TIMER - 2] {
        let all = words(&mut uno, 3, first, 125);
        let at = usize::from(TIMER - 2 - first);
        assert_eq!(all[at..][..2], last, "{first}");
        if let Some(there) = all.get(at + 2..at + 4) {
            assert_eq!(there, preset, "{first}");
        }
        let others = all.iter().filter(|word| **word != 0).count();
        assert!(others <= 3, "{first}: {all:?}");
    }
    // Written, too: all of it or nothing.
    let new = [halves(-7), halves(70_000)].concat();
    write_words(&mut uno, TIMER - 2, &new).unwrap();
    assert_eq!(words(&mut uno, 3, TIMER - 2, 4), new);
    let negative = [halves(8), halves(-1)].concat();
    assert_eq!(write_words(&mut uno, TIMER - 2, &negative), Err(3));
    let beyond = [halves(8), halves(1), halves(1)].concat();
    assert_eq!(write_words(&mut uno, TIMER - 2, &beyond), Err(2));
    assert_eq!(words(&mut uno, 3, TIMER - 2, 4), new);
}

#[test]
fn in_stop_they_are_what_single_scans_see_and_run_begins_with_zeros() {
    let mut uno = serving(EXCHANGE);
    write_coil(&mut uno, MARKER + 2, true).unwrap();
    write_words(&mut uno, 0, &halves(7)).unwrap();
    write(&mut uno, 400, STOP).unwrap();
    assert_eq!(bits(&mut uno, 1, MARKER, 4), 0);
    assert_eq!(words(&mut uno, 3, 0, 4), [0; 4]);

    write_coil(&mut uno, MARKER, true).unwrap();
    write_words(&mut uno, 0, &halves(41)).unwrap();
    assert_eq!(bits(&mut uno, 1, 0, 1), 0);
    write(&mut uno, 400, SINGLE_SCAN).unwrap();
    assert_eq!(bits(&mut uno, 1, 0, 1), 1);
    assert_eq!(read_long(&mut uno, 3, 2), 42);
    assert_eq!(uno.outputs(), 0);

    write(&mut uno, 400, RUN).unwrap();
    assert_eq!(bits(&mut uno, 1, MARKER, 4), 0);
    assert_eq!(read_long(&mut uno, 3, 2), 1);
}

/// M 01 is set where D 01, D 17 or D 32 is neither 0 nor 131071, whose words are 1 and 65535; D 03 changes from one to
/// the other in each scan, and D 02 is a copy of D 01.
const WHOLE: &str = "0\n766801\n838402\n786900\n0\n786900\n131071\n83877701\n\
    787600\n766817\n786900\n0\n786900\n131071\n83877701\n\
    787600\n766832\n786900\n0\n786900\n131071\n83877701\n\
    787600\n766803\n88798200\n131071\n838403\n";
const BOTH: [[u16; 2]; 2] = [[0, 0], [1, 0xFFFF]];

#[test]
fn no_register_that_is_written_is_torn() {
    let mut uno = serving(WHOLE);
    let torn = |uno: &mut Uno| bits(uno, 1, MARKER, 1) != 0;
    for n in 0..200 {
        let value = BOTH[(n + 1) % 2];
        write_words(&mut uno, 0, &value).unwrap();
        assert_eq!(words(&mut uno, 3, 2, 2), value);
    }
    assert!(!torn(&mut uno));
    // All of them, over several scans, from the first on and from the third.
    for n in 0..50 {
        let value = BOTH[(n + 1) % 2];
        write_words(&mut uno, 0, &value.repeat(32)).unwrap();
        write_words(&mut uno, 4, &BOTH[n % 2].repeat(30)).unwrap();
    }
    assert!(!torn(&mut uno));
    // Half of it is what the program does see.
    write(&mut uno, 1, 0x8000).unwrap();
    uno.run_ms(1).unwrap();
    assert!(torn(&mut uno));
}

#[test]
fn no_register_that_is_read_is_torn() {
    let mut uno = serving(WHOLE);
    let mut seen = [0; 2];
    for n in 0..200 {
        // From D 01, D 02 or D 03 on, and from the middle of D 02.
        let first = [0, 2, 3, 4][n % 4];
        let words = words(&mut uno, 3, first, 64 - first);
        let at = usize::from(4 - first);
        let which = BOTH
            .iter()
            .position(|value| *value == words[at..at + 2])
            .unwrap_or_else(|| panic!("{words:04x?}"));
        seen[which] += 1;
    }
    assert!(seen.iter().all(|times| *times > 20), "{seen:?}");
}

/// Input 01 starts a TON for output 01, input 02 a TOF, input 03 a TOR.
const TIMERS: &str = "0\n827301\n847978\n60000\n7901\n787600\n827302\n847970\n60000\n7902\n\
    787600\n827303\n847982\n60000\n7903\n";

#[test]
fn a_preset_that_is_written_acts_at_once_until_the_program_begins_anew() {
    for begin in [
        |uno: &mut Uno| {
            write(uno, 400, RESTART).unwrap();
            to_run(uno);
        },
        |uno: &mut Uno| {
            write(uno, 400, STOP).unwrap();
            write(uno, 400, RUN).unwrap();
        },
    ] {
        let mut uno = serving(TIMERS);
        assert_eq!(words(&mut uno, 3, TIMER, 2), halves(60_000));
        uno.set_inputs(0b001);
        uno.run_ms(300).unwrap();
        assert_eq!(uno.outputs(), 0);
        write_words(&mut uno, TIMER, &halves(400)).unwrap();
        uno.run_ms(10).unwrap();
        assert_eq!(uno.outputs(), 0);
        uno.run_ms(150).unwrap();
        assert_eq!(uno.outputs(), 0b001);
        assert_eq!(
            words(&mut uno, 3, TIMER, 4),
            [halves(400), halves(60_000)].concat()
        );
        begin(&mut uno);
        assert_eq!(words(&mut uno, 3, TIMER, 2), halves(60_000));
        uno.run_ms(500).unwrap();
        assert_eq!(uno.outputs(), 0);
    }
}

#[test]
fn a_preset_in_stop_is_that_of_single_scans() {
    let mut uno = serving(TIMERS);
    uno.set_inputs(0b001);
    write(&mut uno, 400, STOP).unwrap();
    write_words(&mut uno, TIMER, &halves(0)).unwrap();
    write(&mut uno, 400, SINGLE_SCAN).unwrap();
    assert_eq!(bits(&mut uno, 1, 0, 4), 0b0001);
    assert_eq!(words(&mut uno, 3, TIMER, 2), halves(0));
}

/// Elapsed times of the three timers.
fn elapsed(uno: &mut Uno) -> [i32; 3] {
    let words = words(uno, 4, TIMER, 6);
    [0, 2, 4].map(|at| long(&words[at..at + 2]) as i32)
}

#[test]
fn elapsed_times() {
    let mut uno = serving(TIMERS);
    assert_eq!(elapsed(&mut uno), [0; 3]);
    uno.set_inputs(0b111);
    let begun = uno.cycles();
    let passed = |uno: &Uno| ((uno.cycles() - begun) / CYCLES_PER_MS) as i32;
    uno.run_ms(100).unwrap();
    let earlier = passed(&uno);
    let told = elapsed(&mut uno);
    let later = passed(&uno);
    let about = |told: i32| (earlier - 2..=later).contains(&told);
    assert!(about(told[0]) && about(told[2]), "{told:?}");
    assert_eq!(told[1], 0);
    // The delay of a TOF runs from the end of its input on; a TOR keeps what it has, and a TON does not.
    uno.set_inputs(0);
    uno.run_ms(50).unwrap();
    let [on, off, kept] = elapsed(&mut uno);
    assert_eq!(on, 0);
    assert!((48..=60).contains(&off), "{off}");
    assert!((kept - told[2]).abs() < 20, "{kept} {told:?}");
    uno.run_ms(50).unwrap();
    assert_eq!(elapsed(&mut uno)[2], kept);
    // What is over stays at the preset.
    write_words(&mut uno, TIMER, &[halves(30), halves(40)].concat()).unwrap();
    uno.set_inputs(0b001);
    uno.run_ms(100).unwrap();
    assert_eq!(elapsed(&mut uno), [30, 0, kept]);
    // Timers that the program does not have.
    assert_eq!(words(&mut uno, 4, TIMER + 6, 100), [0; 100]);
}

/// Input 01 counts C 01 up, to 3; input 02 sets C 02 to -70000.
const COUNTERS: &str = "0\n827301\n67848501\n3\n877901\n787600\n827302\n766800\n-70000\n83846702\n";

#[test]
fn counters() {
    let mut uno = serving(COUNTERS);
    let press = |uno: &mut Uno, inputs| {
        for inputs in [inputs, 0] {
            uno.set_inputs(inputs);
            uno.run_ms(2).unwrap();
        }
    };
    assert_eq!(words(&mut uno, 3, COUNTER, 2), halves(3));
    for pressed in 1..=3 {
        press(&mut uno, 0b01);
        assert_eq!(read_long(&mut uno, 4, COUNTER), pressed);
        assert_eq!(uno.outputs(), u8::from(pressed == 3));
    }
    write_words(&mut uno, COUNTER, &halves(5)).unwrap();
    uno.run_ms(1).unwrap();
    assert_eq!(uno.outputs(), 0);
    assert_eq!(read_long(&mut uno, 4, COUNTER), 3);
    press(&mut uno, 0b01);
    assert_eq!(uno.outputs(), 0);
    press(&mut uno, 0b11);
    assert_eq!(uno.outputs(), 1);
    assert_eq!(
        words(&mut uno, 4, COUNTER, 6),
        [halves(5), halves(-70_000), halves(0)].concat()
    );
    write(&mut uno, 400, STOP).unwrap();
    assert_eq!(read_long(&mut uno, 4, COUNTER), 0);
    assert_eq!(words(&mut uno, 3, COUNTER, 2), halves(3));
}

#[test]
fn analogue_readings_in_run_and_in_stop() {
    let text: String = (0..5)
        .map(|n| format!("766865{n:02}\n8384{:02}\n", n + 1))
        .collect();
    let mut uno = serving(&format!("0\n{text}"));
    for state in [RUN, STOP] {
        if state == STOP {
            write(&mut uno, 400, STOP).unwrap();
        }
        for readings in [[0, 1, 511, 512, 1023], [1023, 700, 0, 3, 256]] {
            for (channel, reading) in readings.into_iter().enumerate() {
                uno.set_analogue(channel, Analogue::Reading(reading));
            }
            // Two ms for each of the five, and for the reference.
            uno.run_ms(15).unwrap();
            assert_eq!(words(&mut uno, 4, 0, 5), readings, "{state}");
            if state == RUN {
                let registers = words(&mut uno, 3, 0, 10);
                let low = registers.iter().skip(1).step_by(2);
                assert!(low.eq(&readings), "{registers:?}");
            }
        }
    }
}

/// D 01 is the time of the last scan, as LDS 01 gives it, D 02 the time stamp.
#[test]
fn system_readings_are_those_of_the_diagnostics() {
    let mut uno = serving("0\n76688301\n838401\n76688302\n838402\n");
    uno.run_ms(50).unwrap();
    for _ in 0..20 {
        uno.run_ms(1).unwrap();
        let time = read_long(&mut uno, 3, 0);
        let times = words(&mut uno, 4, 25, 2);
        let within = i32::from(times[0])..=i32::from(times[1]);
        assert!(time > 0 && within.contains(&time), "{time} {within:?}");
        let stamp = read_long(&mut uno, 3, 2);
        let uptime = read_long(&mut uno, 4, 22);
        assert!((stamp..stamp + 20).contains(&uptime), "{stamp} {uptime}");
    }
}

#[test]
fn inputs_05_to_08_are_read_and_forced() {
    let text: String = (1..5)
        .map(|n| format!("787600\n8273{:02}\n8779{n:02}\n", n + 4))
        .collect();
    let mut uno = serving(&format!("0\n{text}"));
    uno.set_inputs(0b1010_0110);
    uno.run_ms(2).unwrap();
    assert_eq!(bits(&mut uno, 2, 0, 8), 0b1010_0110);
    assert_eq!(bits(&mut uno, 2, 4, 4), 0b1010);
    write_words(&mut uno, 402, &[0b1100_0000, 0b0100_0000]).unwrap();
    uno.run_ms(1).unwrap();
    assert_eq!(bits(&mut uno, 2, 0, 8), 0b0110_0110);
    assert_eq!(uno.outputs(), 0b0110);
}

/// Output 01 shows M 57, output 02 shows M 56, output 03 M 64.
const RETENTIVE: &str = "0\n827757\n877901\n787600\n827756\n877902\n787600\n827764\n877903\n";

#[test]
fn a_retentive_marker_that_is_written_outlasts_a_power_cut() {
    for state in [RUN, STOP] {
        let mut uno = serving(RETENTIVE);
        if state == STOP {
            write(&mut uno, 400, STOP).unwrap();
        }
        for marker in [56, 57, 64] {
            write_coil(&mut uno, MARKER + marker - 1, true).unwrap();
        }
        uno.run_ms(30).unwrap();
        uno.power_up();
        to_run(&mut uno);
        uno.run_ms(2).unwrap();
        assert_eq!(uno.outputs(), 0b101, "{state}");
        assert_eq!(bits(&mut uno, 1, MARKER + 56, 8), 0b1000_0001);
        let reply = ask(&mut uno, &[1, 15, 0, 72, 0, 8, 1, 0b10]);
        assert_eq!(reply, Some(vec![1, 15, 0, 72, 0, 8]));
        uno.run_ms(30).unwrap();
        uno.power_up();
        to_run(&mut uno);
        assert_eq!(bits(&mut uno, 1, MARKER + 56, 8), 0b10);
        assert_eq!(input(&mut uno, 16), RUN);
    }
}
