//! A program that comes over Modbus in place of a card.

use crate::BOARD;
use crate::common;
use crate::common::modbus::{FORM, ask, bits, input, long, with_crc, words, write};
use crate::common::{card, ms_until, to_run, uno};
use unoclp_testing::cases;
use unoclp_uno_sim::{Slot, Uno};

/// Output 01 follows input 01.
const OLD: &str = "0\n827301\n877901\n";
/// Output 02 is on.
const NEW: &str = "0\n877902\n";

const RUN: u16 = 1;
const STOP: u16 = 2;
const FAULT: u16 = 3;
const RESTART: u16 = 4;
const UPLOAD: u16 = 5;

pub fn stopped() -> Uno {
    let mut uno = uno(Slot::Card(card(OLD)));
    to_run(&mut uno);
    write(&mut uno, 400, STOP).unwrap();
    uno
}

/// A block of a text, as function 16 writes it.
fn block(number: u8, text: &[u8]) -> Vec<u8> {
    let mut data = vec![number, text.len() as u8];
    data.extend(text);
    data.resize(data.len().next_multiple_of(2), 0xEE);
    let mut frame = vec![1, 16, 3, 0xE8, 0, data.len() as u8 / 2, data.len() as u8];
    frame.extend(data);
    frame
}

/// Sends a block.
fn send(uno: &mut Uno, number: u8, text: &[u8]) -> Result<(), u8> {
    let frame = block(number, text);
    let reply = common::modbus::exchange(uno, &with_crc(&frame), 5 * u64::from(BOARD.stored_bytes))
        .expect("a reply");
    if reply == frame[..6] {
        Ok(())
    } else {
        assert_eq!(reply[..2], [1, 0x90]);
        Err(reply[2])
    }
}

/// Sends texts one after the other, in blocks of so many bytes.
pub fn upload(uno: &mut Uno, texts: [&str; 2], bytes: usize) -> Result<(), u8> {
    write(uno, 400, UPLOAD)?;
    let mut number = 0u8;
    for text in texts {
        for part in text.as_bytes().chunks(bytes).chain([&[][..]]) {
            assert_eq!(input(uno, 17) >> 3 & 1, 1);
            send(uno, number, part)?;
            number = number.wrapping_add(1);
        }
    }
    Ok(())
}

/// The outcome in the diagnostics: whether an upload is in progress, fault, line.
fn outcome(uno: &mut Uno) -> (bool, u16, u32) {
    let told = words(uno, 4, 17, 5);
    (told[0] >> 3 & 1 == 1, told[1], long(&told[3..5]))
}

/// The board is in STOP with its old program.
fn assert_old(uno: &mut Uno, case: &str) {
    assert_eq!(input(uno, 16), STOP, "{case}");
    write(uno, 400, RUN).unwrap();
    for inputs in [1, 0] {
        uno.set_inputs(inputs);
        uno.run_ms(2).unwrap();
        assert_eq!(uno.outputs(), inputs, "{case}");
    }
}

#[test]
fn a_program_is_checked_stored_and_run() {
    for bytes in [1, 2, 7, 244] {
        let mut uno = stopped();
        upload(&mut uno, [NEW; 2], bytes).unwrap();
        assert_eq!(outcome(&mut uno), (false, 0, 0));
        assert_eq!((input(&mut uno, 16), input(&mut uno, 28)), (STOP, 1));
        assert_eq!(bits(&mut uno, 1, 0, 4), 0);
        write(&mut uno, 400, RUN).unwrap();
        uno.run_ms(2).unwrap();
        assert_eq!(uno.outputs(), 0b10);
        // Without a card it is what runs.
        uno.swap_slot(Slot::Empty);
        uno.power_up();
        to_run(&mut uno);
        uno.run_ms(2).unwrap();
        assert_eq!(uno.outputs(), 0b10);
    }
}

#[test]
fn the_largest_program_fits() {
    let text =
        "0\n".to_owned() + &"827301\n".repeat(usize::from(BOARD.stored_bytes) - 1) + "877904\n";
    let mut uno = stopped();
    upload(&mut uno, [&text; 2], 244).unwrap();
    assert_eq!(input(&mut uno, 28), BOARD.stored_bytes);
    uno.set_inputs(1);
    write(&mut uno, 400, RUN).unwrap();
    // It begins again out of the EEPROM.
    uno.run_ms(60 * u64::from(BOARD.stored_bytes) / 900)
        .unwrap();
    assert_eq!(uno.outputs(), 0b1000);
    assert!(uno.stack_free() > 0);
}

