//! Pulse-width modulation of the outputs, from the registers of timers 0 and 1 (ATmega328P datasheet, sections 14 and 15).
//!
//! simavr would write each pulse to the port's register; that is switched off, so that a pin that has its PWM shows the
//! level that the program has set beside it.

use crate::avr::reg;

/// Timers 3, 4 and 5 of the ATmega2560, control A.
const TCCR3A: u16 = 0x90;
const TCCR4A: u16 = 0xA0;
const TCCR5A: u16 = 0x120;

/// The pulses on a pin. A new value that the program has written counts at once, where the chip waits for the next pulse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pwm {
    /// Cycles for which the pin is high, of each period.
    pub high: u64,
    /// Cycles from one pulse to the next.
    pub period: u64,
}

impl Pwm {
    /// The part of the time for which the pin is high, 0 to 1.
    pub fn duty(self) -> f64 {
        self.high as f64 / self.period as f64
    }

    /// That of timer 0 on D6 (OC0A), from data space.
    pub(crate) fn of_timer_0(data: &[u8]) -> Option<Pwm> {
        let control_a = register(data, reg::TCCR0A);
        let control_b = register(data, reg::TCCR0B);
        let compare = register(data, reg::OCR0A).into();
        // WGM0: mode 3.
        let top = (control_a & 3 == 3 && control_b & 8 == 0).then_some(0xFF)?;
        pulses(control_a, control_b, compare, top)
    }

    /// That on an output of a Mega, from 0, by timers 3, 4 and 5, from data space.
    pub(crate) fn of_mega(data: &[u8], output: usize) -> Option<Pwm> {
        let (control, unit) = match output {
            3 => (TCCR3A, 0),
            0 => (TCCR3A, 1),
            1 => (TCCR3A, 2),
            4..=6 => (TCCR4A, output as u16 - 4),
            11..=13 => (TCCR5A, output as u16 - 11),
            _ => return None,
        };
        let (control_a, control_b) = (register(data, control), register(data, control + 1));
        // WGM: mode 5.
        let top = (control_a & 3 == 1 && control_b & 0x18 == 8).then_some(0xFF)?;
        // OCRnA stands 8 bytes after TCCRnA.
        let compare = register_pair(data, control + 8 + 2 * unit);
        pulses(control_a << (2 * unit), control_b, compare, top)
    }

    /// That of timer 1 on D9 (OC1A), from data space.
    pub(crate) fn of_timer_1(data: &[u8]) -> Option<Pwm> {
        let control_a = register(data, reg::TCCR1A);
        let control_b = register(data, reg::TCCR1B);
        let top = match control_a & 3 | control_b >> 1 & 0x0C {
            5 => 0xFF,
            6 => 0x1FF,
            7 => 0x3FF,
            14 => register_pair(data, reg::ICR1),
            _ => return None,
        };
        pulses(control_a, control_b, register_pair(data, reg::OCR1A), top)
    }
}

fn register(data: &[u8], address: u16) -> u8 {
    data.get(usize::from(address)).copied().unwrap_or(0)
}

fn register_pair(data: &[u8], address: u16) -> u16 {
    u16::from_le_bytes([register(data, address), register(data, address + 1)])
}

/// Fast PWM up to `top`, with these bits COMnA and CSn.
fn pulses(control_a: u8, control_b: u8, compare: u16, top: u16) -> Option<Pwm> {
    let clock = match control_b & 7 {
        1 => 1,
        2 => 8,
        3 => 64,
        4 => 256,
        5 => 1024,
        _ => return None,
    };
    let (counts, period) = (u64::from(compare.min(top)) + 1, u64::from(top) + 1);
    let high = match control_a >> 6 {
        // From the start of the period to the count that is the same.
        2 => counts,
        // The other way round.
        3 => period - counts,
        _ => return None,
    };
    Some(Pwm {
        high: high * clock,
        period: period * clock,
    })
}
