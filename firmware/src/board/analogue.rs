//! Analogue inputs and the supply voltage, from one converter (ATmega328P datasheet, section 24).
//!
//! Owns which channel is measured next; no call waits. Each channel is measured twice in a row and the
//! first reading dropped, because the sample capacitor still holds something of the channel before, and
//! the reference takes 70 µs to appear.

use super::chip::ADC;
use super::shared::Shared;
use crate::instructions::BOARD;

/// The readings of A 00 … A 04, 0 to 1023.
pub type Readings = [u16; BOARD.analogue as usize];

/// The reference as a fraction of the supply, in 1024ths, at 4.3 V: more means less supply.
/// The reference itself is good to 10 %.
const LOW: u16 = (1100 * 1024 / 4300) as u16;
/// Hundredths of a volt, times the reading: 1.1 V × 1024.
const CENTIVOLTS: u32 = 110 * 1024;
/// The channel that is the chip's own reference of 1.1 V, in `ADMUX`, with the supply as what is compared
/// with.
const REFERENCE: u8 = if cfg!(mega) { 0b1_1110 } else { 0b1110 };
const SUPPLY: u8 = 1 << 6;
/// After the last analogue input comes the reference.
const LAST: u8 = BOARD.analogue;

// Static, so that nobody has to carry a pointer to them along.

/// The analogue inputs that are measured, bit 0 A 00.
static CHANNELS: Shared<u8> = Shared::new(0);
/// The one that is being measured; [`LAST`] is the reference.
static CHANNEL: Shared<u8> = Shared::new(0);
/// Whether it is being measured for the second time.
static SETTLED: Shared<bool> = Shared::new(false);
/// The last reading of the reference.
static READING: Shared<u16> = Shared::new(0);

/// The converter.
pub struct Analogue {
    adc: ADC,
}

impl Analogue {
    /// Measures the supply, which takes 0.3 ms, and begins again with that.
    pub fn start(adc: ADC) -> Analogue {
        adc.adcsra()
            .write(|w| w.aden().set_bit().adps().prescaler_128());
        let analogue = Analogue { adc };
        CHANNEL.set(LAST);
        analogue.begin();
        analogue.go_on_to_reference(&mut Readings::default());
        analogue
    }

    /// From now on these inputs are measured too, bit 0 A 00; the readings of the others are 0. Each is
    /// measured once before this returns, which takes 0.2 ms each.
    pub fn measure(&self, channels: u8, readings: &mut Readings) {
        readings.fill(0);
        CHANNELS.set(channels);
        // The first time, those before the one that was being measured may have been passed over.
        self.go_on_to_reference(readings);
        self.go_on_to_reference(readings);
    }

    /// Measures until the reference has been.
    fn go_on_to_reference(&self, readings: &mut Readings) {
        READING.set(0);
        while READING.get() == 0 {
            self.step(readings);
        }
    }

    /// Takes a reading where one is ready, and begins the next, which takes 0.1 ms.
    pub fn step(&self, readings: &mut Readings) {
        // Set by the end of a conversion alone, so a converter that is off changes no reading.
        if self.adc.adcsra().read().adif().bit_is_set() {
            self.take(readings);
        }
    }

    #[inline(never)]
    fn take(&self, readings: &mut Readings) {
        if SETTLED.get() {
            let reading = self.adc.adc().read().bits();
            match readings.get_mut(usize::from(CHANNEL.get())) {
                Some(place) => *place = reading,
                None => READING.set(reading.max(1)),
            }
            self.next();
        }
        SETTLED.set(!SETTLED.get());
        self.begin();
    }

    /// Goes on to the next channel that is measured.
    fn next(&self) {
        let mut channel = CHANNEL.get();
        loop {
            channel = if channel >= LAST { 0 } else { channel + 1 };
            if channel == LAST || CHANNELS.get() >> channel & 1 != 0 {
                CHANNEL.set(channel);
                return;
            }
        }
    }

    fn begin(&self) {
        let mux = match CHANNEL.get() {
            LAST => REFERENCE,
            channel => channel,
        };
        // SAFETY: any channel may be measured.
        unsafe { self.adc.admux().write(|w| w.bits(SUPPLY | mux)) };
        // Writing the flag as 1 clears it.
        self.adc
            .adcsra()
            .modify(|_, w| w.adif().set_bit().adsc().set_bit());
    }

    /// The last reading of the reference: 1.1 V in 1024ths of the supply.
    pub fn reference(&self) -> u16 {
        READING.get()
    }

    /// Whether the supply is below 4.3 V.
    pub fn is_low(&self) -> bool {
        READING.get() > LOW
    }

    /// The supply in hundredths of a volt; by subtraction, since a division takes 1.5 KB of flash.
    pub fn centivolts(&self) -> u16 {
        let (mut rest, mut centivolts) = (CENTIVOLTS, 0);
        let reference = u32::from(READING.get());
        while rest >= reference && centivolts < 1000 {
            rest -= reference;
            centivolts += 1;
        }
        centivolts
    }
}
