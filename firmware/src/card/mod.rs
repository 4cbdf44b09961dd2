//! From the card to a checked program, and the place of the state on it.
//!
//! Owns what the card's failures mean to the user; must not know registers or the language.

mod commands;
mod reader;
pub mod writer;

use crate::board::Board;
use crate::board::flash::{Codes, flash_codes};
use crate::instructions::Uno;
pub use commands::{CardFailed, Place};
use reader::Card;
use unoclp_card::{Block, Error, File};
use unoclp_core::{Cause, Crc16, Fault, Loader, Program};

/// The program's 8.3 name as a directory holds it (NC-1).
const PROGRAM: &str = "PROGRAM TXT";
/// The name of the file that keeps the state.
const STATE: &str = "STATE   TXT";

/// The file that keeps the state.
pub enum StateFile {
    /// There is none, nor a card.
    Missing,
    /// It is shorter than a block, or marked read-only.
    Unfit,
    /// The card could not be read, or its FAT makes no sense here.
    Unreadable,
    /// Its first block.
    Found(Place),
}

/// Reads `PROGRAM.TXT` twice: once through the loader into run memory, and once to be sure that the
/// card gives the same again. Then looks for `STATE.TXT`, too on a card that holds no program. The
/// blocks of the card go through `block`.
///
/// An empty slot is known within 300 ms; a card that dies is given up within 2 s.
#[inline(never)]
pub fn load<'m>(
    board: &Board,
    block: &mut Block,
    memory: &'m mut [u8],
    state: &mut StateFile,
) -> Result<Program<'m>, Fault> {
    let by_number = reader::start(board).map_err(Fault::without_line)?;
    let mut card = Card::new(board, block, by_number);
    let program = read(&mut card, memory);
    let no_fault = match &program {
        Ok(_) => true,
        Err(fault) => fault.cause == Cause::NoProgramFile,
    };
    if no_fault {
        find_state(&mut card, state);
    }
    program
}

/// Apart from [`load`], so that its program is made where it stays.
#[inline(never)]
fn read<'m>(card: &mut Card<'_>, memory: &'m mut [u8]) -> Result<Program<'m>, Fault> {
    let mut loader = Loader::new(memory, Uno);
    match check(card, &mut loader) {
        Ok(()) => loader.finish(),
        Err(cause) => Err(Fault::without_line(cause)),
    }
}

/// Gives the loader the file, up to the first fault. Apart from [`read`], whose frame holds the loader:
/// what lies beyond it in the same frame could be reached only by detours.
#[inline(never)]
fn check(card: &mut Card<'_>, loader: &mut Loader<'_, Uno>) -> Result<(), Cause> {
    let (mut first, mut again) = (Crc16::default(), Crc16::default());
    let whole = pass(card, Some(loader), &mut first).map_err(cause)?;
    if whole {
        pass(card, None, &mut again).map_err(cause)?;
        if first != again {
            return Err(Cause::FileChanged);
        }
    }
    Ok(())
}

/// One passage through the file: gives its checksum, and whether the loader has taken all of it.
#[inline(never)]
fn pass(
    card: &mut Card<'_>,
    mut loader: Option<&mut Loader<'_, Uno>>,
    sum: &mut Crc16,
) -> Result<bool, Error<CardFailed>> {
    let mut file = File::default();
    file.open(card, flash_codes!(Codes::plain(PROGRAM)))?;
    while let Some(bytes) = file.next_block(card)? {
        sum.extend(bytes);
        if let Some(loader) = &mut loader {
            for &byte in bytes {
                if loader.push(byte).is_err() {
                    return Ok(false);
                }
            }
        }
    }
    Ok(true)
}

#[inline(never)]
fn find_state(card: &mut Card<'_>, state: &mut StateFile) {
    let mut file = File::default();
    let place = file
        .open(card, flash_codes!(Codes::plain(STATE)))
        .and_then(|()| file.first_block(card));
    *state = match place {
        Ok(Some(number)) => StateFile::Found(card.place(number)),
        Ok(None) => StateFile::Unfit,
        Err(Error::NotFound) => StateFile::Missing,
        Err(_) => StateFile::Unreadable,
    };
}

#[inline(never)]
fn cause(error: Error<CardFailed>) -> Cause {
    match error {
        Error::Device(_) => Cause::CardReadError,
        Error::NoVolume => Cause::NoVolume,
        Error::NotFound => Cause::NoProgramFile,
        Error::Damaged => Cause::VolumeDamaged,
    }
}
