//! What a board tells of a fault: over Modbus, and as a text at its start.

use super::error::EngineError;
use super::simulated::Simulated;
use crate::{CYCLES_PER_MS, Halt};
use unoclp_host_sim::engine::Refusal;
use unoclp_modbus::Crc;

/// Cycles in which a board answers a short request at 115200 baud.
const ANSWER: u64 = 10 * CYCLES_PER_MS;

/// The fault that a board in FAULT tells over Modbus (`docs/modbus.md`); none where it does not answer, or
/// is in another state.
pub(super) fn served_fault(uno: &mut impl Simulated) -> Result<Option<Refusal>, Halt> {
    // Of server 1: input registers 16 to 21.
    let request = [1, 4, 0, 16, 0, 6];
    uno.take_serial();
    uno.send_serial(&[&request[..], &Crc::of(&request).to_bytes()].concat());
    uno.run_cycles(ANSWER)?;
    let reply = uno.take_serial();
    let [1, 4, 12, words @ .., _, _] = &reply[..] else {
        return Ok(None);
    };
    let word = |index: usize| u16::from_be_bytes([words[2 * index], words[2 * index + 1]]);
    let in_fault = words.len() == 12 && word(0) == 3;
    let line = || u32::from(word(4)) << 16 | u32::from(word(5));
    Ok(in_fault.then(|| Refusal {
        number: word(2) as u8,
        line: Some(line()).filter(|&line| line != 0),
    }))
}

/// The fault that the serial port tells, once its line is complete.
pub(super) fn fault(serial: &str) -> Result<Option<Refusal>, EngineError> {
    let Some((_, line)) = serial.split_once("\r\nfault ") else {
        return Ok(None);
    };
    let Some((line, _)) = line.split_once("\r\n") else {
        return Ok(None);
    };
    parse_fault(line)
        .map(Some)
        .ok_or_else(|| EngineError::Serial(serial.to_owned()))
}

/// `24, line 7: no such code`, or `51: no card answers …`
fn parse_fault(line: &str) -> Option<Refusal> {
    let (place, text) = line.split_once(": ")?;
    let (number, line) = match place.split_once(", line ") {
        Some((number, line)) => (number, Some(line.parse().ok()?)),
        None => (place, None),
    };
    let refusal = Refusal {
        number: number.parse().ok()?,
        line,
    };
    let cause = unoclp_core::Cause::ALL
        .iter()
        .find(|cause| cause.number() == refusal.number)?;
    (cause.text() == text).then_some(refusal)
}
