//! Program memory: the program that was last accepted, kept in the EEPROM.
//!
//! Owns the layout; must not know where a program comes from. The stored form does not depend on
//! the build, so a new firmware finds the program of the old one.
//!
//! | byte | |
//! | --- | --- |
//! | 0 | mark: [`VALID`], or anything else |
//! | 1 | version of this layout |
//! | 2, 3 | bytes of the program, low byte first |
//! | 4, 5 | 0, kept free |
//! | 6, 7 | CRC-16 of bytes 1 to 5 and of the program, low byte first |
//! | 8 … | the program in its stored form, up to 900 bytes |
//!
//! The mark goes invalid before anything changes, and valid when everything has been read back: a
//! program that was written in part never runs.

use crate::board::eeprom::Eeprom;
use crate::engine;
use unoclp_core::{Cause, Crc16, Loader, Profile, Program};

const MARK: u16 = 0;
const VALID: u8 = 0x5A;
const INVALID: u8 = 0x00;
const VERSION: u8 = 1;
/// Bytes of the header behind the mark.
const HEADER: usize = 7;
/// Where the program begins.
const PROGRAM: u16 = 1 + HEADER as u16;

/// Keeps a program, unless it is the one that is kept. Only bytes that differ are written.
///
/// # Errors
/// [`Cause::StoreFailed`] where the EEPROM does not give back what was written.
#[inline(never)]
pub fn save(eeprom: &Eeprom, stored: &[u8]) -> Result<(), Cause> {
    let header = header(stored);
    let whole =
        |write| pass(eeprom, MARK + 1, &header, write) && pass(eeprom, PROGRAM, stored, write);
    if eeprom.read(MARK) == VALID && whole(false) {
        return Ok(());
    }
    eeprom.write(MARK, INVALID);
    if !(whole(true) && whole(false)) {
        return Err(Cause::StoreFailed);
    }
    eeprom.write(MARK, VALID);
    Ok(())
}

/// A program that is kept and has been checked.
pub struct Kept<'m> {
    /// It, in run memory.
    pub program: Program<'m>,
    /// Where it is kept.
    pub stored: Stored,
}

/// What is known of the program that is kept since it was checked.
#[derive(Clone, Copy)]
pub struct Stored {
    /// Bytes.
    length: u16,
    /// The check sum of the header and of the program.
    sum: u16,
}

/// Takes the program that is kept into run memory; none where there is none, or it is damaged.
#[inline(never)]
pub fn load<'m>(eeprom: &Eeprom, memory: &'m mut [u8]) -> Option<Kept<'m>> {
    restore(
        eeprom,
        &mut Loader::with_table(memory, Profile::UNO, engine::instruction_table),
    )
}

/// Apart from [`load`], whose frame holds the loader: what lies beyond it in the same frame could be
/// reached only by detours.
#[inline(never)]
fn restore<'m>(eeprom: &Eeprom, loader: &mut Loader<'m>) -> Option<Kept<'m>> {
    let [length, sum] = [2, 6].map(|at| u16::from_le_bytes([eeprom.read(at), eeprom.read(at + 1)]));
    if eeprom.read(MARK) != VALID || length > Profile::UNO.stored_bytes {
        return None;
    }
    let mut stored = (PROGRAM..PROGRAM + length).map(|address| eeprom.read(address));
    loader.restore(&mut stored).ok()?;
    let program = loader.finish().ok()?;
    // Its bytes have just come from there: only the check sum can differ.
    pass(eeprom, MARK + 1, &header(program.stored()), false).then_some(Kept {
        program,
        stored: Stored { length, sum },
    })
}

impl Stored {
    /// Reads it again.
    pub fn read(self, eeprom: &Eeprom) -> Reader<'_> {
        Reader {
            eeprom,
            stored: self,
            position: 0,
            sum: Crc16::of(&self.head()),
        }
    }

    /// The header up to the check sum.
    fn head(self) -> [u8; HEADER - 2] {
        let [low, high] = self.length.to_le_bytes();
        [VERSION, low, high, 0, 0]
    }
}

/// Reads the program that is kept.
pub struct Reader<'e> {
    eeprom: &'e Eeprom,
    stored: Stored,
    position: u16,
    sum: Crc16,
}

impl Reader<'_> {
    /// The next byte.
    #[inline(never)]
    pub fn next(&mut self) -> Option<u8> {
        if self.position == self.stored.length {
            return None;
        }
        let byte = self.eeprom.read(PROGRAM + self.position);
        self.position += 1;
        self.sum.push(byte);
        Some(byte)
    }

    /// How many bytes have been read.
    pub fn position(&self) -> u16 {
        self.position
    }

    /// Whether the program that was checked has been read, all of it.
    pub fn is_whole(&self) -> bool {
        self.position == self.stored.length && self.sum.value() == self.stored.sum
    }
}

/// The length of the program that is kept, in the high word, and its check sum; 0 where there is none.
#[inline(never)]
pub fn kept(eeprom: &Eeprom) -> u32 {
    if eeprom.read(MARK) != VALID {
        return 0;
    }
    u32::from_le_bytes([6, 7, 2, 3].map(|address| eeprom.read(address)))
}

/// Whether a program was ever kept.
pub fn is_blank(eeprom: &Eeprom) -> bool {
    eeprom.read(MARK) == 0xFF
}

/// The bytes of the header behind the mark.
fn header(stored: &[u8]) -> [u8; HEADER] {
    let [low, high] = (stored.len() as u16).to_le_bytes();
    let mut header = [VERSION, low, high, 0, 0, 0, 0];
    let mut crc = Crc16::of(&header[..HEADER - 2]);
    crc.extend(stored);
    [header[HEADER - 2], header[HEADER - 1]] = crc.value().to_le_bytes();
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

/// Writes bytes where they differ from what is there.
#[inline(never)]
pub fn write(eeprom: &Eeprom, mut address: u16, bytes: &[u8]) {
    for &byte in bytes {
        eeprom.write(address, byte);
        address += 1;
    }
}
