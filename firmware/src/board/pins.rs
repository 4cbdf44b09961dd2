//! Inputs, outputs, STOP, LED L and the card's select line (ATmega328P datasheet, section 14).

use super::chip::{PORTB, PORTC, PORTD};
use avr_device::interrupt;
use unoclp_core::Image;

/// PD2–PD5: inputs 01–04.
const INPUTS: u8 = 0b0011_1100;
/// PC0–PC3: inputs 05–08, in the image.
const MORE: u8 = 0xF0;
/// PD6, PD7: outputs 01 and 02.
const OUTPUTS_D: u8 = 0b1100_0000;
/// PB0, PB1: outputs 03 and 04.
const OUTPUTS_B: u8 = 0b0000_0011;
/// PB2: the card's select line, active low.
const CS: u8 = 1 << 2;
/// PB3: data to the card.
const MOSI: u8 = 1 << 3;
/// PB4: data from the card, with a pull-up so that an empty slot reads as ones.
const MISO: u8 = 1 << 4;
/// PB5: clock to the card, and LED L.
const SCK: u8 = 1 << 5;

/// PC5, A5: to GND is STOP.
const STOP: u8 = 1 << 5;

/// The levels of pins at one moment. A closed button pulls its pin low and reads as 1.
#[derive(Clone, Copy)]
pub struct Levels {
    d: u8,
    c: u8,
}

impl Levels {
    /// The input image of inputs 01 to 04.
    #[inline(always)]
    pub fn inputs(self) -> Image {
        Image(((!self.d & INPUTS) >> 2).into())
    }

    /// The input image. Of inputs 05 to 08 only those are read that are among these, bit 0 input 01; the
    /// others are 0.
    pub fn all_inputs(self, among: u8) -> Image {
        let more = !self.c << 4 & among & MORE;
        Image(self.inputs().0 | u16::from(more))
    }
}

/// The digital pins.
pub struct Pins {
    b: PORTB,
    c: PORTC,
    d: PORTD,
}

impl Pins {
    /// Outputs low before they are driven, pull-ups on inputs and STOP, the card not selected.
    #[inline(never)]
    pub fn new(b: PORTB, c: PORTC, d: PORTD) -> Pins {
        // SAFETY: any value may be written to the data and direction registers of a port; these
        // drive only pins that the wiring has as outputs.
        unsafe {
            d.portd().write(|w| w.bits(INPUTS));
            d.ddrd().write(|w| w.bits(OUTPUTS_D));
            c.portc().write(|w| w.bits(STOP));
            b.portb().write(|w| w.bits(CS | MISO));
            b.ddrb().write(|w| w.bits(OUTPUTS_B | CS | MOSI | SCK));
        }
        Pins { b, c, d }
    }

    /// Whether A5 is connected to GND.
    pub fn stop(&self) -> bool {
        self.c.pinc().read().pc5().bit_is_clear()
    }

    /// Whether A5 and all inputs are connected to GND: the way back to the default settings.
    #[inline(always)]
    pub fn ask_for_defaults(&self) -> bool {
        self.stop() && self.d.pind().read().bits() & INPUTS == 0
    }

    /// Pull-ups on those of inputs 05 to 08 that are among these, bit 0 input 01.
    pub fn pull_up(&self, inputs: u8) {
        // The serial port's interrupt writes A4.
        interrupt::free(|_| {
            // SAFETY: any value may be written to the port; pins of the other inputs float.
            unsafe {
                self.c
                    .portc()
                    .modify(|r, w| w.bits(r.bits() & !(MORE >> 4) | inputs >> 4))
            };
        });
    }

    /// The levels of all pins that can be inputs, at once.
    #[inline(always)]
    pub fn levels(&self) -> Levels {
        Levels {
            d: self.d.pind().read().bits(),
            c: self.c.pinc().read().bits(),
        }
    }

    /// Writes the output image, one write for each port.
    // Not in the usual scan, which is in `scan.s`.
    #[inline(never)]
    pub fn write_outputs(&self, image: Image) {
        let [bits, _] = image.0.to_le_bytes();
        let (d, b) = (bits << 6, bits >> 2 & OUTPUTS_B);
        // SAFETY: any value may be written to a port; only the bits of outputs change.
        unsafe {
            self.d
                .portd()
                .modify(|r, w| w.bits(r.bits() & !OUTPUTS_D | d));
            self.b
                .portb()
                .modify(|r, w| w.bits(r.bits() & !OUTPUTS_B | b));
        }
    }

    /// LED L. While the card's bus is on, the bus clock drives it.
    pub fn led(&self, on: bool) {
        self.b.portb().modify(|_, w| w.pb5().bit(on));
    }

    /// Selects the card, or not.
    pub fn select_card(&self, selected: bool) {
        self.b.portb().modify(|_, w| w.pb2().bit(!selected));
    }
}
