//! PWM from timers 3, 4 and 5: 8 bits, fast, about 1 kHz (ATmega2560 datasheet, section 17).

use super::chip::{TC3, TC4, TC5};
use crate::engine::data::PWM;

/// Fast PWM of 8 bits: WGM0 in control A, WGM2 in control B; a 64th of the clock.
const FAST_A: u8 = 0b01;
const FAST_B: u8 = 0b01 << 3 | 0b011;
/// Units A, B and C in control A: clear on match, set at the bottom.
const UNIT_A: u8 = 0b10 << 6;
const UNIT_B: u8 = 0b10 << 4;
const UNIT_C: u8 = 0b10 << 2;

/// One timer: its units, each with the index of its output.
macro_rules! timer {
    ($timer:ident $among:ident $duty:ident, $a:ident $b:ident $oca:ident $oa:literal $ocb:ident $ob:literal $occ:ident $oc:literal) => {
        let mut units = $timer.$a().read().bits();
        for (unit, output) in [(UNIT_A, $oa), (UNIT_B, $ob), (UNIT_C, $oc)] {
            if $among >> output & 1 == 0 {
                continue;
            }
            let duty = $duty.and_then(|duty| duty.get(output)).copied().unwrap_or_default();
            match unit {
                UNIT_A => $timer.$oca().write(|w| w.set(duty.into())),
                UNIT_B => $timer.$ocb().write(|w| w.set(duty.into())),
                _ => $timer.$occ().write(|w| w.set(duty.into())),
            };
            // At 0 the pin is given back, and low as its port has it: the timer itself would leave one count of 256.
            units = if duty == 0 { units & !unit } else { units | unit };
        }
        // SAFETY: any value may be written; the reserved bits are 0.
        unsafe {
            $timer.$b().write(|w| w.bits(FAST_B));
            $timer.$a().write(|w| w.bits(units | FAST_A));
        }
    };
}

/// Each output of these, bit 0 output 01, that a timer can make pulses on is high for so many 255ths of the time; without
/// a duty for none of it. A duty of zeros would be a constant in RAM, where the page has to begin.
pub fn write(third: &TC3, fourth: &TC4, fifth: &TC5, among: u32, duty: Option<&[u8; PWM]>) {
    timer!(third among duty, tccr3a tccr3b ocr3a 3 ocr3b 0 ocr3c 1);
    timer!(fourth among duty, tccr4a tccr4b ocr4a 4 ocr4b 5 ocr4c 6);
    timer!(fifth among duty, tccr5a tccr5b ocr5a 11 ocr5b 12 ocr5c 13);
}
