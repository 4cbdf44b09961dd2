//! The Modbus server on the line: silence where a frame is not for it, settings, direction, and how long scans
//! grow.

use crate::BOARD;
use crate::common;
use crate::common::modbus::{
    ask, exchange, input, serving, to_serving, with_crc, words, write, write_words,
};
use crate::common::{card, ms_until, place, to_run};
use unoclp_core::Board;
use unoclp_modbus::eeprom::settings;
use unoclp_testing::cases;
use unoclp_uno_sim::{CYCLES_PER_MS, Flaw, Line, Parity, Slot, Uno};

const TEXT: &str = "0\n827301\n827302\n877901\n";
const STOP: u16 = 2;
const RESTART: u16 = 4;
/// State, 1 word.
const GOOD: [u8; 6] = [1, 4, 0, 16, 0, 1];

fn running() -> Uno {
    serving(TEXT)
}

fn assert_answers(uno: &mut Uno, case: &str) {
    assert_eq!(ask(uno, &GOOD), Some(vec![1, 4, 2, 0, 1]), "{case}");
}

#[test]
fn what_is_wrong_gets_silence() {
    let mut uno = running();
    let whole = with_crc(&GOOD);
    for byte in 0..whole.len() {
        for bit in 0..8 {
            let mut wrong = whole.clone();
            wrong[byte] ^= 1 << bit;
            assert_eq!(exchange(&mut uno, &wrong, 4), None, "{byte} {bit}");
        }
    }
    for server in 2..=255 {
        let frame = [&[server], &GOOD[1..]].concat();
        assert_eq!(exchange(&mut uno, &with_crc(&frame), 4), None, "{server}");
    }
    for length in 1..whole.len() {
        assert_eq!(exchange(&mut uno, &whole[..length], 4), None, "{length}");
    }
    assert_eq!(
        exchange(&mut uno, &[whole.clone(), vec![1]].concat(), 4),
        None
    );
    assert_eq!(exchange(&mut uno, &[vec![0; 300], whole].concat(), 4), None);
    // A checksum that is right, and no function.
    assert_eq!(exchange(&mut uno, &with_crc(&[1]), 4), None);
    assert_answers(&mut uno, "after all that");
}

#[test]
fn a_flaw_in_one_byte_gets_silence() {
    let mut uno = running();
    let whole = with_crc(&GOOD);
    for flawed in 0..whole.len() {
        uno.send_serial(&whole[..flawed]);
        uno.send_serial_flawed(&whole[flawed..=flawed], Flaw::Framing);
        assert_eq!(
            exchange(&mut uno, &whole[flawed + 1..], 4),
            None,
            "{flawed}"
        );
        assert_answers(&mut uno, "after a flaw");
    }
}

#[test]
fn a_frame_ends_with_silence_and_goes_on_without() {
    let mut uno = running();
    let whole = with_crc(&GOOD);
    for (gap_us, answered) in [(0, true), (900, true), (2200, false)] {
        let end = uno.send_serial(&whole[..3]);
        let at = end + gap_us * CYCLES_PER_MS / 1000;
        uno.send_serial_at(at, &whole[3..]);
        uno.run_cycles(at - uno.cycles()).unwrap();
        let reply = exchange(&mut uno, &[], 8);
        assert_eq!(reply.is_some(), answered, "{gap_us} us");
    }
    // Two frames with silence between them: the first is foreign, and does not spoil the second.
    let foreign = with_crc(&[9, 4, 0, 16, 0, 1]);
    let end = uno.send_serial(&foreign);
    let at = end + 2 * CYCLES_PER_MS;
    uno.send_serial_at(at, &whole);
    uno.run_cycles(at - uno.cycles()).unwrap();
    assert!(exchange(&mut uno, &[], 8).is_some());
}

/// A program that fills run memory with divisions: its scan takes many ms.
pub fn long_scans() -> String {
    format!("0\n766801\n{}838403\n", "68738602\n".repeat(230))
}

/// Cycles of silence that a frame may follow another by, at least.
fn least_gap(line: Line) -> u64 {
    match line.baud {
        ..=19_200 => line.cycles(1) * 7 / 2,
        _ => CYCLES_PER_MS * 7 / 4,
    }
}

