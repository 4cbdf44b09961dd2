//! Frames by the table of the protocol's own tests, and frames that nobody would send.

#[path = "../../../../device/modbus/tests/it/common/random.rs"]
mod random;

use crate::BOARD;
use crate::common::modbus::{ask, bits, exchange, serving, with_crc};
use crate::common::{card, ms_until, uno};
use random::Random;
use unoclp_testing::rounds;
use unoclp_uno_sim::{Slot, Uno};

/// Each output follows its input.
const FOLLOW: &str =
    "0\n827301\n877901\n787600\n827302\n877902\n787600\n827303\n877903\n787600\n827304\n877904\n";

/// What the table says of its program: two timers and two counters.
const OF_THE_TABLE: &str = "0\n827301\n877901\n\
    787600\n827302\n847978\n1000\n7701\n787600\n827302\n847970\n100000\n7702\n\
    787600\n827302\n67848501\n5\n877703\n787600\n827302\n67848502\n70000\n877703\n";

#[derive(serde::Deserialize)]
struct Table {
    case: Vec<Case>,
}

#[derive(serde::Deserialize)]
struct Case {
    name: String,
    /// Where only this board answers so.
    board: Option<String>,
    frames: Vec<[String; 2]>,
}

/// The bytes of `01 03 00*2`, which are 1, 3, 0, 0.
fn bytes(hex: &str) -> Vec<u8> {
    let some = |text: &str| {
        let (byte, times) = text.split_once('*').unwrap_or((text, "1"));
        vec![u8::from_str_radix(byte, 16).expect(text); times.parse().expect(text)]
    };
    hex.split_whitespace().flat_map(some).collect()
}

#[test]
fn each_request_of_the_table_gets_its_reply() {
    let table: Table =
        toml::from_str(include_str!("../../../../device/modbus/tests/frames.toml")).unwrap();
    let mut uno = uno(Slot::Card(card(OF_THE_TABLE)));
    uno.set_stop(true);
    ms_until(&mut uno, &["STOP\r\n"]);
    uno.run_ms(5).unwrap();
    let (mut frames, mut wrong) = (0, Vec::new());
    for case in table.case {
        if case.board.is_some_and(|board| board != BOARD.id()) {
            continue;
        }
        for [request, reply] in &case.frames {
            let expected = Some(bytes(reply)).filter(|reply| !reply.is_empty());
            let came = ask(&mut uno, &bytes(request));
            if came != expected {
                wrong.push(format!("{}: {request} {came:02x?}", case.name));
            }
            frames += 1;
        }
    }
    assert_eq!(wrong, [""; 0]);
    println!("{frames} requests of the table");
}

/// Whether a frame might force something, or command something. Markers, registers and presets are nothing to
/// the program, so they may be written.
fn is_serious(frame: &[u8]) -> bool {
    let [_, function @ (6 | 16), a, b, c, d, ..] = *frame else {
        return false;
    };
    let first = u32::from(a) << 8 | u32::from(b);
    let count = if function == 6 {
        1
    } else {
        u32::from(c) << 8 | u32::from(d)
    };
    first <= 405 && first + count > 400
}

fn running() -> Uno {
    serving(FOLLOW)
}

/// The board scans on, its outputs are what the program says, and it answers.
fn assert_well(uno: &mut Uno, inputs: u8) {
    uno.set_inputs(inputs);
    uno.run_ms(1).unwrap();
    // Others may have been written by a frame.
    assert_eq!(uno.outputs() & 0x0F, inputs);
    assert_eq!(bits(uno, 2, 0, 4), inputs);
    assert_eq!(uno.resets(), 0);
}

/// Of each kind. Most of what frames can do is tried without the chip, by the tests of the server itself.
const FRAMES: u32 = 12_500;

/// How long a reply may take, ms: a scan does four words, and those of a write are checked and then written.
fn patience(frame: &[u8]) -> u64 {
    match *frame {
        [_, _, _, _, a, b, ..] => match u16::from_be_bytes([a, b]) {
            quantity @ ..126 => 1 + u64::from(quantity) / 4,
            _ => 1,
        },
        _ => 1,
    }
}

/// Ends of the map's ranges, and of their quantities.
const ADDRESSES: [u16; 28] = [
    0, 1, 3, 4, 7, 8, 15, 16, 17, 20, 31, 32, 62, 63, 64, 79, 80, 127, 128, 300, 301, 320, 351,
    352, 402, 410, 412, 1000,
];
const COUNTS: [u16; 12] = [0, 1, 2, 3, 4, 5, 8, 16, 32, 64, 0xFF00, 0xFFFF];

#[test]
fn mutated_frames() {
    let mut uno = running();
    let mut random = Random::new(0x2545_F491);
    let (mut n, mut replies) = (0, 0);
    let frames = rounds(FRAMES);
    while n < frames {
        let function = random.pick(&[1, 2, 3, 4, 5, 6, 15, 16, 43]);
        let first: u16 = random.pick(&ADDRESSES);
        let count: u16 = random.pick(&COUNTS);
        let mut frame = vec![random.pick(&[0, 1, 1, 1, 1, 2]), function];
        frame.extend(first.to_be_bytes());
        frame.extend(count.to_be_bytes());
        match function {
            15 => frame.extend([1, random.byte()]),
            16 => {
                frame.push((count as u8).wrapping_mul(2));
                frame.extend((0..count.min(16) * 2).map(|_| random.byte() & 1));
            }
            43 => frame
                .splice(2.., [14, random.byte() % 6, random.byte() % 5])
                .for_each(drop),
            _ => {}
        }
        for _ in 0..random.below(3) {
            let at = random.below(frame.len() as u32) as usize;
            match random.below(4) {
                0 => frame[at] ^= 1 << random.below(8),
                1 => frame[at] = random.byte(),
                2 if at > 1 => frame.truncate(at),
                _ => frame.insert(at, random.byte()),
            }
        }
        if is_serious(&frame) {
            continue;
        }
        let mut sent = with_crc(&frame);
        if random.below(8) == 0 {
            let at = random.below(sent.len() as u32) as usize;
            sent[at] ^= 1 << random.below(8);
            if is_serious(&sent) {
                continue;
            }
        }
        n += 1;
        if let Some(reply) = exchange(&mut uno, &sent, patience(&sent)) {
            replies += 1;
            assert_eq!(reply[0], 1, "{sent:02x?}");
            assert_eq!(reply[1] & 0x7F, sent[1] & 0x7F, "{sent:02x?}");
        }
        if n % 64 == 0 {
            assert_well(&mut uno, random.byte() & 0x0F);
        }
    }
    println!("{replies} of {frames} mutated frames were answered");
    assert!(replies > frames / 3);
    assert_well(&mut uno, 0b1010);
}

#[test]
fn random_frames() {
    let mut uno = running();
    let mut random = Random::new(0x9E37_79B9);
    let (mut n, mut replies) = (0, 0);
    let frames = rounds(FRAMES);
    while n < frames {
        let length = random.pick(&[1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 20]);
        let mut frame: Vec<u8> = (0..length).map(|_| random.byte()).collect();
        if random.below(4) > 0 {
            frame[0] = 1;
            if random.below(2) == 0 {
                frame = with_crc(&frame);
            }
        }
        if is_serious(&frame) {
            continue;
        }
        n += 1;
        replies += u32::from(exchange(&mut uno, &frame, patience(&frame)).is_some());
        if n % 64 == 0 {
            assert_well(&mut uno, random.byte() & 0x0F);
        }
    }
    println!("{replies} of {frames} random frames were answered");
    assert_well(&mut uno, 0b0101);
}
