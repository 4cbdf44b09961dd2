//! What a PLC gives to a plant.

use unoclp_core::Image;

/// What a PLC gives to a plant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outputs {
    /// The outputs.
    pub points: Image,
    /// The PWM of the output with each number, 0 to 255; number 0 is none.
    pub pwm: [u8; 100],
}

impl Default for Outputs {
    fn default() -> Outputs {
        Outputs {
            points: Image::default(),
            pwm: [0; 100],
        }
    }
}