/// After a frame for another station, its reply, noise, or what is too long for a frame: the next request is
/// answered after every legal gap, wherever in a scan that ends.
#[test]
fn every_legal_gap_behind_a_foreign_frame_will_do() {
    const GAPS: u64 = 24;
    let whole = with_crc(&GOOD);
    let before = [
        vec![0x02, 0x03, 0x00, 0x00, 0x00, 0x01, 0x84, 0x39],
        with_crc(&[2, 3, 4, 0, 1, 0, 2]),
        vec![0x00],
        vec![0xFF, 0x01, 0x03],
        vec![0x5A; 300],
    ];
    let rates = [24, 48, 96, 192, 288, 384, 576, 1152];
    let programs = [TEXT.to_owned(), long_scans()];
    let all = programs
        .iter()
        .flat_map(|program| rates.map(|rate| (program, rate)));
    for (program, rate) in cases(all) {
        let mut uno = serving(program);
        write_words(&mut uno, 0, &[0x7FFF, 0xFFFF, 0, 3]).unwrap();
        set(&mut uno, [1, rate, 0, 0]);
        let (scan, least) = (longest(&mut uno, 4), least_gap(uno.serial_line()));
        // Over a scan and a ms, from the shortest on.
        let step = (scan + CYCLES_PER_MS) / GAPS;
        for n in 0..GAPS {
            let foreign = &before[n as usize % before.len()];
            // Of the long one only a few, which takes long at a low rate.
            if foreign.len() > 256 && (n > 5 || rate < 96) {
                continue;
            }
            let end = uno.send_serial(foreign);
            let at = end + least + n * step;
            uno.send_serial_at(at, &whole);
            uno.run_cycles(at - uno.cycles()).unwrap();
            let reply = exchange(&mut uno, &[], 80);
            let gap = (at - end) as f64 / CYCLES_PER_MS as f64;
            assert_eq!(
                reply,
                Some(vec![1, 4, 2, 0, 1]),
                "{rate}00 baud, a scan of {scan} cycles, {foreign:02x?}, {gap:.3} ms"
            );
        }
    }
}

/// Noise after a request, before a scan has ended, does not spoil it.
#[test]
fn a_request_that_waits_for_a_scan_to_end_is_not_spoilt() {
    let mut uno = serving(&long_scans());
    write_words(&mut uno, 0, &[0x7FFF, 0xFFFF, 0, 3]).unwrap();
    for gap_us in (2_000..12_000).step_by(700) {
        let end = uno.send_serial(&with_crc(&GOOD));
        let noise = [0xFF, 0x02];
        uno.send_serial_at(end + gap_us * CYCLES_PER_MS / 1000, &noise);
        uno.run_ms(60).unwrap();
        let reply: Vec<u8> = uno.take_serial_log().iter().map(|sent| sent.byte).collect();
        assert_eq!(reply, with_crc(&[1, 4, 2, 0, 1]), "{gap_us} us");
        uno.run_ms(3).unwrap();
        assert_answers(&mut uno, "after noise");
    }
}

#[test]
fn a_frame_of_the_longest_length_is_answered() {
    let mut uno = running();
    let longest = |length: usize| {
        let mut frame = vec![0; length - 2];
        frame[..2].copy_from_slice(&[1, 0x64]);
        with_crc(&frame)
    };
    for length in [254, 255, 256] {
        let reply = exchange(&mut uno, &longest(length), 8);
        assert_eq!(reply, Some(vec![1, 0xE4, 1]), "{length}");
        // Its last byte counts.
        let mut wrong = longest(length);
        wrong[length - 1] ^= 1;
        assert_eq!(exchange(&mut uno, &wrong, 8), None, "{length}");
        uno.send_serial(&longest(length)[..length - 1]);
        let end = uno.send_serial_flawed(&longest(length)[length - 1..], Flaw::Framing);
        uno.run_cycles(end - uno.cycles()).unwrap();
        assert_eq!(exchange(&mut uno, &[], 8), None, "{length}");
    }
    for length in [257, 258, 511, 512, 513] {
        assert_eq!(exchange(&mut uno, &longest(length), 8), None, "{length}");
        assert_answers(&mut uno, "after one that is too long");
    }
}

/// Sets the board to this, and restarts it.
fn set(uno: &mut Uno, settings: [u16; 4]) {
    write(uno, 400, STOP).unwrap();
    write_words(uno, 410, &settings).unwrap();
    assert_eq!(words(uno, 3, 410, 4), settings);
    write(uno, 400, RESTART).unwrap();
    let parity = [Parity::None, Parity::Even, Parity::Odd][usize::from(settings[2])];
    uno.set_serial_line(Line {
        baud: u32::from(settings[1]) * 100,
        parity,
    });
    to_run(uno);
    uno.run_ms(20).unwrap();
    uno.take_serial_log();
}

