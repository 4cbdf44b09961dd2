//! A Modbus client on the simulated serial port.

use super::{card, to_run, uno};
use unoclp_modbus::Crc;
use unoclp_uno_sim::{CYCLES_PER_MS, Slot, Uno};

/// How long a reply may take from the end of the request on, ms.
const PATIENCE: u64 = 40;

/// What input register 17 tells beside its bits: the form in which a program is stored.
pub const FORM: u16 = 0x100;

/// To RUN, and on until the port listens: the text is told as it is written, not as it is sent.
pub fn to_serving(uno: &mut Uno) {
    to_run(uno);
    uno.run_ms(5).unwrap();
}

/// A board that runs this program and serves.
pub fn serving(text: &str) -> Uno {
    let mut uno = uno(Slot::Card(card(text)));
    to_serving(&mut uno);
    uno
}

/// Puts the checksum after a frame.
pub fn with_crc(frame: &[u8]) -> Vec<u8> {
    [frame, &Crc::of(frame).to_bytes()].concat()
}

/// Cycles of 3.5 characters on the line, at least 1.75 ms, and a little more.
fn silence(uno: &Uno) -> u64 {
    let characters = CYCLES_PER_MS * 1000 * 39 / u64::from(uno.serial_line().baud);
    characters.max(CYCLES_PER_MS * 7 / 4) + CYCLES_PER_MS / 5
}

/// Sends bytes as they are and gives what comes back: a frame with a checksum that is right, which is left out.
/// None where nothing comes. All of it is followed by silence.
pub fn exchange(uno: &mut Uno, bytes: &[u8], patience_ms: u64) -> Option<Vec<u8>> {
    uno.take_serial_log();
    let mut last = uno.send_serial(bytes);
    let silence = silence(uno);
    let mut limit = last + silence + patience_ms * CYCLES_PER_MS;
    let mut reply = Vec::new();
    loop {
        uno.run_cycles(CYCLES_PER_MS / 10).unwrap();
        for sent in uno.take_serial_log() {
            assert!(
                sent.start >= last || !reply.is_empty(),
                "a reply without silence"
            );
            reply.push(sent.byte);
            last = sent.end;
        }
        let now = uno.cycles();
        if uno.eeprom_is_busy() {
            // Answers wait until it has been written.
            limit = limit.max(now + CYCLES_PER_MS);
        }
        if reply.is_empty() && now > limit {
            return None;
        }
        if !reply.is_empty() && now > last + silence {
            break;
        }
    }
    assert_eq!(Crc::of(&reply).value(), 0, "{reply:02x?}");
    reply.truncate(reply.len() - 2);
    Some(reply)
}

/// Asks, without the checksum on both sides.
pub fn ask(uno: &mut Uno, request: &[u8]) -> Option<Vec<u8>> {
    exchange(uno, &with_crc(request), PATIENCE)
}

/// Function, first address, one more word.
fn request(function: u8, first: u16, word: u16) -> Vec<u8> {
    let [a, b] = first.to_be_bytes();
    let [c, d] = word.to_be_bytes();
    vec![1, function, a, b, c, d]
}

/// Reads words: of holding registers by function 3, of input registers by 4.
pub fn words(uno: &mut Uno, function: u8, first: u16, count: u16) -> Vec<u16> {
    let request = request(function, first, count);
    let reply = ask(uno, &request).expect("a reply");
    assert_eq!(
        reply[..3],
        [1, function, count as u8 * 2],
        "{request:02x?}: {reply:02x?}"
    );
    let words = reply[3..].chunks(2);
    words
        .map(|pair| u16::from_be_bytes([pair[0], pair[1]]))
        .collect()
}

/// An input register.
pub fn input(uno: &mut Uno, address: u16) -> u16 {
    words(uno, 4, address, 1)[0]
}

/// Reads up to 8 bits: coils by function 1, discrete inputs by 2.
pub fn bits(uno: &mut Uno, function: u8, first: u16, count: u16) -> u8 {
    let reply = ask(uno, &request(function, first, count)).expect("a reply");
    assert_eq!(reply[..3], [1, function, 1], "{reply:02x?}");
    reply[3]
}

/// 32 bits of two words, the high one first.
pub fn long(words: &[u16]) -> u32 {
    assert_eq!(words.len(), 2, "{words:?}");
    u32::from(words[0]) << 16 | u32::from(words[1])
}

/// Writes a holding register.
///
/// # Errors
/// The exception.
pub fn write(uno: &mut Uno, address: u16, value: u16) -> Result<(), u8> {
    outcome(uno, &request(6, address, value))
}

/// Writes a coil.
///
/// # Errors
/// The exception.
pub fn write_coil(uno: &mut Uno, address: u16, on: bool) -> Result<(), u8> {
    outcome(uno, &request(5, address, if on { 0xFF00 } else { 0 }))
}

/// Writes several holding registers.
///
/// # Errors
/// The exception.
pub fn write_words(uno: &mut Uno, first: u16, words: &[u16]) -> Result<(), u8> {
    let mut frame = request(16, first, words.len() as u16);
    frame.push(words.len() as u8 * 2);
    frame.extend(words.iter().flat_map(|word| word.to_be_bytes()));
    outcome(uno, &frame)
}

/// Whether a write was done: then its reply is how it began.
fn outcome(uno: &mut Uno, request: &[u8]) -> Result<(), u8> {
    let reply = exchange(uno, &with_crc(request), 5000).expect("a reply");
    if reply == [1, request[1] | 0x80, reply[2]] {
        return Err(reply[2]);
    }
    assert_eq!(reply, request[..6]);
    Ok(())
}
