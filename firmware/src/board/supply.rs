//! The supply voltage, against the chip's own 1.1 V reference
//! (ATmega328P datasheet, sections 24 and 29.8).

use avr_device::atmega328p::ADC;

/// The reference as a fraction of the supply, in 1024ths, at 4.3 V: more means less supply.
/// The reference itself is good to 10 %.
const LOW: u16 = (1100 * 1024 / 4300) as u16;
/// Hundredths of a volt, times the reading: 1.1 V × 1024.
const CENTIVOLTS: u32 = 110 * 1024;

/// The converter, which measures the reference over and over.
pub struct Supply {
    adc: ADC,
}

impl Supply {
    /// Starts measuring; the first reading is there after 0.3 ms.
    pub fn start(adc: ADC) -> Supply {
        adc.admux().write(|w| w.refs().avcc().mux().adc_vbg());
        // Free running, at 125 kHz: a reading takes 104 µs.
        adc.adcsra().write(|w| {
            w.aden().set_bit().adsc().set_bit().adate().set_bit();
            w.adps().prescaler_128()
        });
        Supply { adc }
    }

    /// Whether the supply is below 4.3 V.
    pub fn is_low(&self) -> bool {
        self.reading() > LOW
    }

    /// The reading of the reference, which is less the more supply there is.
    pub fn reading(&self) -> u16 {
        self.adc.adc().read().bits()
    }

    /// The supply in hundredths of a volt; by subtraction, since a division takes 1.5 KB of flash.
    pub fn centivolts(&self) -> u16 {
        let reading = self.reading().max(1);
        let (mut rest, mut centivolts) = (CENTIVOLTS, 0);
        while rest >= u32::from(reading) && centivolts < 1000 {
            rest -= u32::from(reading);
            centivolts += 1;
        }
        centivolts
    }
}