#[test]
fn each_rate_and_parity() {
    let rates = [24, 48, 96, 192, 288, 384, 576, 1152];
    for (rate, parity) in cases(
        rates
            .into_iter()
            .flat_map(|rate| [0, 1, 2].map(|parity| (rate, parity))),
    ) {
        let mut uno = running();
        set(&mut uno, [1, rate, parity, 0]);
        let case = format!("{rate}00 baud, parity {parity}");
        assert_answers(&mut uno, &case);
        // What it sends is of that rate and form.
        uno.send_serial(&with_crc(&GOOD));
        uno.run_ms(150).unwrap();
        let sent = uno.take_serial_log();
        let expected = uno.serial_line();
        assert_eq!(sent.len(), 7, "{case}");
        let character = expected.cycles(1) as f64;
        for byte in sent {
            assert_eq!(byte.parity, expected.parity, "{case}");
            let took = (byte.end - byte.start) as f64;
            assert!((took / character - 1.0).abs() < 0.022, "{case}: {took}");
        }
        if parity > 0 {
            uno.send_serial_flawed(&with_crc(&GOOD)[..1], Flaw::Parity);
            assert_eq!(exchange(&mut uno, &with_crc(&GOOD)[1..], 8), None, "{case}");
            assert_answers(&mut uno, &case);
        }
    }
}

#[test]
fn the_address_is_kept_and_the_way_back_is_the_switch_and_all_inputs() {
    let mut uno = running();
    set(&mut uno, [247, 1152, 0, 0]);
    assert_eq!(exchange(&mut uno, &with_crc(&GOOD), 8), None);
    let other = [&[247], &GOOD[1..]].concat();
    assert_eq!(ask(&mut uno, &other), Some(vec![247, 4, 2, 0, 1]));
    uno.power_up();
    to_serving(&mut uno);
    assert_eq!(ask(&mut uno, &other), Some(vec![247, 4, 2, 0, 1]));

    // Not with three inputs alone.
    for (inputs, back) in [(0b0111, false), (0b1111, true)] {
        uno.set_stop(true);
        uno.set_inputs(inputs);
        uno.reset();
        ms_until(&mut uno, &["STOP\r\n"]);
        // Until the port listens.
        uno.run_ms(5).unwrap();
        assert_eq!(ask(&mut uno, &GOOD).is_some(), back, "{inputs:04b}");
    }
    assert_eq!(words(&mut uno, 3, 410, 4), [1, 1152, 0, 0]);
    write(&mut uno, 410, 1).unwrap();
    uno.set_stop(false);
    uno.reset();
    to_serving(&mut uno);
    assert_answers(&mut uno, "its own address again");
}

#[test]
fn settings_are_checked_and_not_written_in_run() {
    let mut uno = running();
    assert_eq!(words(&mut uno, 3, 410, 4), [1, 1152, 0, 0]);
    assert_eq!(write(&mut uno, 410, 2), Err(4));
    write(&mut uno, 400, STOP).unwrap();
    for (address, value) in [
        (410, 0),
        (410, 248),
        (411, 23),
        (411, 1153),
        (412, 3),
        (413, 2),
    ] {
        assert_eq!(write(&mut uno, address, value), Err(3), "{address} {value}");
    }
    assert_eq!(write_words(&mut uno, 410, &[2, 96, 1, 2]), Err(3));
    assert_eq!(words(&mut uno, 3, 410, 4), [1, 1152, 0, 0]);
    assert!(
        uno.eeprom_writes()
            .iter()
            .all(|write| write.address < place(settings::OLD))
    );
}

/// In both slots, whichever byte is turned over.
#[test]
fn settings_that_are_damaged_twice_are_the_defaults() {
    let mut uno = running();
    set(&mut uno, [7, 96, 1, 0]);
    let bytes = settings::SLOT_BYTES;
    let kept = uno
        .read_eeprom(place(settings::FIRST), 2 * usize::from(bytes))
        .unwrap();
    for byte in 0..bytes {
        let mut uno = running();
        uno.write_eeprom(place(settings::FIRST), &kept).unwrap();
        for at in [byte, bytes + byte] {
            let damaged = kept[usize::from(at)] ^ 1;
            uno.write_eeprom(place(settings::FIRST) + at, &[damaged])
                .unwrap();
        }
        uno.power_up();
        to_serving(&mut uno);
        assert_answers(&mut uno, &format!("byte {byte}"));
        assert_eq!(words(&mut uno, 3, 410, 4), [1, 1152, 0, 0]);
    }
}

