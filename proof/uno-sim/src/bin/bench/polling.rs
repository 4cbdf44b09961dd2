//! What a Modbus client costs that asks as often as it may.

use crate::meter::Meter;
use crate::programs;
use anyhow::{Result, ensure};
use unoclp_modbus::Crc;
use unoclp_uno_sim::{CYCLES_PER_MS, Program};

/// How long it asks, ms.
const ASKED: u64 = 2_000;
/// Silence after an answer, cycles: 1.75 ms, as above 19200 baud.
const SILENCE: u64 = CYCLES_PER_MS * 7 / 4;

/// What a client asks for, and what comes of it.
#[derive(Clone, Debug)]
pub struct Polled {
    /// What it asks for.
    pub what: &'static str,
    /// Answers a second.
    pub answers: f64,
    /// Scans a second.
    pub scans: f64,
    /// The longest scan, cycles.
    pub most: u64,
}

/// A request without its checksum, and its name.
const REQUESTS: [(&str, Option<[u8; 6]>); 4] = [
    ("nothing", None),
    ("1 word: the state", Some([1, 4, 0, 16, 0, 1])),
    ("17 words: all diagnostics", Some([1, 4, 0, 16, 0, 17])),
    ("125 words: presets of timers", Some([1, 3, 0, 128, 0, 125])),
];

/// Measures it with two contacts and a coil, at 115200 baud.
pub fn measure(firmware: &Program) -> Result<Vec<Polled>> {
    let all = REQUESTS
        .iter()
        .map(|&(what, request)| polled(firmware, what, request));
    all.collect()
}

fn polled(firmware: &Program, what: &'static str, request: Option<[u8; 6]>) -> Result<Polled> {
    let mut meter = Meter::firmware(firmware, &programs::program(&programs::small()))?;
    // Until its own text has been sent.
    meter.run_ms(50)?;
    meter.uno().take_serial_log();
    let begun = meter.uno().cycles();
    let frame = request.map(|body| [&body[..], &Crc::of(&body).to_bytes()].concat());
    let (mut scans, mut most, mut answers) = (0_u64, 0, 0_u64);
    // When the next request may follow; none while one is being answered.
    let mut next = Some(begun);
    let mut heard = 0;
    while meter.uno().cycles() - begun < ASKED * CYCLES_PER_MS {
        if let (Some(frame), Some(at)) = (&frame, next)
            && meter.uno().cycles() >= at
        {
            meter.uno().send_serial(frame);
            next = None;
            heard = 0;
        }
        let scan = meter.scan()?;
        scans += 1;
        most = most.max(scan.cycles);
        let words = frame.as_ref().map_or(0, |frame| usize::from(frame[5]));
        for sent in meter.uno().take_serial_log() {
            heard += 1;
            if heard == 2 * words + 5 {
                answers += 1;
                next = Some(sent.end + SILENCE);
            }
        }
    }
    ensure!(request.is_none() || answers > 0, "{what}: no answer");
    let seconds = (meter.uno().cycles() - begun) as f64 / (1_000 * CYCLES_PER_MS) as f64;
    Ok(Polled {
        what,
        answers: answers as f64 / seconds,
        scans: scans as f64 / seconds,
        most,
    })
}
