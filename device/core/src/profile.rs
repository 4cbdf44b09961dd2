//! What a board has room for.

/// The limits of a board: what fits on it is decided from these alone, so host tools and firmware
/// say the same (NC-10).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Profile {
    /// Inputs 01 to this number exist, at most [`Point::MOST`](crate::Point::MOST).
    pub inputs: u8,
    /// Outputs 01 to this number exist, at most [`Point::MOST`](crate::Point::MOST).
    pub outputs: u8,
    /// Bytes that a program may take in its stored form.
    pub stored_bytes: u16,
    /// Bytes that a program may take in run memory: its linked form and its data.
    pub linked_bytes: u16,
    /// Whether it has the instructions of REAL numbers (NC-23).
    pub real: bool,
}

impl Profile {
    /// The Arduino UNO with the standard wiring: eight inputs, of which the last four share their pins
    /// with analogue inputs, and four outputs. A contact or a coil of one takes one byte; a timer block
    /// takes 6 bytes stored and 11 in run memory.
    pub const UNO: Profile = Profile {
        inputs: 8,
        outputs: 4,
        stored_bytes: 900,
        linked_bytes: 960,
        real: true,
    };

    /// The Arduino Nano, wired the same: its boot loader takes the room that REAL numbers would.
    pub const NANO: Profile = Profile {
        real: false,
        ..Profile::UNO
    };

    /// Bytes of memory in which a [`Plc`](crate::Plc) runs any program that fits: it keeps the stored form,
    /// which may be longer than the linked form, beside the data.
    pub const fn plc_bytes(&self) -> usize {
        self.stored_bytes as usize + self.linked_bytes as usize
    }
}
