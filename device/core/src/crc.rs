//! The checksum that tells whether a program is still the one that was accepted.

/// CRC-16/CCITT with start value 0xFFFF (polynomial 0x1021), a byte at a time.
///
/// It finds every change of up to three bits in a program of this size, and every burst of up to
/// 16 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crc16 {
    low: u8,
    high: u8,
}

impl Default for Crc16 {
    fn default() -> Crc16 {
        Crc16::starting_at(0xFFFF)
    }
}

impl Crc16 {
    /// No bytes so far, with another start value: memory cards take 0.
    pub const fn starting_at(value: u16) -> Crc16 {
        let [low, high] = value.to_le_bytes();
        Crc16 { low, high }
    }

    /// Takes the next byte.
    #[inline(always)]
    pub fn push(&mut self, byte: u8) {
        let mut next = self.high ^ byte;
        next ^= next >> 4;
        self.high = self.low ^ next << 4 ^ next >> 3;
        self.low = next ^ next << 5;
    }

    /// The same where room counts and not time.
    #[inline(never)]
    pub fn then(mut self, byte: u8) -> Crc16 {
        self.push(byte);
        self
    }

    /// Takes the next bytes.
    #[inline(always)]
    pub fn extend(&mut self, bytes: &[u8]) {
        *self = self.and(bytes);
    }

    // Given and returned by value, a checksum stays in registers.
    #[inline(never)]
    fn and(mut self, bytes: &[u8]) -> Crc16 {
        for &byte in bytes {
            self.push(byte);
        }
        self
    }

    /// The checksum of the bytes so far.
    pub fn value(self) -> u16 {
        u16::from_le_bytes([self.low, self.high])
    }

    /// The checksum of the bytes so far, as memory cards send it: the high byte first.
    pub const fn to_be_bytes(self) -> [u8; 2] {
        [self.high, self.low]
    }

    /// The checksum of these bytes.
    pub fn of(bytes: &[u8]) -> Crc16 {
        Crc16::default().and(bytes)
    }
}
