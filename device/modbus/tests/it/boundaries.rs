//! Every function at every edge of addresses and quantities, held against the oracle.

use crate::common::oracle::oracle;
use crate::common::recorder::Recorder;
use crate::common::{answer, request, write};

/// Edges of the number, of the recorder's addresses, and of its window.
const ADDRESSES: [u16; 50] = [
    0, 1, 3, 4, 7, 8, 9, 10, 99, 100, 101, 200, 300, 400, 0x0FFF, 0x1000, 0x1001, 0x1020, 0x17CF,
    0x17D0, 0x17D1, 0x1FFF, 0x2000, 0x2001, 0x3000, 0x3001, 0x3002, 0x3083, 0x3084, 0x7FFD, 0x7FFE,
    0x7FFF, 0x8000, 0x8001, 0x8002, 0xF7FF, 0xF800, 0xF82F, 0xF830, 0xF831, 0xF8FF, 0xF900, 0xF90F,
    0xF910, 0xFF83, 0xFF84, 0xFF85, 0xFFFD, 0xFFFE, 0xFFFF,
];

/// Edges of each function's quantity, and of the byte count.
const QUANTITIES: [u16; 30] = [
    0, 1, 2, 3, 7, 8, 9, 15, 16, 17, 121, 122, 123, 124, 125, 126, 127, 128, 129, 255, 256, 257,
    1967, 1968, 1969, 1999, 2000, 2001, 0x8000, 0xFFFF,
];

fn compare(request: &[u8]) {
    let mut device = Recorder::default();
    let reply = answer(&mut device, request);
    let (expected, writes) = oracle(request);
    assert_eq!(reply, expected, "{request:02x?}");
    assert_eq!(device.writes(), writes, "{request:02x?}");
}

#[test]
fn every_function_at_every_edge() {
    for server in [0, 1, 247] {
        for function in 0..=255 {
            for first in ADDRESSES {
                for count in QUANTITIES {
                    compare(&request(server, function, [first, count]));
                }
            }
        }
    }
}

#[test]
fn a_broadcast_that_reads_asks_nothing_of_the_device() {
    for function in 1..=4 {
        let mut device = Recorder::default();
        assert_eq!(answer(&mut device, &request(0, function, [0, 9])), None);
        assert_eq!(device.calls(), []);
    }
}

#[test]
fn writes_of_several_at_every_edge() {
    for server in [0, 17] {
        for function in [15, 16] {
            for first in ADDRESSES {
                for count in QUANTITIES {
                    compare(&write(server, function, first, count));
                }
            }
        }
    }
}

#[test]
fn every_value_of_a_coil() {
    for value in 0..=0xFFFF {
        for address in [0, 4, 0x8001, 0x8002] {
            compare(&request(1, 5, [address, value]));
        }
    }
}

#[test]
fn every_byte_count() {
    for function in [15, 16] {
        for count in QUANTITIES {
            let sound = write(1, function, 0x1000, count);
            for byte_count in 0..=255 {
                let mut request = sound.clone();
                request[6] = byte_count;
                compare(&request);
                // As many data as it says, whatever the quantity.
                request.resize(7 + usize::from(byte_count).min(248), 0x11);
                compare(&request);
            }
        }
    }
}

#[test]
fn every_length() {
    for server in [0, 1] {
        for function in 0..=255 {
            for longest in [
                write(server, function, 0x1000, 123),
                write(server, 15, 0, 8),
            ] {
                for length in 0..=254 {
                    let mut request = longest.clone();
                    request.resize(length, 0);
                    compare(&request);
                }
            }
        }
    }
}

/// One bad value spoils all of them, wherever it stands.
#[test]
fn a_value_that_is_refused_leaves_everything_as_it_was() {
    for count in [1, 2, 3, 16, 17, 122, 123] {
        for bad in 0..count {
            for value in [0xBAD1_u16, 0xDEAD] {
                let mut request = write(1, 16, 0x1000, count);
                request[7..].fill(0);
                let at = 7 + 2 * usize::from(bad);
                request[at..at + 2].copy_from_slice(&value.to_be_bytes());
                compare(&request);
                let mut device = Recorder::default();
                let code = answer(&mut device, &request).unwrap()[2];
                assert_eq!(code, if value == 0xDEAD { 4 } else { 3 });
                assert_eq!(device.writes(), []);
            }
        }
    }
}

#[test]
fn a_window_takes_blocks_of_every_length() {
    for first_byte in [0x00, 0xEE, 0xEF] {
        for count in 1..=123 {
            for server in [0, 1] {
                let mut request = write(server, 16, 0x2000, count);
                request[7] = first_byte;
                compare(&request);
            }
        }
    }
}
