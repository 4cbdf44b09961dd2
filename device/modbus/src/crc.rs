//! The checksum of a Modbus RTU frame.

/// CRC-16/MODBUS (polynomial 0x8005 reflected, start value 0xFFFF), a byte at a time. Over
/// `123456789` it is 0x4B37.
///
/// It is sent after the frame, low byte first. Over a frame and its CRC it is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crc {
    low: u8,
    high: u8,
}

impl Default for Crc {
    fn default() -> Crc {
        Crc {
            low: 0xFF,
            high: 0xFF,
        }
    }
}

impl Crc {
    /// Takes the next byte.
    ///
    /// Eight steps of the register at once: what they shift out is `x`, and each bit of it comes back
    /// times 0xA001. The sum of that is `x << 6 ^ x << 7`, and 0xC001 where the bits of `x` are odd.
    #[inline(always)]
    pub fn push(&mut self, byte: u8) {
        let x = byte ^ self.low;
        let mut odd = x ^ x >> 4;
        odd ^= odd >> 2;
        odd = (odd ^ odd >> 1) & 1;
        self.low = self.high ^ x << 6 ^ x << 7 ^ odd;
        self.high = x >> 2 ^ x >> 1 ^ odd << 6 ^ odd << 7;
    }

    /// Takes the next bytes.
    pub fn extend(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.push(byte);
        }
    }

    /// The checksum of these bytes.
    pub fn of(bytes: &[u8]) -> Crc {
        let mut crc = Crc::default();
        crc.extend(bytes);
        crc
    }

    /// The checksum of the bytes so far.
    pub const fn value(self) -> u16 {
        u16::from_le_bytes(self.to_bytes())
    }

    /// The checksum of the bytes so far, as it is sent.
    pub const fn to_bytes(self) -> [u8; 2] {
        [self.low, self.high]
    }
}
