//! From the card to a checked program.
//!
//! Owns what the card's failures mean to the user; must not know registers or the language.

use crate::board::Board;
use crate::board::spi::{CardBus, Pause};
use embedded_sdmmc::sdcard::spi::AcquireOpts;
use embedded_sdmmc::{Block, BlockCount, BlockDevice, BlockIdx, SdCard, SdCardError};
use unoclp_card::{Error, File};
use unoclp_core::{Cause, Fault, Loader, Millis, Profile, Program};

/// The program's 8.3 name as a directory holds it (NC-1).
const PROGRAM: &[u8; 11] = b"PROGRAM TXT";
/// How long a card may take from its first answer until it is ready, ms. The SD specification
/// allows it 1 s (4.2.3); together with a block's time this gives a dead card up within 2 s.
const READY: Millis = 1500;
/// How long the reading of one block may take, ms. The specification allows 100 ms (4.6.2.1).
const BLOCK: Millis = 300;
/// How often a card that answers nonsense is asked to begin anew; the deadline comes first.
const ATTEMPTS: u32 = 1_000_000;

/// Reads `PROGRAM.TXT` through the loader into run memory.
///
/// Nothing is ever written to the card. An empty slot is known within 300 ms; a card that dies is
/// given up within 2 s.
#[inline(never)]
pub fn load<'m>(board: &Board, memory: &'m mut [u8]) -> Result<Program<'m>, Fault> {
    let card = Card::start(board).map_err(Fault::without_line)?;
    read(&card, &mut Block::new(), memory)
}

/// Apart from [`load`], whose frame holds the block: what lies beyond it in the same frame could
/// be reached only by long detours.
#[inline(never)]
fn read<'m>(
    card: &Card<'_>,
    block: &mut Block,
    memory: &'m mut [u8],
) -> Result<Program<'m>, Fault> {
    let mut file = File::open(card, block, PROGRAM).map_err(fault)?;
    let mut loader = Loader::new(memory, Profile::UNO);
    while let Some(bytes) = file.next_block(card, block).map_err(fault)? {
        for &byte in bytes {
            loader.push(byte)?;
        }
    }
    loader.finish()
}

/// A card that is ready.
struct Card<'b>(SdCard<CardBus<'b>, Pause>);

impl<'b> Card<'b> {
    fn start(board: &'b Board) -> Result<Card<'b>, Cause> {
        let mut bus = board.card_bus();
        bus.allow(READY);
        let options = AcquireOpts {
            use_crc: true,
            acquire_retries: ATTEMPTS,
        };
        let card = SdCard::new_with_options(bus, Pause, options);
        if card.get_card_type().is_some() {
            card.spi(CardBus::full_speed);
            Ok(Card(card))
        } else if card.spi(|bus| bus.answered()) {
            Err(Cause::CardDead)
        } else {
            Err(Cause::NoCard)
        }
    }
}

impl BlockDevice for Card<'_> {
    type Error = SdCardError;

    fn read(&self, blocks: &mut [Block], start: BlockIdx) -> Result<(), SdCardError> {
        self.0.spi(|bus| bus.allow(BLOCK));
        self.0.read(blocks, start)
    }

    /// Refused: this firmware does not write to the card.
    fn write(&self, _: &[Block], _: BlockIdx) -> Result<(), SdCardError> {
        Err(SdCardError::WriteError)
    }

    fn num_blocks(&self) -> Result<BlockCount, SdCardError> {
        self.0.num_blocks()
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