/// Settings as 0.1.0 kept them.
fn old_form(settings: [u16; 4]) -> Vec<u8> {
    let mut bytes: Vec<u8> = settings.into_iter().flat_map(u16::to_le_bytes).collect();
    let sum = unoclp_core::Crc16::of(&bytes).to_be_bytes();
    bytes.extend(sum);
    bytes
}

/// A board in STOP that was powered with these settings of 0.1.0, and what its other end is like then.
fn with_old_settings(settings: [u16; 4]) -> Uno {
    let mut uno = common::uno(Slot::Card(card(TEXT)));
    uno.write_eeprom(place(settings::OLD), &old_form(settings))
        .unwrap();
    speak(&mut uno, settings);
    to_serving(&mut uno);
    uno
}

/// The other end has the line of these settings.
fn speak(uno: &mut Uno, settings: [u16; 4]) {
    uno.set_serial_line(Line {
        baud: u32::from(settings[1]) * 100,
        parity: [Parity::None, Parity::Even, Parity::Odd][usize::from(settings[2])],
    });
}

#[test]
fn settings_that_0_1_0_kept_are_read() {
    let old = [1, 96, 1, 0];
    let mut uno = with_old_settings(old);
    assert_eq!(words(&mut uno, 3, 410, 4), old);
    let new = [1, 192, 2, 1];
    set(&mut uno, new);
    assert_eq!(words(&mut uno, 3, 410, 4), new);
    // What they took the place of never comes back.
    for slot in [settings::FIRST, settings::SECOND] {
        uno.write_eeprom(place(slot), &[settings::INVALID]).unwrap();
    }
    speak(&mut uno, [1, 1152, 0, 0]);
    uno.power_up();
    to_serving(&mut uno);
    assert_eq!(words(&mut uno, 3, 410, 4), [1, 1152, 0, 0]);
}

/// Every byte is written once at most, and a request that changes nothing writes nothing.
#[test]
fn a_request_keeps_the_settings_once() {
    let mut uno = running();
    write(&mut uno, 400, STOP).unwrap();
    for settings in [[7, 96, 1, 1], [8, 192, 2, 0], [9, 24, 1, 1]] {
        let before = uno.eeprom_wear();
        write_words(&mut uno, 410, &settings).unwrap();
        uno.run_ms(5).unwrap();
        let wear = uno.eeprom_wear();
        let most = before
            .iter()
            .zip(&wear)
            .map(|(before, after)| after - before);
        assert_eq!(most.max(), Some(1), "{settings:?}");
        write_words(&mut uno, 410, &settings).unwrap();
        write(&mut uno, 412, settings[2]).unwrap();
        uno.run_ms(5).unwrap();
        assert_eq!(uno.eeprom_wear(), wear, "{settings:?}");
    }
}