#[test]
fn faults_are_those_of_a_card_and_the_old_program_stays() {
    for (text, fault, line) in [
        ("", 21, 0),
        ("877902\n", 22, 1),
        ("0\n\n/ comment\n877917\n", 26, 4),
        ("0\n40\n827301\n", 32, 2),
        ("0\n827301\n847978\n500\n", 35, 3),
        ("0\r827301", 13, 1),
        ("0\n877902\r", 13, 2),
    ] {
        let mut card_uno = uno(Slot::Card(card(text)));
        ms_until(&mut card_uno, &["fault "]);
        card_uno.run_ms(20).unwrap();
        assert_eq!(outcome(&mut card_uno), (false, fault, line), "{text:?}");

        let mut uno = stopped();
        assert_eq!(upload(&mut uno, [text; 2], 5), Err(4), "{text:?}");
        assert_eq!(outcome(&mut uno), (false, fault, line), "{text:?}");
        assert_eq!(send(&mut uno, 0, b"0"), Err(4));
        assert_old(&mut uno, text);
        assert_eq!(input(&mut uno, 18), fault);
    }
}

#[test]
fn another_text_the_second_time_is_a_fault() {
    let mut uno = stopped();
    assert_eq!(upload(&mut uno, [NEW, OLD], 50), Err(4));
    assert_eq!(outcome(&mut uno), (false, 57, 0));
    assert_old(&mut uno, "another text");
}

#[test]
fn blocks_are_repeated_and_in_order() {
    let mut uno = stopped();
    assert_eq!(send(&mut uno, 0, b"0\n"), Err(4), "no upload yet");
    write(&mut uno, 400, UPLOAD).unwrap();
    assert_eq!(
        send(&mut uno, 255, b""),
        Err(3),
        "not the one before the first"
    );
    let mut number = 0;
    for _ in 0..2 {
        for part in [&b"0\n8779"[..], b"02\n", b""] {
            assert_eq!(send(&mut uno, number + 1, part), Err(3));
            for _ in 0..3 {
                send(&mut uno, number, part).unwrap();
            }
            number += 1;
        }
    }
    assert_eq!(outcome(&mut uno), (false, 0, 0));
    assert_eq!(input(&mut uno, 28), 1);
}

/// The same answer, and nothing is stored again; until another upload begins.
#[test]
fn the_second_end_may_be_repeated() {
    let mut uno = stopped();
    upload(&mut uno, [NEW; 2], 100).unwrap();
    let (sum, wear) = (input(&mut uno, 29), uno.eeprom_wear());
    for _ in 0..3 {
        send(&mut uno, 3, b"").unwrap();
        assert_eq!(outcome(&mut uno), (false, 0, 0));
    }
    // No other block, nor another end.
    assert_eq!(send(&mut uno, 3, b"0\n"), Err(4));
    assert_eq!(send(&mut uno, 2, b""), Err(4));
    assert_eq!(send(&mut uno, 4, b""), Err(4));
    assert_eq!((input(&mut uno, 29), uno.eeprom_wear()), (sum, wear));
    write(&mut uno, 400, RUN).unwrap();
    send(&mut uno, 3, b"").unwrap();
    assert_eq!(input(&mut uno, 16), RUN);
    write(&mut uno, 400, STOP).unwrap();
    write(&mut uno, 400, UPLOAD).unwrap();
    write(&mut uno, 400, STOP).unwrap();
    uno.run_ms(5).unwrap();
    assert_eq!(send(&mut uno, 3, b""), Err(4));

    // One that was refused is refused again.
    let mut uno = stopped();
    assert_eq!(upload(&mut uno, [NEW, OLD], 100), Err(4));
    assert_eq!(send(&mut uno, 3, b""), Err(4));
    assert_old(&mut uno, "refused");
}

/// The client is gone; others may go on reading.
#[test]
fn ten_seconds_without_a_block_end_an_upload() {
    let mut uno = stopped();
    write(&mut uno, 400, UPLOAD).unwrap();
    uno.run_ms(9_800).unwrap();
    send(&mut uno, 0, b"0\n8779").unwrap();
    for _ in 0..9 {
        uno.run_ms(1_050).unwrap();
        assert_eq!(outcome(&mut uno), (true, 0, 0));
    }
    uno.run_ms(600).unwrap();
    assert_eq!(outcome(&mut uno), (false, 0, 0));
    assert_eq!(send(&mut uno, 1, b"02\n"), Err(4));
    assert_old(&mut uno, "forsaken");
}

