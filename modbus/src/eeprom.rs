//! What a board keeps in its EEPROM of 1,024 bytes, where, and in what form. The forms do not depend on the build,
//! so a new firmware finds what the old one kept.
//!
//! | bytes | |
//! | --- | --- |
//! | 0 … 907 | [`program`], and behind it [`numbers`] |
//! | 908 … 917 | [`settings`] |
//! | 960 … 1023 | [`markers`] |

use crate::map::setting;
use unoclp_core::{Crc16, Profile};

/// The program that was last accepted.
///
/// | byte | |
/// | --- | --- |
/// | 0 | mark: [`VALID`](program::VALID), or anything else |
/// | 1 | [`VERSION`](program::VERSION) of this form |
/// | 2, 3 | bytes of the program, low byte first |
/// | 4, 5 | 0, kept free |
/// | 6, 7 | CRC-16 of bytes 1 to 5 and of the program, low byte first |
/// | 8 … | the program in its stored form, up to 900 bytes |
pub mod program {
    use super::*;

    /// Where the mark stands.
    pub const MARK: u16 = 0;
    /// The mark of a program that is kept.
    pub const VALID: u8 = 0x5A;
    /// The mark while it changes.
    pub const INVALID: u8 = 0x00;
    /// The mark where none was ever kept, as the chip comes.
    pub const BLANK: u8 = 0xFF;
    /// The version of this form. A change of the layout or of the stored form of an instruction takes a new one.
    pub const VERSION: u8 = 1;
    /// Where the head stands.
    pub const HEAD: u16 = MARK + 1;
    /// Bytes of the head: version, length, and what is kept free.
    pub const HEAD_BYTES: usize = 5;
    /// Where the length stands.
    pub const LENGTH: u16 = HEAD + 1;
    /// Where the check sum stands.
    pub const SUM: u16 = HEAD + HEAD_BYTES as u16;
    /// Where the stored form begins.
    pub const STORED: u16 = SUM + 2;
    /// The first byte behind the longest program.
    pub const END: u16 = STORED + Profile::UNO.stored_bytes;

    /// The head of a program of this length.
    #[inline(always)]
    pub const fn head(bytes: u16) -> [u8; HEAD_BYTES] {
        let [low, high] = bytes.to_le_bytes();
        [VERSION, low, high, 0, 0]
    }

    /// The check sum of a program's head and stored form.
    #[inline(always)]
    pub fn sum(stored: &[u8]) -> Crc16 {
        let mut sum = Crc16::of(&head(stored.len() as u16));
        sum.extend(stored);
        sum
    }
}

/// The numbers that a program keeps (NC-21): a ring of as many records as there is room for behind the program.
///
/// | byte | |
/// | --- | --- |
/// | 0 | sequence number: by one higher than that of the record before, wrapping |
/// | 1 … | the numbers in the program's order, 4 bytes each, low byte first |
/// | then 2 | CRC-16 of these, high byte first, that begins with the check sum of the program |
///
/// The sequence number is written last: until then a place is damaged, or what it was, and so is not the newest.
pub mod numbers {
    use super::*;
    use unoclp_core::{NUMBER_BYTES, RECORD_BYTES};

    /// Where the ring of a program of this length begins.
    pub const fn first(program_bytes: u16) -> u16 {
        program::STORED + program_bytes
    }

    /// Bytes of a record of so many numbers.
    pub const fn record(numbers: u8) -> u8 {
        numbers * NUMBER_BYTES + RECORD_BYTES
    }
}

/// The settings of the serial line.
///
/// | byte | |
/// | --- | --- |
/// | 908 … 915 | address, rate, parity, direction: a word each, low byte first |
/// | 916, 917 | CRC-16 of these, high byte first |
///
/// What is damaged or was written in part counts as the defaults.
pub mod settings {
    use super::*;

    /// Where they stand.
    pub const FIRST: u16 = program::END;
    /// Bytes of the values.
    pub const VALUES: usize = 2 * setting::ALL.len();
    /// Bytes with the check sum.
    pub const BYTES: usize = VALUES + 2;
    /// The first byte behind them.
    pub const END: u16 = FIRST + BYTES as u16;
}

/// The retentive markers M 57 to M 64 (NC-12): a ring of places of two bytes, the markers, inverted, and a number
/// by one higher than that of the place before.
pub mod markers {
    /// Where the ring begins.
    pub const FIRST: u16 = 960;
    /// How many places it has.
    pub const PLACES: u8 = 32;
    /// Bytes of a place.
    pub const PLACE_BYTES: u16 = 2;
    /// The first byte behind it.
    pub const END: u16 = FIRST + PLACE_BYTES * PLACES as u16;
}

/// Bytes of the EEPROM.
pub const BYTES: u16 = 1024;

const _: () = assert!(settings::END <= markers::FIRST && markers::END <= BYTES);
