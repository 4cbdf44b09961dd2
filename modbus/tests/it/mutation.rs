//! A million requests that nobody would send, held against the oracle.

use crate::common::oracle::oracle;
use crate::common::random::Random;
use crate::common::recorder::Recorder;
use crate::common::{answer_scanning, request, write};

const ADDRESSES: [u16; 12] = [
    0, 3, 8, 0x1000, 0x1001, 0x17D0, 0x2000, 0x3001, 0x7FFF, 0xF8FF, 0xFFFE, 0xFFFF,
];
const FUNCTIONS: [u8; 9] = [1, 2, 3, 4, 5, 6, 15, 16, 43];

/// A reply is at most 253 bytes behind the address, and as long as it says.
fn is_well_formed(request: &[u8], reply: &[u8]) -> bool {
    let [server, function, ref data @ ..] = *reply else {
        return false;
    };
    let body = match (function, data) {
        (0x80.., &[code]) => matches!(code, 1..=4 | 6),
        (1..=4, &[count, ref values @ ..]) => values.len() == count.into(),
        (5 | 6 | 15 | 16, fields) => *fields == request[2..6],
        (43, &[14, _, 0x81, 0, 0, count, ref objects @ ..]) => {
            let mut left = objects;
            for _ in 0..count {
                let [_, length, ref tail @ ..] = *left else {
                    return false;
                };
                left = &tail[length.into()..];
            }
            left.is_empty()
        }
        _ => false,
    };
    body && reply.len() <= 254 && server == request[0] && function & 0x7F == request[1] & 0x7F
}

fn compare(request: &[u8], most: u8) -> bool {
    let mut device = Recorder::default();
    let reply = answer_scanning(&mut device, request, most, |_| ());
    let (expected, writes) = oracle(request);
    assert_eq!(reply, expected, "{request:02x?}");
    assert_eq!(device.writes(), writes, "{request:02x?}");
    match reply {
        None => request.len() < 2 || request[0] == 0,
        Some(reply) => is_well_formed(request, &reply),
    }
}

/// A sound request, as far as its addresses exist.
fn sound(random: &mut Random) -> Vec<u8> {
    let server = random.pick(&[0, 1, 1, 1, 247]);
    let function = random.pick(&FUNCTIONS);
    let first = random.pick(&ADDRESSES);
    let count = match random.below(4) {
        0 => random.below(2001) as u16,
        1 => random.below(124) as u16,
        _ => random.below(9) as u16,
    };
    match function {
        15 | 16 => write(server, function, first, count),
        5 => request(server, function, [first, random.pick(&[0, 0xFF00])]),
        43 => vec![
            server,
            function,
            14,
            random.below(5) as u8,
            random.below(4) as u8,
        ],
        _ => request(server, function, [first, count]),
    }
}

fn mutate(random: &mut Random, request: &mut Vec<u8>) {
    for _ in 0..random.below(4) {
        let at = random.below(request.len().max(1) as u32) as usize;
        match random.below(5) {
            0 if at < request.len() => request[at] ^= 1 << random.below(8),
            1 if at < request.len() => request[at] = random.byte(),
            2 => request.truncate(at),
            3 if request.len() < 254 => request.insert(at, random.byte()),
            4 if at < request.len() => {
                request.remove(at);
            }
            _ => {}
        }
    }
}

#[test]
fn half_a_million_mutated_requests() {
    let mut random = Random::new(0x2545_F491);
    let mut replies = 0;
    for _ in 0..500_000 {
        let mut request = sound(&mut random);
        mutate(&mut random, &mut request);
        let most = random.pick(&[0, 1, 2, 3, 16, 255]);
        assert!(compare(&request, most), "{request:02x?}");
        replies += u32::from(request.first().is_some_and(|server| *server != 0));
    }
    assert!(replies > 300_000, "{replies}");
}

#[test]
fn half_a_million_random_requests() {
    let mut random = Random::new(0x9E37_79B9);
    for _ in 0..500_000 {
        let length = random.pick(&[0, 1, 2, 5, 6, 7, 8, 9, 11, 254]);
        let mut request: Vec<u8> = (0..length).map(|_| random.byte()).collect();
        if let [server, function, ..] = &mut *request {
            *server = random.pick(&[0, 1, *server]);
            *function = random.pick(&[1, 2, 3, 4, 5, 6, 15, 16, 43, *function]);
        }
        let most = random.byte();
        assert!(compare(&request, most), "{request:02x?}");
    }
}