#[test]
fn two_clients_cannot_mix_their_uploads() {
    // Of the same length, so that both count alike.
    let other = "0\n877904\n";
    assert_eq!(other.len(), NEW.len());
    let parts = |text: &'static str| [&text.as_bytes()[..4], &text.as_bytes()[4..], b""];
    // Each block of the first is followed by the same one of the second, from some block on.
    for from in 0..6 {
        let mut uno = stopped();
        write(&mut uno, 400, UPLOAD).unwrap();
        assert_eq!(write(&mut uno, 400, UPLOAD), Err(4), "{from}");
        let mut refused = false;
        for number in 0..6 {
            let part = usize::from(number) % 3;
            refused |= send(&mut uno, number, parts(NEW)[part]).is_err();
            if number >= from && parts(NEW)[part] != parts(other)[part] {
                assert_eq!(send(&mut uno, number, parts(other)[part]), Err(4), "{from}");
                assert_eq!(outcome(&mut uno), (false, 57, 0), "{from}");
                refused = true;
                break;
            }
        }
        assert_eq!(refused, from < 5, "{from}");
        if refused {
            assert_old(&mut uno, "mixed");
        }
    }
    // They take turns in the second text.
    let mut uno = stopped();
    write(&mut uno, 400, UPLOAD).unwrap();
    let mixed = [parts(NEW), [parts(NEW)[0], parts(other)[1], b""]].concat();
    let sent: Vec<_> = (0..)
        .zip(mixed)
        .map(|(n, part)| send(&mut uno, n, part))
        .collect();
    assert_eq!(sent.last(), Some(&Err(4)));
    assert_eq!(outcome(&mut uno), (false, 57, 0));
    assert_old(&mut uno, "in turns");
}

/// A5 is closed and opened while the text comes: the board is then in what A5 and the commands say.
#[test]
fn the_switch_during_an_upload() {
    for (by_command, at_the_end) in [(true, false), (true, true), (false, false), (false, true)] {
        let mut uno = uno(Slot::Card(card(OLD)));
        to_run(&mut uno);
        uno.run_ms(5).unwrap();
        if by_command {
            write(&mut uno, 400, STOP).unwrap();
        } else {
            uno.set_stop(true);
            uno.run_ms(5).unwrap();
        }
        write(&mut uno, 400, UPLOAD).unwrap();
        for (number, part) in (0..).zip([&b"0\n87"[..], b"7902\n", b"", b"0\n87", b"7902\n"]) {
            send(&mut uno, number, part).unwrap();
            uno.set_stop(number % 2 == 0);
            uno.run_ms(7).unwrap();
            assert_eq!(uno.outputs(), 0);
            assert_eq!(input(&mut uno, 17) & 1, u16::from(number % 2 == 0));
        }
        uno.set_stop(at_the_end);
        send(&mut uno, 5, b"").unwrap();
        uno.run_ms(5).unwrap();
        let case = format!("by command {by_command}, closed {at_the_end}");
        let runs = !by_command && !at_the_end;
        let bits = u16::from(at_the_end) | u16::from(by_command) << 1;
        let state = if runs { RUN } else { STOP };
        assert_eq!(words(&mut uno, 4, 16, 3), [state, FORM | bits, 0], "{case}");
        assert_eq!(words(&mut uno, 3, 400, 1), [state], "{case}");
        assert_eq!(uno.outputs(), if runs { 0b10 } else { 0 }, "{case}");
        assert_eq!(write(&mut uno, 400, RUN).is_ok(), !at_the_end, "{case}");
        uno.set_stop(false);
        uno.run_ms(5).unwrap();
        let waits = by_command && at_the_end;
        assert_eq!(uno.outputs(), if waits { 0 } else { 0b10 }, "{case}");
    }
}

#[test]
fn a_block_says_how_long_it_is() {
    let mut uno = stopped();
    write(&mut uno, 400, UPLOAD).unwrap();
    for (words, expected) in [(1u8, 3), (2, 0), (3, 3)] {
        let mut frame = vec![1, 16, 3, 0xE8, 0, words, words * 2, 0, 2, b'0', b'\n', 0, 0];
        frame.truncate(7 + usize::from(words) * 2);
        let reply = ask(&mut uno, &frame).unwrap();
        match expected {
            0 => assert_eq!(reply, frame[..6]),
            code => assert_eq!(reply, [1, 0x90, code]),
        }
    }
    // Only from the first address on, and only by function 16.
    assert_eq!(
        ask(&mut uno, &[1, 16, 3, 0xE9, 0, 1, 2, 0, 0]),
        Some(vec![1, 0x90, 2])
    );
    assert_eq!(
        ask(&mut uno, &[1, 6, 3, 0xE8, 0, 0]),
        Some(vec![1, 0x86, 2])
    );
    assert_eq!(
        ask(&mut uno, &[1, 3, 3, 0xE8, 0, 1]),
        Some(vec![1, 0x83, 2])
    );
    assert!(outcome(&mut uno).0);
}

