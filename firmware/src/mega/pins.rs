//! Inputs, outputs, STOP, LED L and the card's select line (ATmega2560 datasheet, section 13).

use super::chip::{PORTA, PORTB, PORTC, PORTD, PORTE, PORTG, PORTH, PORTK, PORTL};
use unoclp_core::Image;

/// PE4, PE5 and PE3: outputs 01, 02 and 04.
const OUTPUTS_E: u8 = 0b0011_1000;
/// PG5: output 03.
const OUTPUTS_G: u8 = 0b0010_0000;
/// PH3–PH6: outputs 05–08.
const OUTPUTS_H: u8 = 0b0111_1000;
/// PB0: the card's select line, active low.
const CS: u8 = 1 << 0;
/// PB1: clock to the card.
const SCK: u8 = 1 << 1;
/// PB2: data to the card.
const MOSI: u8 = 1 << 2;
/// PB3: data from the card, with a pull-up so that an empty slot reads as ones.
const MISO: u8 = 1 << 3;
/// PB7, D13: LED L.
const LED: u8 = 1 << 7;
/// PD0, D21: to GND is STOP.
const STOP: u8 = 1 << 0;
/// PD2, D19: what comes over the bus, with a pull-up so that a port without one is quiet.
const BUS: u8 = 1 << 2;
/// Inputs 01 to 04.
const FIRST: u32 = 0x0F;

/// The levels of pins at one moment. A closed button pulls its pin low and reads as 1.
#[derive(Clone, Copy)]
pub struct Levels([u8; 3]);

impl Levels {
    /// The input image.
    #[inline(always)]
    pub fn inputs(self) -> Image {
        let [a, k, c] = self.0;
        Image(u32::from_le_bytes([!a, !k, !c, 0]))
    }

    /// The same: each has a pin of its own.
    #[inline(always)]
    pub fn all_inputs(self, _: u32) -> Image {
        self.inputs()
    }
}

/// The digital pins.
pub struct Pins {
    a: PORTA,
    b: PORTB,
    c: PORTC,
    d: PORTD,
    e: PORTE,
    g: PORTG,
    h: PORTH,
    k: PORTK,
    l: PORTL,
}

impl Pins {
    /// Outputs low before they are driven, pull-ups on inputs and STOP, the card not selected.
    #[inline(never)]
    pub fn take() -> Pins {
        // SAFETY: called by the board, which is the owner of its ports, or where nothing else runs any more. Any value may
        // be written to the data and direction registers of a port; these drive only pins that the wiring has as outputs.
        unsafe {
            let pins = Pins {
                a: PORTA::steal(),
                b: PORTB::steal(),
                c: PORTC::steal(),
                d: PORTD::steal(),
                e: PORTE::steal(),
                g: PORTG::steal(),
                h: PORTH::steal(),
                k: PORTK::steal(),
                l: PORTL::steal(),
            };
            pins.e.porte().write(|w| w.bits(0));
            pins.e.ddre().write(|w| w.bits(OUTPUTS_E));
            pins.g.portg().write(|w| w.bits(0));
            pins.g.ddrg().write(|w| w.bits(OUTPUTS_G));
            pins.h.porth().write(|w| w.bits(0));
            pins.h.ddrh().write(|w| w.bits(OUTPUTS_H));
            pins.l.portl().write(|w| w.bits(0));
            pins.l.ddrl().write(|w| w.bits(u8::MAX));
            pins.a.porta().write(|w| w.bits(u8::MAX));
            pins.k.portk().write(|w| w.bits(u8::MAX));
            pins.c.portc().write(|w| w.bits(u8::MAX));
            pins.d.portd().write(|w| w.bits(STOP | BUS));
            pins.b.portb().write(|w| w.bits(CS | MISO));
            pins.b.ddrb().write(|w| w.bits(CS | SCK | MOSI | LED));
            pins
        }
    }

    /// Whether D21 is connected to GND.
    pub fn stop(&self) -> bool {
        self.d.pind().read().pd0().bit_is_clear()
    }

    /// Whether D21 and inputs 01 to 04 are connected to GND: the way back to the default settings.
    #[inline(always)]
    pub fn ask_for_defaults(&self) -> bool {
        self.stop() && self.levels().inputs().0 & FIRST == FIRST
    }

    /// All inputs have theirs.
    pub fn pull_up(&self, _: u32) {}

    /// The levels of all pins that can be inputs.
    #[inline(always)]
    pub fn levels(&self) -> Levels {
        Levels([
            self.a.pina().read().bits(),
            self.k.pink().read().bits(),
            self.c.pinc().read().bits(),
        ])
    }

    /// Writes the output image, one write for each port.
    // Not in the usual scan, which is in `scan.s`.
    #[inline(never)]
    pub fn write_outputs(&self, image: Image) {
        let [low, high, ..] = image.0.to_le_bytes();
        let e = low << 4 & 0b0011_0000 | low & 0b0000_1000;
        let g = low << 3 & OUTPUTS_G;
        let h = low >> 1 & OUTPUTS_H;
        // SAFETY: any value may be written to a port; only the bits of outputs change.
        unsafe {
            let (ports_e, ports_g, ports_h) = (self.e.porte(), self.g.portg(), self.h.porth());
            ports_e.modify(|r, w| w.bits(r.bits() & !OUTPUTS_E | e));
            ports_g.modify(|r, w| w.bits(r.bits() & !OUTPUTS_G | g));
            ports_h.modify(|r, w| w.bits(r.bits() & !OUTPUTS_H | h));
            self.l.portl().write(|w| w.bits(high));
        }
    }

    /// LED L.
    pub fn led(&self, on: bool) {
        self.b.portb().modify(|_, w| w.pb7().bit(on));
    }

    /// Selects the card, or not.
    pub fn select_card(&self, selected: bool) {
        self.b.portb().modify(|_, w| w.pb0().bit(!selected));
    }
}
