//! The converter, with the times of the chip (ATmega328P datasheet, section 23).
//!
//! simavr's own takes 24 of its clocks for a conversion where the chip takes 13, scales to 1023, and takes the channel
//! once and for all in free running. So it is not used. This model knows nothing of simavr: the callbacks of `wiring`
//! tell it what the program does, and the time.
//!
//! The chip's own reference of 1.1 V is weak: where the channel has just been switched to it, "the first value read may
//! be wrong" (section 23.5.2). Here it is: in the middle between the voltage before and the reference.
//!
//! Not modelled: triggers by other peripherals, the comparator's use of the multiplexer, noise, and the time that the
//! chip's own reference takes where it is what is measured against.

use crate::inputs::Inputs;

/// Bits of ADCSRA.
const ADEN: u8 = 1 << 7;
const ADSC: u8 = 1 << 6;
const ADATE: u8 = 1 << 5;
const ADIF: u8 = 1 << 4;
const ADIE: u8 = 1 << 3;
const ADPS: u8 = 7;
/// Bit of ADMUX: the result stands to the left.
const ADLAR: u8 = 1 << 5;

/// Half clocks of the converter from the start of a conversion to the sample and to the end (table 23-1), and of the
/// first after it was switched on.
const CONVERSION: (u64, u64) = (3, 26);
const FIRST_CONVERSION: (u64, u64) = (27, 50);

/// The chip's own reference, µV.
const REFERENCE: u32 = 1_100_000;
/// The thermometer at 25 °C, µV.
const THERMOMETER: u32 = 314_000;
/// Channels of the multiplexer beyond the pins.
const CHANNEL_THERMOMETER: u8 = 8;
const CHANNEL_REFERENCE: u8 = 14;
const LARGE_CHIPS_REFERENCE: u8 = 0x1E;
const HIGHEST: u64 = 1023;

#[derive(Clone, Copy, Debug)]
struct Conversion {
    start: u64,
    sample: u64,
    end: u64,
    /// ADMUX as it was at the start.
    mux: u8,
    result: Option<u16>,
}

/// The converter. All times are cycles since the board was made.
pub(crate) struct Adc {
    mux: u8,
    /// ADCSRA without ADSC.
    control: u8,
    /// When it was switched on: its clock counts from there.
    on_since: u64,
    /// No conversion has been made since.
    is_first: bool,
    conversion: Option<Conversion>,
    /// Channel and voltage of the last sample.
    sampled: (u8, u32),
    result: u16,
    /// ADCL has been read, ADCH not yet.
    locked: bool,
}

impl Adc {
    /// As after a reset.
    pub fn new() -> Adc {
        Adc {
            mux: 0,
            control: 0,
            on_since: 0,
            is_first: true,
            conversion: None,
            sampled: (0, 0),
            result: 0,
            locked: false,
        }
    }

    /// ADMUX.
    pub fn mux(&self) -> u8 {
        self.mux
    }

    /// The program writes to ADMUX. A conversion that has begun goes on as it was.
    pub fn set_mux(&mut self, value: u8, now: u64) {
        self.mux = value;
        if let Some(conversion) = &mut self.conversion
            && now < conversion.start
        {
            conversion.mux = value;
        }
    }

    /// ADCSRA, as the program reads it.
    pub fn control(&self) -> u8 {
        let busy = self.conversion.is_some();
        self.control | if busy { ADSC } else { 0 }
    }

    /// The program writes to ADCSRA.
    pub fn set_control(&mut self, value: u8, now: u64) {
        let flag = self.control & ADIF & !value;
        let was_on = self.control & ADEN != 0;
        self.control = value & !(ADSC | ADIF) | flag;
        if value & ADEN == 0 {
            self.conversion = None;
            return;
        }
        if !was_on {
            self.on_since = now;
            self.is_first = true;
        }
        if value & ADSC != 0 && self.conversion.is_none() {
            self.begin(now);
        }
    }

    /// The program reads ADCL, which holds the result until ADCH is read.
    pub fn take_low(&mut self) -> u8 {
        self.locked = true;
        self.aligned().to_le_bytes()[0]
    }

    /// The program reads ADCH.
    pub fn take_high(&mut self) -> u8 {
        self.locked = false;
        self.aligned().to_le_bytes()[1]
    }

    /// Whether the interrupt is asked for.
    pub fn request(&self) -> bool {
        self.control & (ADIF | ADIE) == ADIF | ADIE
    }

    /// The CPU has taken the interrupt, which clears its flag.
    pub fn is_served(&mut self) {
        self.control &= !ADIF;
    }

    /// The cycle at which [`Adc::pass`] is to be called next.
    pub fn due(&self) -> Option<u64> {
        let conversion = self.conversion?;
        Some(match conversion.result {
            None => conversion.sample,
            Some(_) => conversion.end,
        })
    }

    /// Time has come to `now`. `pull_ups` are those of the pins A0 to A5, `free_running` what ADCSRB says.
    pub fn pass(&mut self, now: u64, inputs: &Inputs, pull_ups: u8, free_running: bool) {
        while self.due().is_some_and(|due| due <= now) {
            let Some(mut conversion) = self.conversion else {
                return;
            };
            let Some(result) = conversion.result else {
                conversion.result = Some(self.sample(conversion.mux, inputs, pull_ups));
                self.conversion = Some(conversion);
                continue;
            };
            self.conversion = None;
            self.is_first = false;
            self.control |= ADIF;
            if !self.locked {
                self.result = result;
            }
            if free_running && self.control & ADATE != 0 {
                self.begin(conversion.end);
            }
        }
    }

    /// A conversion begins with the next clock of the converter.
    fn begin(&mut self, now: u64) {
        let clock = 1 << (self.control & ADPS).max(1);
        let start = self.on_since + (now - self.on_since).next_multiple_of(clock);
        let (sample, end) = match self.is_first {
            true => FIRST_CONVERSION,
            false => CONVERSION,
        };
        self.conversion = Some(Conversion {
            start,
            sample: start + sample * clock / 2,
            end: start + end * clock / 2,
            mux: self.mux,
            result: None,
        });
    }

    fn sample(&mut self, mux: u8, inputs: &Inputs, pull_ups: u8) -> u16 {
        // Of five bits on the larger chip, where the reference is all ones but the last.
        let channel = match mux & 0x1F {
            LARGE_CHIPS_REFERENCE => CHANNEL_REFERENCE,
            mux => mux & 0x0F,
        };
        let (before, held) = self.sampled;
        let microvolts = match channel {
            0..CHANNEL_THERMOMETER => inputs.microvolts(channel, pull_ups >> channel & 1 == 1),
            CHANNEL_THERMOMETER => THERMOMETER,
            CHANNEL_REFERENCE if before != CHANNEL_REFERENCE => held.midpoint(REFERENCE),
            CHANNEL_REFERENCE => REFERENCE,
            _ => 0,
        };
        self.sampled = (channel, microvolts);
        let against = match mux >> 6 {
            1 => inputs.supply(),
            3 => REFERENCE,
            // AREF is open on the UNO, 2 is reserved: anything is above nothing.
            _ => 0,
        };
        let steps = u64::from(microvolts) * 1024;
        let reading = steps.checked_div(against.into()).unwrap_or(HIGHEST);
        reading.min(HIGHEST) as u16
    }

    fn aligned(&self) -> u16 {
        self.result << if self.mux & ADLAR == 0 { 0 } else { 6 }
    }
}
