//! From the card to a checked program, and the place of the state on it.
//!
//! Owns what the card's failures mean to the user; must not know registers or the language.

pub mod writer;

use crate::board::Board;
use crate::board::spi::{CardBus, Pause};
use core::fmt;
use embedded_sdmmc::embedded_sdmmc_types::sdcard::CardType;
use embedded_sdmmc::sdcard::spi::AcquireOpts;
use embedded_sdmmc::{Block, BlockCount, BlockDevice, BlockIdx, SdCard};
use unoclp_card::{Error, File};
use unoclp_core::{Cause, Crc16, Fault, Loader, Profile, Program};

/// The program's 8.3 name as a directory holds it (NC-1).
const PROGRAM: &[u8; 11] = b"PROGRAM TXT";
/// The name of the file that keeps the state.
const STATE: &[u8; 11] = b"STATE   TXT";
/// How long a card may take from its first answer until it is ready, ms. The SD specification
/// allows it 1 s (4.2.3); together with a block's time this gives a dead card up within 2 s.
const READY: u16 = 1500;
/// How long one reading of a block may take, ms. The specification allows 100 ms (4.6.2.1).
const BLOCK: u16 = 120;
/// How often a slot that stays silent is asked: some cards miss the first command after power-up.
const CALLS: u8 = 4;
/// How often a block is read that arrives damaged: wires on a breadboard pick up noise.
const READS: u8 = 3;
/// How often a card that answers nonsense is asked to begin anew; the deadline comes first.
const RESTARTS: u32 = 1_000_000;

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
/// that holds no program.
///
/// An empty slot is known within 300 ms; a card that dies is given up within 2 s.
#[inline(never)]
pub fn load<'m>(
    board: &Board,
    memory: &'m mut [u8],
    state: &mut StateFile,
) -> Result<Program<'m>, Fault> {
    let card = Card::new(board);
    card.start().map_err(Fault::without_line)?;
    take(&card, &mut Block::new(), memory, state)
}

/// Apart from [`load`], whose frame holds the block: what lies beyond it in the same frame could
/// be reached only by long detours. So [`Card::new`] and [`Card::start`] are too.
#[inline(never)]
fn take<'m>(
    card: &Card<'_>,
    block: &mut Block,
    memory: &'m mut [u8],
    state: &mut StateFile,
) -> Result<Program<'m>, Fault> {
    let program = read_twice(card, block, memory);
    let no_fault = match &program {
        Ok(_) => true,
        Err(fault) => fault.cause == Cause::NoProgramFile,
    };
    if no_fault {
        *state = find_state(card, block);
    }
    program
}

fn read_twice<'m>(
    card: &Card<'_>,
    block: &mut Block,
    memory: &'m mut [u8],
) -> Result<Program<'m>, Fault> {
    let first = Crc16::of(read(card, block, memory)?.stored());
    let program = read(card, block, memory)?;
    if Crc16::of(program.stored()) == first {
        Ok(program)
    } else {
        Err(Fault::without_line(Cause::FileChanged))
    }
}

#[inline(never)]
fn find_state(card: &Card<'_>, block: &mut Block) -> StateFile {
    let mut file = File::default();
    let place = file
        .open(card, block, STATE)
        .and_then(|()| file.first_block(card, block));
    match place {
        Ok(Some(BlockIdx(number))) => StateFile::Found(Place {
            argument: match card.0.get_card_type() {
                Some(CardType::SdhcSdxc) => number,
                _ => number << 9,
            },
        }),
        Ok(None) => StateFile::Unfit,
        Err(Error::NotFound) => StateFile::Missing,
        Err(_) => StateFile::Unreadable,
    }
}

/// Reads the file through the loader.
#[inline(never)]
fn read<'m>(
    card: &Card<'_>,
    block: &mut Block,
    memory: &'m mut [u8],
) -> Result<Program<'m>, Fault> {
    let mut file = File::default();
    file.open(card, block, PROGRAM).map_err(fault)?;
    let mut loader = Loader::new(memory, Profile::UNO);
    while let Some(bytes) = file.next_block(card, block).map_err(fault)? {
        for &byte in bytes {
            loader.push(byte)?;
        }
    }
    loader.finish()
}

/// The card.
struct Card<'b>(SdCard<CardBus<'b>, Pause>);

impl<'b> Card<'b> {
    #[inline(never)]
    fn new(board: &'b Board) -> Card<'b> {
        let options = AcquireOpts {
            use_crc: true,
            acquire_retries: RESTARTS,
        };
        Card(SdCard::new_with_options(board.card_bus(), Pause, options))
    }

    /// Wakes the card until it is ready.
    #[inline(never)]
    fn start(&self) -> Result<(), Cause> {
        for _ in 0..CALLS {
            self.0.spi(|bus| bus.wake(READY));
            if self.0.get_card_type().is_some() {
                self.0.spi(CardBus::full_speed);
                return Ok(());
            }
            if self.0.spi(|bus| bus.answered()) {
                return Err(Cause::CardDead);
            }
        }
        Err(Cause::NoCard)
    }
}

/// A block cannot be read, not even on another try.
#[derive(Debug)]
struct ReadError;

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(Cause::CardReadError.text())
    }
}

impl core::error::Error for ReadError {}

impl BlockDevice for Card<'_> {
    type Error = ReadError;

    fn read(&self, blocks: &mut [Block], start: BlockIdx) -> Result<(), ReadError> {
        for _ in 0..READS {
            self.0.spi(|bus| bus.allow(BLOCK));
            if self.0.read(blocks, start).is_ok() {
                return Ok(());
            }
        }
        Err(ReadError)
    }

    /// Refused: what is written to the card goes through [`writer`].
    fn write(&self, _: &[Block], _: BlockIdx) -> Result<(), ReadError> {
        Err(ReadError)
    }

    fn num_blocks(&self) -> Result<BlockCount, ReadError> {
        self.0.num_blocks().map_err(|_| ReadError)
    }
}

fn fault<E>(error: Error<E>) -> Fault {
    Fault::without_line(match error {
        Error::Device(_) => Cause::CardReadError,
        Error::NoVolume => Cause::NoVolume,
        Error::NotFound => Cause::NoProgramFile,
        Error::Damaged => Cause::VolumeDamaged,
    })
}
