//! The registers of a card: OCR, CID and CSD (SD Physical Layer Simplified Specification, chapter 5).

use super::Kind;
use super::crc::crc7;
use crate::Error;

/// Bytes of one block, which is all that this card reads and writes at a time.
pub(super) const BLOCK: usize = 512;

/// OCR: all voltages from 2.7 to 3.6 V.
const OCR_VOLTAGES: u32 = 0x00FF_8000;
/// OCR bit 31: the card has finished powering up.
const OCR_POWERED_UP: u32 = 1 << 31;
/// OCR bit 30, CCS: the card is addressed in blocks. Valid once powered up.
const OCR_HIGH_CAPACITY: u32 = 1 << 30;

/// The OCR, as CMD58 sends it.
pub(super) fn ocr(kind: Kind, ready: bool) -> u32 {
    match (ready, kind) {
        (false, _) => OCR_VOLTAGES,
        (true, Kind::Sdhc) => OCR_VOLTAGES | OCR_POWERED_UP | OCR_HIGH_CAPACITY,
        (true, _) => OCR_VOLTAGES | OCR_POWERED_UP,
    }
}

/// The CID: no real manufacturer (MID 0), product "UNOCL", revision 1.0, serial number 1, made in January 2025.
pub(super) fn cid() -> [u8; 16] {
    let mut cid = [0; 16];
    cid[1..3].copy_from_slice(b"UC");
    cid[3..8].copy_from_slice(b"UNOCL");
    cid[8] = 0x10;
    cid[12] = 1;
    // MDT, 12 bits: years since 2000, then the month.
    cid[13] = 25 >> 4;
    cid[14] = (25 & 0x0F) << 4 | 1;
    seal(&mut cid);
    cid
}

/// The size of a card, in the terms of its CSD.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Geometry {
    kind: Kind,
    c_size: u32,
    /// C_SIZE_MULT; version 1 of the CSD only.
    mult: u32,
}

impl Geometry {
    /// The smallest card of this kind that holds `len` bytes.
    ///
    /// # Errors
    /// [`Error::ImageTooLarge`] where no CSD of this kind can say so much: 1 GiB for standard capacity (with blocks
    /// of 512 bytes), 2 TiB for high capacity.
    pub fn holding(kind: Kind, len: usize) -> Result<Geometry, Error> {
        let blocks = len.div_ceil(BLOCK).max(1);
        let (mult, c_size, limit) = match kind {
            Kind::Sdhc => (0, blocks.div_ceil(1024) - 1, 1 << 22),
            Kind::SdV1 | Kind::SdscV2 => {
                let mult = (0..7)
                    .find(|mult| blocks <= 4096 << (mult + 2))
                    .unwrap_or(7);
                (mult, blocks.div_ceil(4 << mult) - 1, 1 << 12)
            }
        };
        match u32::try_from(c_size) {
            Ok(c_size) if c_size < limit => Ok(Geometry { kind, c_size, mult }),
            _ => Err(Error::ImageTooLarge { kind, len }),
        }
    }

    /// Capacity in bytes.
    pub fn bytes(self) -> usize {
        let blocks = match self.kind {
            Kind::Sdhc => (self.c_size as usize + 1) * 1024,
            Kind::SdV1 | Kind::SdscV2 => (self.c_size as usize + 1) << (self.mult + 2),
        };
        blocks * BLOCK
    }

    /// The CSD: version 1.0 for standard capacity, 2.0 for high capacity (sections 5.3.2 and 5.3.3).
    pub fn csd(self) -> [u8; 16] {
        let mut csd = [0; 16];
        let high = self.kind == Kind::Sdhc;
        // (lowest bit, value), in the order of the specification's tables.
        let common = [
            (126, u32::from(high)),                // CSD_STRUCTURE
            (112, if high { 0x0E } else { 0x26 }), // TAAC: 1 ms, 1.5 ms
            (96, 0x32),                            // TRAN_SPEED: 25 MHz
            (84, 0x115),                           // CCC: classes 0, 2, 4, 8
            (80, 9),                               // READ_BL_LEN: 512 bytes
            (46, 1),                               // ERASE_BLK_EN
            (39, 0x7F),                            // SECTOR_SIZE
            (26, 2),                               // R2W_FACTOR: 4
            (22, 9),                               // WRITE_BL_LEN: 512 bytes
        ];
        let size: &[(u32, u32)] = if high {
            &[(48, self.c_size)]
        } else {
            // READ_BL_PARTIAL, C_SIZE, C_SIZE_MULT
            &[(79, 1), (62, self.c_size), (47, self.mult)]
        };
        for &(low, value) in common.iter().chain(size) {
            put(&mut csd, low, value);
        }
        seal(&mut csd);
        csd
    }
}

/// Sets the field of a register whose lowest bit is `low`; bit 127 is the first that is sent.
fn put(register: &mut [u8; 16], low: u32, value: u32) {
    let all = u128::from_be_bytes(*register) | u128::from(value) << low;
    *register = all.to_be_bytes();
}

/// Writes the last byte of a register: CRC7 and a 1.
fn seal(register: &mut [u8; 16]) {
    register[15] = crc7(&register[..15]) << 1 | 1;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_card_is_as_large_as_its_csd_can_say() {
        for (kind, len, bytes) in [
            (Kind::SdV1, 0, 4 * 512),
            (Kind::SdscV2, 4 * 512 + 1, 8 * 512),
            (Kind::SdscV2, 8 << 20, 8 << 20),
            (Kind::SdscV2, (8 << 20) + 1, (8 << 20) + 8 * 512),
            (Kind::SdscV2, 1 << 30, 1 << 30),
            (Kind::Sdhc, 1, 512 << 10),
            (Kind::Sdhc, (512 << 10) + 1, 1 << 20),
        ] {
            let geometry = Geometry::holding(kind, len).expect("fits");
            assert_eq!(geometry.bytes(), bytes, "{kind:?} with {len} bytes");
        }
        assert!(Geometry::holding(Kind::SdscV2, (1 << 30) + 1).is_err());
    }

    #[test]
    fn registers_carry_their_crc() {
        let csd = |kind| Geometry::holding(kind, 1 << 20).expect("fits").csd();
        for register in [cid(), csd(Kind::SdV1), csd(Kind::SdscV2), csd(Kind::Sdhc)] {
            assert_eq!(
                register[15],
                crc7(&register[..15]) << 1 | 1,
                "{register:02x?}"
            );
        }
    }
}
