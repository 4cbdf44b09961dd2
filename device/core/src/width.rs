//! How many points a board has at most, and integers with a bit for each: on a PC as many as codes of two digits name; in
//! a firmware as many as its boards have, since each takes flash and RAM there.

pub use most::{ANALOGUE, Bits, INPUTS, ImageBits, LABELS};

#[cfg(not(target_arch = "avr"))]
mod most {
    /// A bit for each point of a kind, in what a program [needs](crate::Needs).
    pub type Bits = u128;
    /// The bits of an [`Image`](crate::Image).
    pub type ImageBits = u128;
    /// Inputs at most.
    pub const INPUTS: u8 = 99;
    /// Labels at most.
    pub const LABELS: u8 = 99;
    /// Analogue inputs at most.
    pub const ANALOGUE: u8 = 99;
}

#[cfg(all(target_arch = "avr", mega))]
mod most {
    /// A bit for each point of a kind, in what a program [needs](crate::Needs).
    pub type Bits = u32;
    /// The bits of an [`Image`](crate::Image).
    pub type ImageBits = u32;
    pub const INPUTS: u8 = 24;
    pub const LABELS: u8 = 32;
    pub const ANALOGUE: u8 = 8;
}

#[cfg(all(target_arch = "avr", not(mega)))]
mod most {
    /// A bit for each point of a kind, in what a program [needs](crate::Needs).
    pub type Bits = u8;
    /// The bits of an [`Image`](crate::Image).
    pub type ImageBits = u16;
    pub const INPUTS: u8 = 8;
    pub const LABELS: u8 = 32;
    pub const ANALOGUE: u8 = 5;
}

/// Bytes in which each label has a bit.
pub const LABEL_BYTES: usize = (LABELS as usize).div_ceil(8);