/// Wherever the supply fails while settings are written, in a byte or after it.
#[test]
fn settings_cut_by_a_power_failure_are_the_old_ones_or_the_new_ones() {
    let (old, new) = ([1, 96, 1, 0], [1, 192, 2, 1]);
    let request = {
        let mut frame = vec![1, 16, 1, 0x9A, 0, 4, 8];
        frame.extend(new.iter().flat_map(|word: &u16| word.to_be_bytes()));
        with_crc(&frame)
    };
    let firmware = common::firmware();
    let other = [1, 288, 0, 0];
    // Over settings of 0.1.0; over others in both slots; and once more.
    for saves in 0..3 {
        let mut uno = with_old_settings(if saves % 2 == 0 { old } else { other });
        for left in (0..saves).rev() {
            set(&mut uno, if left % 2 == 0 { old } else { other });
        }
        let eeprom = uno.read_eeprom(0, uno.chip().eeprom_len()).unwrap();
        let (mut kept_old, mut kept_new) = (0, 0);
        let cuts = (1..40).flat_map(|nth| [(nth, false), (nth, true)]);
        for (nth, during) in cuts {
            let case = format!("after {saves} saves, write {nth}, during {during}");
            let mut uno = Uno::with_program(firmware.clone(), Slot::Card(card(TEXT))).unwrap();
            uno.write_eeprom(0, &eeprom).unwrap();
            speak(&mut uno, old);
            uno.set_stop(true);
            ms_until(&mut uno, &["STOP\r\n"]);
            uno.run_ms(20).unwrap();
            if during {
                uno.cut_power_during_eeprom_write(nth);
            } else {
                uno.cut_power_after_eeprom_write(nth);
            }
            uno.send_serial(&request);
            let is_over = uno.run_ms(150).is_ok();
            let found = [old, new].into_iter().find(|settings| {
                speak(&mut uno, *settings);
                uno.power_up();
                // The other end may be of another rate: what is said tells nothing. A start takes 200 ms.
                uno.run_ms(400).unwrap();
                uno.take_serial();
                exchange(&mut uno, &with_crc(&GOOD), 8).is_some()
            });
            let found = found.unwrap_or_else(|| panic!("{case}: neither"));
            assert_eq!(words(&mut uno, 3, 410, 4), found, "{case}");
            if found == old {
                assert!(!is_over, "{case}");
                kept_old += 1;
            } else {
                kept_new += 1;
            }
            if is_over {
                break;
            }
        }
        assert!(kept_old > 8 && kept_new > 8, "{kept_old} {kept_new}");
    }
}

#[test]
fn the_direction_pin_frames_the_reply() {
    let mut uno = running();
    assert_eq!(ask(&mut uno, &GOOD), Some(vec![1, 4, 2, 0, 1]));
    assert!(!uno.direction());
    set(&mut uno, [1, 192, 0, 1]);
    // Not even for the text of the start.
    let direction = |uno: &mut Uno| -> Vec<(bool, u64)> {
        let edges = uno.take_edges().into_iter();
        edges
            .filter(|edge| edge.pin == unoclp_uno_sim::Pin::Direction)
            .map(|edge| (edge.high, edge.cycle))
            .collect()
    };
    assert_eq!(direction(&mut uno), []);
    // Of a board with two lines it is that of the second.
    let sent = if BOARD == Board::MEGA {
        uno.set_bus_line(uno.serial_line());
        uno.send_bus(&with_crc(&GOOD));
        uno.run_ms(20).unwrap();
        uno.take_bus_log()
    } else {
        uno.send_serial(&with_crc(&GOOD));
        uno.run_ms(20).unwrap();
        uno.take_serial_log()
    };
    let [(true, on), (false, off)] = direction(&mut uno)[..] else {
        panic!("the direction goes on and off once")
    };
    assert_eq!(sent.len(), 7);
    assert!(on <= sent[0].start && sent[0].start - on < 200);
    let late = off - sent[6].end;
    assert!(off >= sent[6].end && late < 600, "{late}");
    assert_answers(&mut uno, "with the direction pin");
}

/// The longest of so many scans, in cycles.
fn longest(uno: &mut Uno, scans: u32) -> u64 {
    let scan = uno.symbol("scan_begin").unwrap().address;
    uno.run_until(scan, 1_000_000).unwrap();
    let mut longest = 0;
    for _ in 0..scans {
        let begun = uno.cycles();
        uno.run_until(scan, 1_000_000).unwrap();
        longest = longest.max(uno.cycles() - begun);
    }
    longest
}

