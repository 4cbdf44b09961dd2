//! Program files, and how long a text may be.

use std::fs::{self, File};
use std::io::{ErrorKind, Read};
use std::path::Path;
use unoclp_program::shown;

/// A program file: what to call it, and its bytes as they stand on a card.
#[derive(Clone, Debug)]
pub struct ProgramFile {
    /// The path of the file, or where its text stands.
    pub name: String,
    /// The bytes, unchecked.
    pub bytes: Vec<u8>,
}

/// The longest text that is read, of a program or a scenario, in bytes: far more than any has, comments included.
pub const LONGEST: u64 = 1 << 20;

/// Why a file could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unreadable {
    /// It has more than [`LONGEST`] bytes.
    TooLong,
    /// It is a folder.
    Folder,
    /// It is a device or a pipe, which may never end.
    NoFile,
    /// The system does not let it.
    System {
        /// What kind of error it is.
        kind: ErrorKind,
        /// What the system says, in English.
        told: String,
    },
}

impl From<std::io::Error> for Unreadable {
    fn from(error: std::io::Error) -> Unreadable {
        Unreadable::System {
            kind: error.kind(),
            told: error.to_string(),
        }
    }
}

impl ProgramFile {
    /// Reads a program file.
    ///
    /// # Errors
    /// [`Unreadable`]. Of a file that is too long no more is read than shows it.
    pub fn read(path: &Path) -> Result<ProgramFile, Unreadable> {
        Ok(ProgramFile {
            name: shown(path),
            bytes: bytes(path)?,
        })
    }
}

/// The bytes of a text, of which there are not more than [`LONGEST`].
pub(super) fn bytes(path: &Path) -> Result<Vec<u8>, Unreadable> {
    // A pipe without a writer would not even open.
    match fs::metadata(path)? {
        there if there.is_file() => {}
        there if there.is_dir() => return Err(Unreadable::Folder),
        _ => return Err(Unreadable::NoFile),
    }
    let mut bytes = Vec::new();
    let file = File::open(path)?;
    file.take(LONGEST + 1).read_to_end(&mut bytes)?;
    match bytes.len() as u64 > LONGEST {
        true => Err(Unreadable::TooLong),
        false => Ok(bytes),
    }
}
