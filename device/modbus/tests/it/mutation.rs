//! Usually a million requests that nobody would send, held against the oracle.

use crate::common::random::Random;
use crate::common::{compare, request, write};
use unoclp_testing::rounds;

const ADDRESSES: [u16; 12] = [
    0, 3, 8, 0x1000, 0x1001, 0x17D0, 0x2000, 0x3001, 0x7FFF, 0xF8FF, 0xFFFE, 0xFFFF,
];
const FUNCTIONS: [u8; 9] = [1, 2, 3, 4, 5, 6, 15, 16, 43];

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
    let requests = rounds(500_000);
    for _ in 0..requests {
        let mut request = sound(&mut random);
        mutate(&mut random, &mut request);
        let most = random.pick(&[0, 1, 2, 3, 16, 255]);
        assert!(compare(&request, most), "{request:02x?}");
        replies += u32::from(request.first().is_some_and(|server| *server != 0));
    }
    assert!(replies > requests / 5 * 3, "{replies}");
}

#[test]
fn half_a_million_random_requests() {
    let mut random = Random::new(0x9E37_79B9);
    let requests = rounds(500_000);
    for _ in 0..requests {
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