/// As much as a request can ask for, of a program with many timers: 60 of them fill its memory.
#[test]
fn no_scan_grows_by_more_than_300_us() {
    let timers: String = (0..60)
        .map(|n| format!("787600\n847978\n{}\n7901\n", 100_000 + n))
        .collect();
    let mut uno = serving(&format!("0\n{timers}"));
    set(&mut uno, [1, 96, 0, 0]);
    uno.run_ms(20).unwrap();
    let idle = longest(&mut uno, 4_000);
    let mut write_registers = vec![1, 16, 0, 0, 0, 64, 128];
    write_registers.extend([7; 128]);
    let mut write_presets = vec![1, 16, 0, 128, 0, 120, 240];
    write_presets.extend([0, 1, 0x86, 0xA0].repeat(60));
    let requests: [(&[u8], usize); 15] = [
        (&[1, 1, 0, 0, 0, 4], 1),
        (&[1, 1, 0, 16, 0, 64], 8),
        (&[1, 2, 0, 0, 0, 8], 1),
        (&[1, 3, 0, 0, 0, 64], 128),
        (&[1, 3, 0, 128, 0, 125], 250),
        (&[1, 3, 1, 0x92, 0, 4], 8),
        (&[1, 3, 1, 0x9A, 0, 4], 8),
        (&[1, 4, 0, 0, 0, 5], 10),
        (&[1, 4, 0, 16, 0, 17], 34),
        (&[1, 4, 0, 128, 0, 125], 250),
        (&[1, 15, 0, 16, 0, 64, 8, 1, 2, 3, 4, 5, 6, 7, 8], 3),
        (&[1, 16, 1, 0x92, 0, 4, 8, 0, 1, 0, 1, 0, 1, 0, 1], 3),
        (&write_registers, 3),
        (&write_presets, 3),
        (&[1, 0x2B, 14, 1, 0], 20),
    ];
    for (request, data) in requests {
        uno.send_serial(&with_crc(request));
        let most = longest(&mut uno, 4_000);
        println!("{request:02x?}: {idle} cycles idle, {most} at most");
        assert!(most <= idle + 4800, "{request:02x?}: {idle} {most}");
        let reply = uno.take_serial_log();
        assert!(reply.len() >= data + 5, "{request:02x?}: {}", reply.len());
        assert_eq!(reply[1].byte, request[1], "{request:02x?}");
    }
}

/// A program whose scans take 3 ms.
fn scans_of_3_ms() -> Uno {
    let timers = "787600\n847978\n100000\n7901\n".repeat(45);
    let mut uno = serving(&format!("0\n{timers}766801\n{}", "68738602\n".repeat(64)));
    write_words(&mut uno, 0, &[0x7FFF, 0xFFFF, 0, 3]).unwrap();
    let scan = longest(&mut uno, 100);
    println!("a scan of {scan} cycles");
    assert!((44_000..49_000).contains(&scan), "{scan} cycles");
    uno
}

/// Whatever a request asks for: 15 ms from its end to the first byte of the answer.
#[test]
fn an_answer_begins_within_15_ms_where_a_scan_takes_3() {
    let mut uno = scans_of_3_ms();
    let writes = |first: [u8; 2], words: u8, data: &[u8]| {
        let head = [1, 16, first[0], first[1], 0, words, 2 * words];
        [&head, data].concat()
    };
    let requests = [
        vec![1, 4, 0, 128, 0, 125],
        vec![1, 3, 0, 128, 0, 125],
        vec![1, 3, 0, 0, 0, 64],
        vec![1, 4, 0, 16, 0, 17],
        vec![1, 1, 0, 16, 0, 64],
        writes([0, 128], 90, &[0, 1, 0x86, 0xA0].repeat(45)),
        writes([0, 0], 1, &[0x7F, 0xFF]),
    ];
    for request in requests {
        let mut most = 0;
        for shift in 0..12 {
            uno.run_cycles(CYCLES_PER_MS * 3 + CYCLES_PER_MS / 4 * shift)
                .unwrap();
            uno.take_serial_log();
            let end = uno.send_serial(&with_crc(&request));
            uno.run_cycles(end - uno.cycles() + 30 * CYCLES_PER_MS)
                .unwrap();
            let reply = uno.take_serial_log();
            assert_eq!(reply[1].byte, request[1], "{request:02x?}");
            most = most.max(reply[0].start - end);
            uno.run_ms(30).unwrap();
        }
        let ms = most as f64 / CYCLES_PER_MS as f64;
        println!("{:02x?}: {ms:.2} ms", &request[..6]);
        assert!(most <= 15 * CYCLES_PER_MS, "{request:02x?}: {ms:.2} ms");
    }
}

/// Two contacts and a coil, with nothing on the serial port: 240 cycles at most.
#[test]
fn an_idle_server_costs_little() {
    let mut uno = running();
    let scan = uno.symbol("scan_begin").unwrap().address;
    uno.run_until(scan, 1_000_000).unwrap();
    let begun = uno.cycles();
    let scans = 20_000;
    for _ in 0..scans {
        uno.run_until(scan, 1_000_000).unwrap();
    }
    let mean = (uno.cycles() - begun) / scans;
    println!("{mean} cycles a scan");
    assert!(mean <= 240, "{mean}");
    assert_eq!(input(&mut uno, 16), 1);
}