/// Not its refusal either, which comes later than that of other requests.
#[test]
fn nobody_answers_a_broadcast_during_an_upload() {
    let mut uno = stopped();
    let wrong: [&[u8]; 8] = [
        &[0, 16, 3, 0xE8, 0, 2, 4, 0, 1, b'x', 0],
        &[0, 16, 3, 0xE8, 0, 2, 4, 9, 1, b'x', 0],
        &[0, 16, 3, 0xE8, 0, 1, 2, 0, 0],
        &[0, 6, 1, 0x90, 0, 9],
        &[0, 6, 1, 0x9A, 0, 0],
        &[0, 3, 0, 0, 0, 1],
        &[0, 0x2B, 14, 1, 0],
        &[0, 0x64],
    ];
    for uploads in [false, true] {
        for frame in wrong {
            if uploads && !outcome(&mut uno).0 {
                write(&mut uno, 400, UPLOAD).unwrap();
            }
            let reply = common::modbus::exchange(&mut uno, &with_crc(frame), 60);
            assert_eq!(reply, None, "{frame:02x?}, {uploads}");
            assert_eq!(input(&mut uno, 16), STOP);
        }
    }
}

#[test]
fn stop_ends_an_upload_and_a_new_one_begins_anew() {
    let mut uno = stopped();
    write(&mut uno, 400, UPLOAD).unwrap();
    send(&mut uno, 0, b"0\n8779").unwrap();
    assert_eq!(write(&mut uno, 400, RUN), Err(4));
    assert_eq!(write(&mut uno, 400, 3), Err(4));
    write(&mut uno, 400, STOP).unwrap();
    uno.run_ms(5).unwrap();
    assert_eq!(outcome(&mut uno), (false, 0, 0));
    assert_old(&mut uno, "ended");

    let mut uno = stopped();
    write(&mut uno, 400, UPLOAD).unwrap();
    send(&mut uno, 0, b"0\n8779").unwrap();
    assert_eq!(write(&mut uno, 400, UPLOAD), Err(4));
    write(&mut uno, 400, STOP).unwrap();
    upload(&mut uno, [NEW; 2], 100).unwrap();
    assert_eq!(input(&mut uno, 28), 1);
}

#[test]
fn a_board_without_a_program_takes_one_in_fault() {
    let mut uno = uno(Slot::Empty);
    ms_until(&mut uno, &["D10 to D13\r\n"]);
    uno.run_ms(5).unwrap();
    assert_eq!(upload(&mut uno, ["0\n877917\n"; 2], 100), Err(4));
    assert_eq!(outcome(&mut uno), (false, 26, 2));
    assert_eq!(input(&mut uno, 16), FAULT);
    upload(&mut uno, [NEW; 2], 100).unwrap();
    assert_eq!(outcome(&mut uno), (false, 0, 0));
    assert_eq!(input(&mut uno, 16), FAULT);
    assert_eq!(uno.outputs(), 0);
    write(&mut uno, 400, RESTART).unwrap();
    to_run(&mut uno);
    uno.run_ms(2).unwrap();
    assert_eq!(uno.outputs(), 0b10);
}

/// Wherever the power fails, what runs afterwards is the old program or the new one, or none.
#[test]
fn a_power_cut_leaves_no_half_program() {
    let other = "0\n-827301\n-827302\n877903\n787600\n827303\n827304\n877904\n";
    let (mut old, mut new, mut none) = (0, 0, 0);
    for cut in cases((0..100).step_by(2)) {
        let mut uno = stopped();
        uno.swap_slot(Slot::Empty);
        write(&mut uno, 400, UPLOAD).unwrap();
        send(&mut uno, 0, other.as_bytes()).unwrap();
        send(&mut uno, 1, b"").unwrap();
        send(&mut uno, 2, other.as_bytes()).unwrap();
        uno.send_serial(&with_crc(&block(3, b"")));
        uno.run_ms(1 + cut).unwrap();
        uno.take_serial();
        uno.power_up();
        let said = ms_until(&mut uno, &["RUN\r\n", "\r\nfault "]).1;
        if said.contains("fault") {
            none += 1;
            continue;
        }
        uno.run_ms(2).unwrap();
        match uno.outputs() {
            0 => old += 1,
            0b0100 => new += 1,
            outputs => panic!("{cut}: {outputs:04b}"),
        }
    }
    println!("{old} old, {none} none, {new} new");
    assert!(old > 0 && none > 0 && new > 0, "{old} {none} {new}");
}
