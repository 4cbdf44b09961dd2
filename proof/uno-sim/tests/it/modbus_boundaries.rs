//! Every function at every boundary of the map, in RUN, STOP and FAULT.

use crate::BOARD;
use crate::common::modbus::{ask, input};
use crate::common::{card, ms_until, uno};
use std::ops::RangeInclusive;
use unoclp_uno_sim::{Slot, Uno};

const RUN: u16 = 1;
const STOP: u16 = 2;
const FAULT: u16 = 3;

/// Two timers and a counter.
const PROGRAM: &str = "0\n827301\n847978\n60000\n7901\n787600\n827302\n847970\n60000\n7702\n\
    787600\n827303\n67848501\n3\n877903\n";

/// First and last address of every range, and their neighbours.
const ADDRESSES: [u16; 39] = [
    0, 3, 4, 7, 8, 15, 16, 23, 24, 32, 33, 63, 64, 79, 80, 127, 128, 131, 132, 301, 302, 319, 320,
    351, 352, 399, 400, 402, 405, 410, 413, 1000, 1449, 1450, 1999, 2000, 2195, 2196, 0xFFFF,
];

/// What a function may be asked for, by `docs/modbus.md`.
fn ranges(function: u8, state: u16) -> Vec<RangeInclusive<u16>> {
    let last = |points: u8| u16::from(points) - 1;
    let settings = [400..=400, 402..=405, 410..=413];
    match function {
        // A request may go on from outputs to markers where they join.
        1 | 5 | 15 if BOARD.outputs == 16 => vec![0..=79],
        1 | 5 | 15 => vec![0..=last(BOARD.outputs), 16..=79],
        2 => vec![0..=last(BOARD.inputs)],
        4 => vec![
            0..=last(BOARD.analogue),
            16..=32,
            128..=301,
            320..=351,
            1000..=999 + BOARD.stored_bytes.div_ceil(2),
        ],
        3 => [&[0..=301, 320..=351, 2000..=2195], &settings[..]].concat(),
        _ if state == FAULT => [&[0..=127, 2000..=2195], &settings[..]].concat(),
        _ => [&[0..=131, 320..=321, 2000..=2195], &settings[..]].concat(),
    }
}

/// Why a holding register is refused this value.
fn refusal(address: u16, value: u16, state: u16) -> Option<u8> {
    let sound = match address {
        0..128 | 2000.. => true,
        128..400 => address % 2 == 1 || value < 0x8000,
        // Commands are not asked for here.
        400 => false,
        402 | 403 => BOARD.inputs >= 16 || value < 1 << BOARD.inputs,
        404 | 405 => BOARD.outputs >= 16 || value < 1 << BOARD.outputs,
        _ if state == RUN => return Some(4),
        410 => (1..=247).contains(&value),
        411 => (24..=1152).contains(&value),
        412 => value <= 2,
        _ => value <= 1,
    };
    (!sound).then_some(3)
}

/// The exception for a request of several; writes are of zeros.
fn several(function: u8, first: u16, count: u16, state: u16) -> Option<u8> {
    let most = match function {
        1 | 2 => 2000,
        3 | 4 => 125,
        15 => 1968,
        _ => 123,
    };
    if !(1..=most).contains(&count) {
        return Some(3);
    }
    if (function, first) == (16, 1000) {
        // No upload is under way.
        return Some(4);
    }
    let last = u32::from(first) + u32::from(count) - 1;
    let within =
        |range: &RangeInclusive<u16>| *range.start() <= first && last <= u32::from(*range.end());
    if !ranges(function, state).iter().any(within) {
        return Some(2);
    }
    match function {
        16 => (first..=last as u16).find_map(|address| refusal(address, 0, state)),
        _ => None,
    }
}

/// Asks, and holds the reply against the exception or against what it must be like.
fn expect(uno: &mut Uno, request: &[u8], exception: Option<u8>) {
    let reply = ask(uno, request).unwrap_or_else(|| panic!("no reply: {request:02x?}"));
    let count = usize::from(u16::from_be_bytes([request[4], request[5]]));
    let function = request[1];
    match (exception, function) {
        (Some(code), _) => assert_eq!(reply, [1, function | 0x80, code], "{request:02x?}"),
        (None, 1..=4) => {
            let bytes = if function < 3 {
                count.div_ceil(8)
            } else {
                2 * count
            };
            assert_eq!(reply[..3], [1, function, bytes as u8], "{request:02x?}");
            assert_eq!(reply.len(), 3 + bytes, "{request:02x?}");
        }
        (None, _) => assert_eq!(reply, request[..6], "{request:02x?}"),
    }
}

fn request(function: u8, words: [u16; 2]) -> Vec<u8> {
    let words = words.into_iter().flat_map(u16::to_be_bytes);
    [1, function].into_iter().chain(words).collect()
}

fn every_function_at_every_pair_of_boundaries(state: u16) {
    let text = if state == FAULT { "1\n" } else { PROGRAM };
    let mut uno = uno(Slot::Card(card(text)));
    uno.set_stop(state == STOP);
    ms_until(&mut uno, &["RUN\r\n", "STOP\r\n", "start\r\n"]);
    uno.run_ms(5).unwrap();
    let mut frames = 0;
    for (n, first) in ADDRESSES.into_iter().enumerate() {
        // From one to each of the others, none, and beyond the number's end.
        let counts = ADDRESSES[n..]
            .iter()
            .map(|last| last - first)
            .map(|more| more.wrapping_add(1));
        for count in counts.chain([0, 0xFFFF]) {
            for function in [1, 2, 3, 4] {
                let exception = several(function, first, count, state);
                expect(&mut uno, &request(function, [first, count]), exception);
                frames += 1;
            }
            for function in [15, 16] {
                let data = match function {
                    15 => usize::from(count).div_ceil(8),
                    _ => 2 * usize::from(count),
                };
                let mut request = request(function, [first, count]);
                request.push(data as u8);
                request.resize(7 + data.min(246), 0);
                expect(&mut uno, &request, several(function, first, count, state));
                frames += 1;
            }
        }
        for on in [0, 0xFF00] {
            let there = ranges(5, state).iter().any(|range| range.contains(&first));
            let exception = (!there).then_some(2);
            expect(&mut uno, &request(5, [first, on]), exception);
            frames += 1;
        }
        for value in [0, 0x0F, 0x10, 0x100, 0x7FFF, 0x8000, 0xFFFF] {
            let there = ranges(6, state).iter().any(|range| range.contains(&first));
            let exception = if there {
                refusal(first, value, state)
            } else {
                Some(2)
            };
            expect(&mut uno, &request(6, [first, value]), exception);
            frames += 1;
        }
    }
    println!("{frames} frames");
    assert_eq!(input(&mut uno, 16), state);
    assert_eq!(uno.resets(), 0);
}

#[test]
fn in_run() {
    every_function_at_every_pair_of_boundaries(RUN);
}

#[test]
fn in_stop() {
    every_function_at_every_pair_of_boundaries(STOP);
}

#[test]
fn in_fault() {
    every_function_at_every_pair_of_boundaries(FAULT);
}
