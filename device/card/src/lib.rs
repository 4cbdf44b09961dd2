//! Finds one file in the root folder of a FAT16 or FAT32 card and reads it, block by block.
//!
//! Owns the way from a name to a file's bytes. Must not know how blocks come from the card, nor what the file says.
//!
//! It never writes, it needs no memory but the one block that its device has room for, and no content of a card
//! makes it panic or read forever. The firmware and the tests on a PC run this same code.
//!
//! ```
//! use unoclp_card::{Device, Error, File};
//!
//! fn length<D: Device>(card: &mut D) -> Result<usize, Error<D::Error>> {
//!     let mut file = File::default();
//!     file.open(card, b"PROGRAM TXT".iter().copied())?;
//!     let mut length = 0;
//!     while let Some(bytes) = file.next_block(card)? {
//!         length += bytes.len();
//!     }
//!     Ok(length)
//! }
//! ```
//!
//! What it reads: blocks of 512 bytes; a volume that starts at block 0, or in one of the four
//! primary partitions of an MBR; the first FAT alone; 8.3 names. What it does not: FAT12, exFAT,
//! GPT, logical partitions, other folders, long names (a file with a long name is found by its
//! 8.3 alias).
//!
//! Source of every offset and rule: *Microsoft Extensible Firmware Initiative FAT32 File System
//! Specification*, version 1.03. The code cites its chapters as (FAT, "FAT Data Structure").

#![no_std]
#![forbid(unsafe_code)]

#[cfg(feature = "image")]
extern crate std;

mod walk;

#[cfg(feature = "image")]
pub mod image;

use core::fmt;

use walk::Walk;

/// A block of a card.
pub type Block = [u8; 512];

/// Bytes of a block.
const BLOCK_BYTES: u32 = 512;

/// What gives the blocks of a card. It has room for one, and there is no way to write.
pub trait Device {
    /// Why there is no block.
    type Error;

    /// Reads the block of this number, counted from 0.
    ///
    /// # Errors
    /// Where the card does not give it.
    fn read(&mut self, number: u32) -> Result<(), Self::Error>;

    /// The block that was read last.
    fn block(&self) -> &Block;
}

/// Why a file cannot be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error<E> {
    /// The card did not give a block; its driver's own error says why.
    Device(E),
    /// There is no FAT16 or FAT32 volume: the card is empty, FAT12, exFAT, GPT or something else.
    NoVolume,
    /// The root folder has no file of that name.
    NotFound,
    /// A chain of clusters ends too early, leads to a cluster that is free, bad or outside the
    /// volume, runs in a circle, or is longer than 65,535 clusters (32 MiB or more of the card).
    Damaged,
}

impl<E: fmt::Display> fmt::Display for Error<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Device(error) => write!(f, "the card cannot be read: {error}"),
            Error::NoVolume => f.write_str("the card is not FAT16 or FAT32; format it"),
            Error::NotFound => f.write_str("no such file in the root folder of the card"),
            Error::Damaged => f.write_str("the card's FAT is damaged; check or format the card"),
        }
    }
}

impl<E: core::error::Error> core::error::Error for Error<E> {}

/// A file of a card, and how far it has been read; an empty one before it is opened.
#[derive(Debug, Default)]
pub struct File {
    walk: Walk,
    /// Bytes not read yet.
    left: u32,
    read_only: bool,
}

impl File {
    /// Finds a file in the root folder: from now this is that file.
    ///
    /// `name` is the 8.3 name as FAT stores it: eight characters and three in capital letters, padded
    /// with spaces, without the dot (`PROGRAM TXT`). Small ASCII letters in the folder count as capital
    /// ones. It is given byte by byte, so that it need not stand in RAM.
    /// Where several volumes or files match, the first counts. Between the calls that follow the
    /// device may be read from elsewhere.
    ///
    /// # Errors
    /// Any [`Error`]; `Damaged` here concerns the root folder.
    // Filled in place: given back, a file stands on the stack twice. Inlined on AVR, this and its
    // caller run out of registers and take 200 bytes more.
    #[inline(never)]
    pub fn open<D: Device>(
        &mut self,
        device: &mut D,
        name: impl Iterator<Item = u8> + Clone,
    ) -> Result<(), Error<D::Error>> {
        *self = File::default();
        self.walk.find(device)?;
        loop {
            self.walk.read_next(device)?;
            for entry in device.block().as_chunks().0 {
                // FAT, "FAT Directory Structure": name at 0, attributes at 11, cluster at 26
                // (upper half at 20), size at 28. A deleted entry starts with 0xE5, which no name of ASCII matches.
                let entry: &[u8; 32] = entry;
                if entry[0] == NEVER_USED {
                    return Err(Error::NotFound);
                }
                if entry[11] & NO_FILE == 0 && is_named(entry, name.clone()) {
                    let low = u16::from_le_bytes([entry[26], entry[27]]);
                    let high = u16::from_le_bytes([entry[20], entry[21]]);
                    self.left = u32::from_le_bytes([entry[28], entry[29], entry[30], entry[31]]);
                    self.read_only = entry[11] & READ_ONLY != 0;
                    self.walk.start(high, low);
                    return Ok(());
                }
            }
        }
    }

    /// Reads the next block of the file and gives those of its bytes that are the file's: 512, or
    /// 1 to 512 in the last one. `None`: the file has been read to its end.
    ///
    /// # Errors
    /// [`Error::Device`], and [`Error::Damaged`] where the chain of clusters does not hold what
    /// the folder gives as the file's size. Do not read on after an error.
    pub fn next_block<'d, D: Device>(
        &mut self,
        device: &'d mut D,
    ) -> Result<Option<&'d [u8]>, Error<D::Error>> {
        if self.left == 0 {
            return Ok(None);
        }
        self.walk.read_next(device).map_err(|error| match error {
            // The chain has ended before the file.
            Error::NotFound => Error::Damaged,
            error => error,
        })?;
        let length = self.left.min(BLOCK_BYTES);
        self.left -= length;
        Ok(device.block().get(..length as usize))
    }

    /// The number on the card of the first block of a file just opened, where it may be overwritten:
    /// all of its 512 bytes are the file's, the file is not marked read-only, and the FAT holds the
    /// block's cluster for taken. `None` where the file is too short or read-only. The block itself
    /// is not read: a power cut in a writing may have left it unreadable until the next.
    ///
    /// # Errors
    /// [`Error::Device`]; [`Error::Damaged`] where the file's first cluster is free, bad or outside
    /// the volume.
    pub fn first_block<D: Device>(
        &mut self,
        device: &mut D,
    ) -> Result<Option<u32>, Error<D::Error>> {
        if self.read_only || self.left < BLOCK_BYTES {
            return Ok(None);
        }
        self.walk.first_place(device).map(Some)
    }
}

/// Whether this entry of a folder has this name.
fn is_named(entry: &[u8; 32], name: impl Iterator<Item = u8>) -> bool {
    entry
        .iter()
        .zip(name)
        .all(|(a, b)| a.to_ascii_uppercase() == b)
}

/// First byte of an entry that was never used, nor were those after it.
const NEVER_USED: u8 = 0x00;
/// Attributes of what is no file: volume label (0x08, also part of a long name's 0x0F), folder.
const NO_FILE: u8 = 0x08 | 0x10;
/// Attribute of a file that is not to be changed.
const READ_ONLY: u8 = 0x01;

/// Every access to the card goes through here.
fn read<D: Device>(device: &mut D, number: u32) -> Result<(), Error<D::Error>> {
    device.read(number).map_err(Error::Device)
}
