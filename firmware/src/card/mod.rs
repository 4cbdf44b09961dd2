//! From the card to a checked program, and the place of the state on it.
//!
//! Owns what the card's failures mean to the user; must not know registers or the language.

mod commands;
mod reader;
pub mod writer;

use crate::board::Board;
pub use commands::CardFailed;
use reader::Card;
use unoclp_card::{Block, Error, File};
use unoclp_core::{Cause, Crc16, Fault, Loader, Profile, Program};

/// The program's 8.3 name as a directory holds it (NC-1).
const PROGRAM: &[u8; 11] = b"PROGRAM TXT";
/// The name of the file that keeps the state.
const STATE: &[u8; 11] = b"STATE   TXT";

/// A block of the card that may be overwritten. There is no other way to one than a `STATE.TXT`
/// that was found, and nothing but such a place is ever written.
pub struct Place {
    /// As the card's commands have it: a block's number, or its first byte on cards up to 2 GB.
    argument: u32,
}

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

/// Reads `PROGRAM.TXT` through the loader into run memory, twice: once to check all of it, and
/// once to be sure that the card gives the same again. Then looks for `STATE.TXT`, too on a card
/// that holds no program. The blocks of the card go through `block`.
///
/// An empty slot is known within 300 ms; a card that dies is given up within 2 s.
#[inline(never)]
pub fn load<'m>(
    board: &Board,
    block: &mut Block,
    memory: &'m mut [u8],
    state: &mut StateFile,
) -> Result<Program<'m>, Fault> {
    let mut card = Card::start(board, block).map_err(Fault::without_line)?;
    let program = read_twice(&mut card, memory);
    let no_fault = match &program {
        Ok(_) => true,
        Err(fault) => fault.cause == Cause::NoProgramFile,
    };
    if no_fault {
        *state = find_state(&mut card);
    }
    program
}

fn read_twice<'m>(card: &mut Card<'_>, memory: &'m mut [u8]) -> Result<Program<'m>, Fault> {
    let first = Crc16::of(read(card, memory)?.stored());
    let program = read(card, memory)?;
    if Crc16::of(program.stored()) == first {
        Ok(program)
    } else {
        Err(Fault::without_line(Cause::FileChanged))
    }
}

#[inline(never)]
fn find_state(card: &mut Card<'_>) -> StateFile {
    let mut file = File::default();
    let place = file.open(card, STATE).and_then(|()| file.first_block(card));
    match place {
        Ok(Some(number)) => StateFile::Found(card.place(number)),
        Ok(None) => StateFile::Unfit,
        Err(Error::NotFound) => StateFile::Missing,
        Err(_) => StateFile::Unreadable,
    }
}

/// Reads the file through the loader.
#[inline(never)]
fn read<'m>(card: &mut Card<'_>, memory: &'m mut [u8]) -> Result<Program<'m>, Fault> {
    let mut file = File::default();
    file.open(card, PROGRAM).map_err(fault)?;
    let mut loader = Loader::new(memory, Profile::UNO);
    while let Some(bytes) = file.next_block(card).map_err(fault)? {
        for &byte in bytes {
            loader.push(byte)?;
        }
    }
    loader.finish()
}

fn fault<E>(error: Error<E>) -> Fault {
    Fault::without_line(match error {
        Error::Device(_) => Cause::CardReadError,
        Error::NoVolume => Cause::NoVolume,
        Error::NotFound => Cause::NoProgramFile,
        Error::Damaged => Cause::VolumeDamaged,
    })
}
