//! Program memory: the program that was last accepted, kept in the EEPROM in the form of
//! [`unoclp_modbus::eeprom::program`].
//!
//! Owns when what is written; must not know where a program comes from.
//!
//! The mark goes invalid before anything changes, and valid when everything has been read back: a
//! program that was written in part never runs.

use crate::board::allowance::{self, LAST_PROGRAM, PROGRAMS_USED};
use crate::board::eeprom::Eeprom;
use crate::instructions::{BOARD, Uno};
use unoclp_core::{Cause, Crc16, Loader, Needs};
use unoclp_modbus::eeprom::program::{
    self, BLANK, HEAD, HEAD_BYTES, INVALID, LENGTH, MARK, STORED, SUM, VALID,
};

/// Bytes of the head and the checksum after it.
const HEADER: usize = HEAD_BYTES + 2;

/// Keeps a program, unless it is the one that is kept. Only bytes that differ are written.
///
/// # Errors
/// [`Cause::StoreFailed`] where the EEPROM does not give back what was written.
#[inline(never)]
pub fn save(eeprom: &Eeprom, stored: &[u8]) -> Result<(), Cause> {
    let header = &header(stored);
    if eeprom.read(MARK) == VALID && whole(eeprom, header, stored, false) {
        return Ok(());
    }
    allowance::take(&PROGRAMS_USED, LAST_PROGRAM);
    eeprom.write(MARK, INVALID);
    if !(whole(eeprom, header, stored, true) && whole(eeprom, header, stored, false)) {
        return Err(Cause::StoreFailed);
    }
    eeprom.write(MARK, VALID);
    Ok(())
}

/// Writes all after the mark, or tells whether it stands there.
#[inline(never)]
fn whole(eeprom: &Eeprom, header: &[u8; HEADER], stored: &[u8], write: bool) -> bool {
    pass(eeprom, HEAD, header, write) && pass(eeprom, STORED, stored, write)
}

/// A program that is kept and has been checked: what is known of it since. Its checksum is compared
/// again whenever it is linked.
#[derive(Clone, Copy)]
pub struct Kept {
    /// Bytes of the stored form.
    pub length: u16,
    /// The checksum of the header and of the program.
    pub sum: u16,
    /// How many codes its file had.
    pub codes: u16,
    /// What it asks of the pins.
    pub needs: Needs,
    /// How many timers it has.
    pub timers: u8,
    /// The highest counter that it names.
    pub counters: u8,
    /// The highest register that there is.
    pub registers: u8,
    /// How many numbers it keeps.
    pub numbers: u8,
}

/// Checks the program that is kept, in this memory; none where there is none, or it is damaged.
pub fn load(eeprom: &Eeprom, memory: &mut [u8]) -> Option<Kept> {
    restore(eeprom, &mut Loader::new(memory, Uno))
}

/// Apart from [`load`], whose frame holds the loader: what lies beyond it in the same frame could be
/// reached only by detours.
#[inline(never)]
fn restore(eeprom: &Eeprom, loader: &mut Loader<'_, Uno>) -> Option<Kept> {
    let (length, sum) = (word(eeprom, LENGTH), word(eeprom, SUM));
    if eeprom.read(MARK) != VALID || length > BOARD.stored_bytes {
        return None;
    }
    let mut stored = (STORED..STORED + length).map(|address| eeprom.read(address));
    loader.restore(&mut stored).ok()?;
    let program = loader.finish().ok()?;
    // Its bytes have just come from there: only the checksum can differ.
    pass(eeprom, HEAD, &header(program.stored()), false).then_some(Kept {
        length,
        sum,
        codes: program.codes(),
        needs: program.needs(),
        timers: program.timers() as u8,
        counters: program.counters() as u8,
        registers: program.registers() as u8,
        numbers: program.kept_count(),
    })
}

impl Kept {
    /// Reads it again.
    pub fn read(self, eeprom: &Eeprom) -> Reader<'_> {
        Reader {
            eeprom,
            stored: self,
            position: 0,
            sum: Crc16::of(&program::head(self.length)),
        }
    }
}

/// Reads the program that is kept.
pub struct Reader<'e> {
    eeprom: &'e Eeprom,
    stored: Kept,
    position: u16,
    sum: Crc16,
}

impl Reader<'_> {
    /// The next byte.
    pub fn next(&mut self) -> Option<u8> {
        if self.position == self.stored.length {
            return None;
        }
        let byte = self.eeprom.read(STORED + self.position);
        self.position += 1;
        self.sum = self.sum.then(byte);
        Some(byte)
    }

    /// Whether the program that was checked has been read, all of it.
    pub fn is_whole(&self) -> bool {
        self.position == self.stored.length && self.sum.value() == self.stored.sum
    }
}

/// The length of the program that is kept, in the high word, and its checksum; 0 where there is none.
#[inline(never)]
pub fn kept(eeprom: &Eeprom) -> u32 {
    if eeprom.read(MARK) != VALID {
        return 0;
    }
    u32::from(word(eeprom, LENGTH)) << 16 | u32::from(word(eeprom, SUM))
}

#[inline(never)]
fn word(eeprom: &Eeprom, address: u16) -> u16 {
    u16::from_le_bytes([eeprom.read(address), eeprom.read(address + 1)])
}

/// Whether a program was ever kept.
pub fn is_blank(eeprom: &Eeprom) -> bool {
    eeprom.read(MARK) == BLANK
}

/// The head and the checksum.
fn header(stored: &[u8]) -> [u8; HEADER] {
    let mut header = [0; HEADER];
    let [head @ .., low, high] = &mut header;
    *head = program::head(stored.len() as u16);
    [*high, *low] = program::sum(stored).to_be_bytes();
    header
}

/// Writes these bytes here, or tells whether they stand here.
#[inline(never)]
fn pass(eeprom: &Eeprom, mut address: u16, bytes: &[u8], write: bool) -> bool {
    for &byte in bytes {
        if write {
            eeprom.write(address, byte);
        } else if eeprom.read(address) != byte {
            return false;
        }
        address += 1;
    }
    true
}

/// Reads the bytes that stand here.
#[inline(never)]
pub fn read(eeprom: &Eeprom, mut address: u16, bytes: &mut [u8]) {
    for byte in bytes {
        *byte = eeprom.read(address);
        address += 1;
    }
}

/// Writes bytes where they differ from what is there.
pub fn write(eeprom: &Eeprom, address: u16, bytes: &[u8]) {
    pass(eeprom, address, bytes, true);
}
