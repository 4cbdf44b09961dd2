//! The check sum that tells whether a program is still the one that was accepted.

/// CRC-16/CCITT with start value 0xFFFF (polynomial 0x1021), a byte at a time.
///
/// It finds every change of up to three bits in a program of this size, and every burst of up to
/// 16 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crc16(u16);

impl Default for Crc16 {
    fn default() -> Crc16 {
        Crc16::starting_at(0xFFFF)
    }
}

impl Crc16 {
    /// No bytes so far, with another start value: memory cards take 0.
    pub const fn starting_at(value: u16) -> Crc16 {
        Crc16(value)
    }

    /// Takes the next byte.
    #[inline(always)]
    pub fn push(&mut self, byte: u8) {
        let [low, high] = self.0.to_le_bytes();
        let mut next = high ^ byte;
        next ^= next >> 4;
        self.0 = u16::from_le_bytes([next ^ next << 5, low ^ next << 4 ^ next >> 3]);
    }

    /// The check sum of the bytes so far.
    pub fn value(self) -> u16 {
        self.0
    }

    /// The check sum of these bytes.
    pub fn of(bytes: &[u8]) -> Crc16 {
        let mut crc = Crc16::default();
        bytes.iter().for_each(|&byte| crc.push(byte));
        crc
    }
}
