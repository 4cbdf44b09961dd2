//! What the tests share: a device that writes down what is asked of it, and an oracle.

pub mod oracle;
pub mod random;
pub mod recorder;
pub mod uno;

use oracle::oracle;
use recorder::Recorder;
use unoclp_modbus::{Device, Exchange, FRAME_BYTES, Frame};

/// What stands in the frame after the request: nothing may depend on it.
pub const LEFTOVER: u8 = 0xA5;

/// A request as it stands in the frame.
pub fn frame(request: &[u8]) -> Frame {
    let mut frame = [LEFTOVER; FRAME_BYTES];
    frame[..request.len()].copy_from_slice(request);
    frame
}

/// Answers a request. `scan` stands before each slice.
pub fn answer_scanning<D: Device>(
    device: &mut D,
    request: &[u8],
    mut scan: impl FnMut(&mut D),
) -> Option<Vec<u8>> {
    let mut frame = frame(request);
    let mut exchange = Exchange::default();
    let mut length = exchange.begin(&mut frame, request.len() as u8, device);
    let mut slices = 0;
    while length.is_none() {
        scan(device);
        length = exchange.fill(&mut frame, device);
        slices += 1;
        assert!(slices <= 300, "no end: {request:02x?}");
    }
    let length = length.unwrap_or_default();
    (length > 0).then(|| frame[..length.into()].to_vec())
}

/// Answers a request in one go.
pub fn answer(device: &mut impl Device, request: &[u8]) -> Option<Vec<u8>> {
    answer_scanning(device, request, |_| ())
}

/// The bytes of `01 03 00*2`, which are 1, 3, 0, 0.
pub fn bytes(hex: &str) -> Vec<u8> {
    let some = |text: &str| {
        let (byte, times) = text.split_once('*').unwrap_or((text, "1"));
        vec![u8::from_str_radix(byte, 16).expect(text); times.parse().expect(text)]
    };
    hex.split_whitespace().flat_map(some).collect()
}

/// Address, function and words of a request.
pub fn request(server: u8, function: u8, words: [u16; 2]) -> Vec<u8> {
    let mut request = vec![server, function];
    request.extend(words.into_iter().flat_map(u16::to_be_bytes));
    request
}

/// A write of several, sound as far as its quantity lets it be: of so many words or bits, as many data as
/// fit one frame.
pub fn write(server: u8, function: u8, first: u16, count: u16) -> Vec<u8> {
    let needed = match function {
        15 => usize::from(count).div_ceil(8),
        _ => usize::from(count) * 2,
    };
    let present = needed.min(246);
    let mut request = request(server, function, [first, count]);
    request.push(needed as u8);
    request.extend((0..present).map(|n| (n as u8).wrapping_mul(37) ^ first as u8));
    request
}

/// A reply is at most 253 bytes after the address, and as long as it says.
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

/// Holds the answer to a request against the oracle, where so many words are done at once; says whether it is well-formed.
pub fn compare(request: &[u8], most: u8) -> bool {
    let mut device = Recorder::of(most);
    let reply = answer_scanning(&mut device, request, |_| ());
    let (expected, writes) = oracle(request);
    assert_eq!(reply, expected, "{request:02x?}");
    assert_eq!(device.writes(), writes, "{request:02x?}");
    match reply {
        None => request.len() < 2 || request[0] == 0,
        Some(reply) => is_well_formed(request, &reply),
    }
}
