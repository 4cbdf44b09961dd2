//! What can go wrong in setting up a simulation.

use crate::sd::Kind;
use std::path::{Path, PathBuf};

/// Why a simulated board or card could not be made or used.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The firmware is not where it is looked for.
    #[error(
        "no firmware at {}: build it with `cargo xtask firmware`, or name a file in UNOCLP_FIRMWARE",
        .0.display()
    )]
    NoFirmware(PathBuf),
    /// A file cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// The file is no ELF file, or a broken one.
    #[error("{} is not a usable ELF file: {source}", path.display())]
    Elf {
        /// The file.
        path: PathBuf,
        /// Why.
        source: object::Error,
    },
    /// The program in a file is not one for this chip.
    #[error("{} is not a program for the ATmega328P: {reason}", path.display())]
    NotForThisChip {
        /// The file.
        path: PathBuf,
        /// What does not fit.
        reason: String,
    },
    /// simavr could not make the chip.
    #[error("simavr cannot simulate the ATmega328P: {0}")]
    Simavr(&'static str),
    /// No card of this kind can hold the image.
    #[error(
        "an image of {len} bytes is too large for a card of kind {kind:?}; take a smaller image or Kind::Sdhc"
    )]
    ImageTooLarge {
        /// Kind of card that was asked for.
        kind: Kind,
        /// Length of the image in bytes.
        len: usize,
    },
    /// An address outside the memory that was meant.
    #[error("{len} bytes at {address:#06x} lie outside the {memory}")]
    OutOfRange {
        /// "RAM", "EEPROM" or "program".
        memory: &'static str,
        /// First byte.
        address: u32,
        /// Number of bytes.
        len: usize,
    },
    /// Optiboot cannot be built.
    #[error(
        "cannot build Optiboot of Debian's arduino-core-avr, which `cargo xtask setup` installs: {0}"
    )]
    NoBootLoader(String),
    /// The board on avr8js has not been built.
    #[error("no {}: build it with `npm ci` in page/ and `node build.mjs engine` in page/uno/", .0.display())]
    NoAvr8js(PathBuf),
    /// Node cannot be started.
    #[error("cannot start node, which runs avr8js: {0}")]
    NoNode(std::io::Error),
}

impl Error {
    /// What becomes of the error of a system that cannot read this file.
    pub(crate) fn read(path: &Path) -> impl FnOnce(std::io::Error) -> Error {
        let path = path.into();
        |source| Error::Read { path, source }
    }

    /// This file holds no program for the chip.
    pub(crate) fn unfit(path: &Path, reason: impl Into<String>) -> Error {
        Error::NotForThisChip {
            path: path.into(),
            reason: reason.into(),
        }
    }
}
