//! The two checksums of the SD bus (SD Physical Layer Simplified Specification, section 4.5).

/// CRC7 of a command or register, polynomial x⁷ + x³ + 1, as a number of 7 bits.
pub fn crc7(bytes: &[u8]) -> u8 {
    let mut crc = 0u8;
    for &byte in bytes {
        for bit in (0..8).rev() {
            let feedback = (crc >> 6 ^ byte >> bit) & 1;
            crc = crc << 1 & 0x7F;
            if feedback == 1 {
                crc ^= 0x09;
            }
        }
    }
    crc
}

/// CRC16 of a data packet, polynomial x¹⁶ + x¹² + x⁵ + 1 (CCITT, starting from 0).
pub fn crc16(bytes: &[u8]) -> u16 {
    let mut crc = 0u16;
    for &byte in bytes {
        crc ^= u16::from(byte) << 8;
        for _ in 0..8 {
            crc = if crc & 0x8000 == 0 {
                crc << 1
            } else {
                crc << 1 ^ 0x1021
            };
        }
    }
    crc
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crc7_of_the_commands_in_the_specification() {
        // Section 4.5: CMD0, CMD17 with argument 0, and the response to that CMD17.
        for (frame, crc) in [
            ([0x40, 0, 0, 0, 0], 0b100_1010),
            ([0x51, 0, 0, 0, 0], 0b010_1010),
            ([0x11, 0, 0, 0x09, 0], 0b011_0011),
            ([0x48, 0, 0, 0x01, 0xAA], 0x43),
        ] {
            assert_eq!(crc7(&frame), crc, "{frame:02x?}");
        }
    }

    #[test]
    fn crc16_of_known_packets() {
        // Section 4.5: 512 bytes of 0xFF. Then the check value of CRC-16/XMODEM.
        assert_eq!(crc16(&[0xFF; 512]), 0x7FA1);
        assert_eq!(crc16(b"123456789"), 0x31C3);
    }
}
