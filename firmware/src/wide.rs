//! Images and forces of a board that has more points than a byte has bits.
//!
//! Owns how they are kept for the scan and for Modbus; must not know who scans or asks.

use unoclp_core::Image;

/// Points that are forced, and to what, bit 0 point 01; and how many seconds without a request end all forcing, 0 for
/// none.
#[derive(Clone, Copy, Default)]
pub struct Forces {
    inputs: [u16; 2],
    inputs_to: [u16; 2],
    outputs: u16,
    outputs_to: u16,
    ends: u16,
}

/// The words of [`Forces`], as the Modbus map has them in a row: inputs 01 to 16, outputs, the end, inputs from 17 on.
const WORDS: usize = 7;

impl Forces {
    fn words(&mut self) -> [&mut u16; WORDS] {
        let ([inputs, more], [to, more_to]) = (&mut self.inputs, &mut self.inputs_to);
        let (outputs, outputs_to) = (&mut self.outputs, &mut self.outputs_to);
        [
            inputs,
            to,
            outputs,
            outputs_to,
            &mut self.ends,
            more,
            more_to,
        ]
    }

    /// A word of them.
    pub fn word(mut self, index: u8) -> u16 {
        let word = self.words().into_iter().nth(index.into());
        word.map_or(0, |word| *word)
    }

    /// Sets one.
    pub fn set_word(&mut self, index: u8, value: u16) {
        if let Some(word) = self.words().into_iter().nth(index.into()) {
            *word = value;
        }
    }

    /// Whether there are any.
    #[inline(always)]
    pub fn any(self) -> bool {
        let [low, high] = self.inputs;
        low | high | self.outputs != 0
    }

    /// Whether none are left where nobody has asked for so many seconds; which outputs were.
    pub fn end(&mut self, seconds: u8) -> Option<u32> {
        let ends = self.ends;
        (ends != 0 && u16::from(seconds) > ends).then(|| {
            let outputs = self.forced_outputs();
            *self = Forces {
                ends,
                ..Forces::default()
            };
            outputs
        })
    }

    /// The input image with the forced inputs as they are forced.
    #[inline(never)]
    pub fn inputs(self, image: Image) -> Image {
        let (points, to) = (long(self.inputs), long(self.inputs_to));
        Image(image.0 & !points | to & points)
    }

    /// Which outputs are forced, bit 0 output 01.
    pub fn forced_outputs(self) -> u32 {
        self.outputs.into()
    }

    /// The same of the output image.
    #[inline(never)]
    pub fn outputs(self, image: Image) -> Image {
        let (points, to) = (u32::from(self.outputs), u32::from(self.outputs_to));
        Image(image.0 & !points | to & points)
    }
}

fn long([low, high]: [u16; 2]) -> u32 {
    u32::from(high) << 16 | u32::from(low)
}

/// Inputs and outputs as a scan left them.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
#[repr(C)]
pub struct Images {
    /// Inputs 01 to 04 as bits 0 to 3, and outputs 01 to 04 as bits 4 to 7: a scan has them in one register.
    pub points: u8,
    /// Inputs 01 to 24, a byte for each port.
    pub ports: [u8; 3],
    /// Outputs 05 to 08 from bit 3 on, and 09 to 16, as their ports have them.
    pub rest: [u8; 2],
}

impl Images {
    /// Inputs 01 to 04 among the points.
    pub const INPUTS: u8 = 0x0F;
    /// The bit of output 01 among the points.
    pub const OUTPUTS_AT: u8 = 4;
    /// The bit of output 05 in [`rest`](Images::rest).
    const REST_AT: u8 = 3;

    /// The input image.
    #[inline(never)]
    pub fn inputs(self) -> Image {
        let [low, middle, high] = self.ports;
        Image(u32::from_le_bytes([low, middle, high, 0]))
    }

    /// The output image.
    #[inline(never)]
    pub fn outputs(self) -> Image {
        let [low, high] = self.rest;
        let first = self.points >> Self::OUTPUTS_AT | low >> Self::REST_AT << Self::OUTPUTS_AT;
        Image(u32::from_le_bytes([first, high, 0, 0]))
    }

    /// Outputs 01 to 04 of it.
    pub fn near_outputs(self) -> u32 {
        (self.points >> Self::OUTPUTS_AT).into()
    }

    /// Sets the input image.
    #[inline(never)]
    pub fn set_inputs(&mut self, inputs: Image) {
        let [low, middle, high, _] = inputs.0.to_le_bytes();
        self.points = self.points & !Self::INPUTS | low & Self::INPUTS;
        self.ports = [low, middle, high];
    }

    /// Sets the output image.
    #[inline(never)]
    pub fn set_outputs(&mut self, outputs: Image) {
        let [low, high, ..] = outputs.0.to_le_bytes();
        self.points = self.points & Self::INPUTS | low << Self::OUTPUTS_AT;
        self.rest = [low >> Self::OUTPUTS_AT << Self::REST_AT, high];
    }
}
