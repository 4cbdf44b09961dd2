//! What comes into a scan, and the input filter (NC-18).

use crate::width::{ANALOGUE, INPUTS};
use crate::{Bits, Image, ImageBits, Millis};

/// What a scan reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inputs {
    /// The inputs as the pins show them.
    pub points: Image,
    /// The readings of A 00 and those after it, 0 to 1023.
    pub analogue: [u16; ANALOGUE as usize],
    /// How long the last scan took, µs.
    pub scan_time: u16,
}

impl Inputs {
    /// These inputs, with the readings of A 00 and those after it.
    #[must_use]
    pub fn reading(mut self, readings: &[u16]) -> Inputs {
        for (place, &reading) in self.analogue.iter_mut().zip(readings) {
            *place = reading;
        }
        self
    }
}

impl Default for Inputs {
    fn default() -> Inputs {
        Inputs {
            points: Image(0),
            analogue: [0; ANALOGUE as usize],
            scan_time: 0,
        }
    }
}

impl From<Image> for Inputs {
    fn from(points: Image) -> Inputs {
        Inputs {
            points,
            ..Inputs::default()
        }
    }
}

/// The input image, which takes a level once an input has kept it for the filter's time.
#[derive(Clone, Copy, Debug)]
pub struct Debounce {
    image: Image,
    /// Time stamp of the scan before.
    before: Millis,
    /// ms since each input was first seen at the other level; 0 where it is not.
    differs: [u8; INPUTS as usize],
}

impl Default for Debounce {
    fn default() -> Debounce {
        Debounce::new()
    }
}

impl Debounce {
    /// All inputs 0.
    pub const fn new() -> Debounce {
        Debounce {
            image: Image(0),
            before: 0,
            differs: [0; INPUTS as usize],
        }
    }

    /// The image of the last scan.
    pub fn image(&self) -> Image {
        self.image
    }

    /// Takes the inputs of this scan, which are filtered by so many ms. The first scan takes them as they
    /// are.
    pub fn scan(&mut self, points: Image, time: u8, first: bool, now: Millis) {
        let passed = now.wrapping_sub(self.before).min(Millis::from(MOST)) as u8;
        let mut changed = (points.0 ^ self.image.0) as Bits;
        let (mut bit, mut other): (Bits, Bits) = (1, 0);
        for differs in &mut self.differs {
            // In the scan that first sees it, no time has passed: it is kept as 1, and counted from there.
            *differs = match (changed & 1, *differs) {
                (0, _) => 0,
                (_, 0) => 1,
                (_, differs) => differs.saturating_add(passed),
            };
            if *differs > time {
                *differs = 0;
                other |= bit;
            }
            bit <<= 1;
            changed >>= 1;
        }
        if first || time == 0 {
            self.image = points;
            self.differs = [0; INPUTS as usize];
        } else {
            self.image.0 ^= other as ImageBits;
        }
        self.before = now;
    }
}

/// More ms than any filter waits.
const MOST: u8 = 100;
