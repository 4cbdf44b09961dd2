//! What a board keeps in its EEPROM, where, and in what form. The forms do not depend on the build,
//! so a new firmware finds what the old one kept. Of the 1,024 bytes of an UNO:
//!
//! | bytes | |
//! | --- | --- |
//! | 0 … 907 | [`program`], and after it [`numbers`] |
//! | 908 … 917 | [`settings`] of 0.1.0 |
//! | 918 … | [`settings`] |
//! | 960 … 1023 | [`markers`] |
//!
//! A Mega has 4,096 bytes: the program and what follows it reach as far as its longest program does, and the markers stand
//! at the end.

use crate::map::{self, setting};
use unoclp_core::{Board, Crc16};

/// The board whose EEPROM it is.
const BOARD: Board = map::BOARD;

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
    /// The version of this layout: a change takes a new one.
    pub const VERSION: u8 = 1;
    /// The version of the stored form of programs, as a board tells it. A program may be stored otherwise by each, and
    /// what the versions before stored means the same: 1, each constant takes 4 bytes; 2, it takes 1, 2 or 4.
    pub const FORM: u8 = 2;
    /// Where the head stands.
    pub const HEAD: u16 = MARK + 1;
    /// Bytes of the head: version, length, and what is kept free.
    pub const HEAD_BYTES: usize = 5;
    /// Where the length stands.
    pub const LENGTH: u16 = HEAD + 1;
    /// Where the checksum stands.
    pub const SUM: u16 = HEAD + HEAD_BYTES as u16;
    /// Where the stored form begins.
    pub const STORED: u16 = SUM + 2;
    /// The first byte after the longest program.
    pub const END: u16 = STORED + BOARD.stored_bytes;

    /// The head of a program of this length.
    #[inline(always)]
    pub const fn head(bytes: u16) -> [u8; HEAD_BYTES] {
        let [low, high] = bytes.to_le_bytes();
        [VERSION, low, high, 0, 0]
    }

    /// The checksum of a program's head and stored form.
    #[inline(always)]
    pub fn sum(stored: &[u8]) -> Crc16 {
        let mut sum = Crc16::of(&head(stored.len() as u16));
        sum.extend(stored);
        sum
    }
}

/// The numbers that a program keeps (NC-21): a ring of as many records as there is room for after the program.
///
/// | byte | |
/// | --- | --- |
/// | 0 | sequence number: by one higher than that of the record before, wrapping |
/// | 1 … | the numbers in the program's order, 4 bytes each, low byte first |
/// | last two | CRC-16 of these, high byte first, that begins with the checksum of the program |
///
/// The CRC-16 of a whole record is 0. The sequence number is written last: until then the record does not count. Of
/// those that count, the newest is the one whose number is ahead of the others by less than 128. The next record goes
/// to the place after it, and to the first place where none counts or no more fits before [`program::END`].
pub mod numbers {
    use super::*;
    use unoclp_core::{NUMBER_BYTES, RECORD_BYTES};

    /// Where the ring of a program of this length begins.
    pub const fn first(program_bytes: u16) -> u16 {
        program::STORED + program_bytes
    }

    /// Bytes of a record of so many numbers, at most [`KEPT`](unoclp_core::KEPT).
    pub const fn record(numbers: u8) -> u8 {
        numbers * NUMBER_BYTES + RECORD_BYTES
    }
}

/// The settings, in two slots: the same in both.
///
/// | byte of a slot | |
/// | --- | --- |
/// | 0 | mark: [`VALID`](settings::VALID) once something was kept here |
/// | 1 … | the settings in the order of their registers: a word each, low byte first |
/// | last two | CRC-16 of these, high byte first |
///
/// A slot is sound where its mark is valid and its checksum right. The first one counts if it is sound, else the second,
/// which the first is written from at the next start, and the other way round. So one that is damaged opens no lock. New
/// settings go to the second slot, then to the first: wherever the supply fails, the old ones count or the new ones.
/// Without a sound slot the form of 0.1.0 counts, which had one place, four settings, and no mark; and without that the
/// defaults. Until 0.2.0 one of the slots counted, and the mark of the other was [`INVALID`](settings::INVALID).
pub mod settings {
    use super::*;

    /// Where those of 0.1.0 stand. A 0 in place of the address says that they count no more.
    pub const OLD: u16 = program::END;
    /// How many there were.
    const OLD_SETTINGS: usize = 4;
    /// Bytes of theirs, with the checksum.
    pub const OLD_BYTES: usize = 2 * OLD_SETTINGS + 2;
    /// Bytes of the values.
    pub const VALUES: usize = 2 * setting::ALL.len();
    /// Bytes of the values and the checksum.
    pub const BYTES: usize = VALUES + 2;
    /// Bytes of a slot.
    pub const SLOT_BYTES: u16 = 1 + BYTES as u16;
    /// Where the first slot begins: at its mark.
    pub const FIRST: u16 = OLD + OLD_BYTES as u16;
    /// Where the second does.
    pub const SECOND: u16 = FIRST + SLOT_BYTES;
    /// The first byte after it.
    pub const END: u16 = SECOND + SLOT_BYTES;
    /// The mark of a slot that was written.
    pub const VALID: u8 = 0x5A;
    /// The mark of one that was not: as the chip comes.
    pub const INVALID: u8 = 0xFF;
}

/// The retentive markers M 57 to M 64 (NC-12): a ring of places of two bytes, the markers, inverted, and a number
/// by one higher than that of the place before.
pub mod markers {
    /// Where the ring begins.
    pub const FIRST: u16 = super::BYTES - PLACE_BYTES * PLACES as u16;
    /// How many places it has.
    pub const PLACES: u8 = 32;
    /// Bytes of a place.
    pub const PLACE_BYTES: u16 = 2;
    /// The first byte after it.
    pub const END: u16 = FIRST + PLACE_BYTES * PLACES as u16;
}

/// Bytes of the EEPROM.
pub const BYTES: u16 = if cfg!(mega) { 4096 } else { 1024 };

const _: () = assert!(settings::END <= markers::FIRST && markers::END <= BYTES);
