//! PWM on D6 from timer 0 and on D9 from timer 1, beside the clock (ATmega328P datasheet, sections 15
//! and 16): about 1 kHz both.

use super::chip::{TC0, TC1};

/// D6 is high for so many 255ths of the time. At 0 the pin is given back, and low as its port has it:
/// the timer itself would leave one count of 256.
pub fn set_d6(timer: &TC0, duty: u8) {
    timer.ocr0a().write(|w| w.set(duty));
    timer.tccr0b().write(|w| w.cs0().prescale_64());
    timer.tccr0a().write(|w| {
        if duty == 0 {
            w
        } else {
            w.com0a().match_clear().wgm0().pwm_fast()
        }
    });
}

/// Likewise D9, by the timer of the clock, which counts 2000 for each millisecond.
pub fn set_d9(timer: &TC1, duty: u8) {
    // 255 gives 1999, which is always high; for the rest 2000 / 256 is near enough.
    let count = if duty == u8::MAX {
        1999
    } else {
        (u16::from(duty) * 125) >> 4
    };
    timer.ocr1a().write(|w| w.set(count));
    timer.tccr1a().modify(|_, w| {
        if duty == 0 {
            w.com1a().disconnected()
        } else {
            w.com1a().match_clear()
        }
    });
}
