//! Images of cards, as the blocks that are not empty.

mod room;

use crate::answer::answer;
use crate::given::{Given, wrong};
use crate::program::source;
use crate::words::{self, Both, No, both};
use room::BLOCK;
use serde_json::Value;
use std::collections::BTreeMap;
use unoclp_card::image::{Fat, Image};
use unoclp_card::{Block, Device, File};
use unoclp_program::not_sent;
use unoclp_workspace::Analysis;

/// The file in which the board keeps inputs and outputs, before it has done so.
const STATE: &[u8] = include_bytes!("../../../../programs/STATE.TXT");

answer! {
    /// A card.
    pub struct Card as "CardImage" {
        /// Of the whole card.
        bytes: usize,
        /// Those that are not empty: number, and hexadecimal digits of 512 bytes.
        blocks: Vec<(usize, String)>,
    }
}

/// A card with this PROGRAM.TXT on it, and a STATE.TXT if that is asked for.
///
/// # Errors
/// Where it does not fit, or the program is for what is no board.
pub fn card(program: &Analysis, state: bool) -> Result<Card, No> {
    let written = program.written();
    if !written.board.has_firmware() {
        let source = source(program)?;
        return Err(both(|lang| not_sent(source, lang).unwrap_or_default()).into());
    }
    let mut image = Image::new(Fat::Fat16).file("PROGRAM.TXT", written.text());
    if state {
        image = image.file("STATE.TXT", STATE);
    }
    let image = image
        .build()
        .map_err(|error| both(|lang| words::no_card(lang, &error)))?;
    let blocks = image.chunks(BLOCK).enumerate();
    let full = blocks.filter(|(_, block)| block.iter().any(|&byte| byte != 0));
    let digits = |block: &[u8]| block.iter().map(|byte| format!("{byte:02x}")).collect();
    Ok(Card {
        bytes: image.len(),
        blocks: full
            .map(|(number, block)| (number, digits(block)))
            .collect(),
    })
}

/// A card as a page tells of it: what it leaves out is empty.
struct Told {
    blocks: BTreeMap<u32, Block>,
    /// What was read last.
    last: Block,
}

impl Told {
    fn of(blocks: Vec<(u32, String)>) -> Told {
        let blocks = blocks.into_iter();
        Told {
            blocks: blocks
                .map(|(number, digits)| (number, block(&digits)))
                .collect(),
            last: [0; BLOCK],
        }
    }
}

impl Device for Told {
    type Error = std::convert::Infallible;

    fn read(&mut self, number: u32) -> Result<(), Self::Error> {
        self.last = self.blocks.get(&number).copied().unwrap_or([0; BLOCK]);
        Ok(())
    }

    fn block(&self) -> &Block {
        &self.last
    }
}

/// The blocks of a card as a request gives them.
///
/// # Errors
/// Where it gives none.
pub fn blocks(given: &mut Given) -> Result<Vec<(u32, String)>, Both> {
    let block = |block: &Value| {
        let number = u32::try_from(block.get(0)?.as_u64()?).ok()?;
        Some((number, block.get(1)?.as_str()?.to_owned()))
    };
    let blocks: Option<Vec<_>> = given.list("blocks")?.iter().map(block).collect();
    blocks.ok_or_else(|| wrong("blocks"))
}

/// Bytes that are free on a card; none where it has no FAT16 or FAT32.
pub fn free(blocks: Vec<(u32, String)>) -> Option<u64> {
    room::free(&mut Told::of(blocks))
}

/// The text of a file in the root folder, by its name in capital letters: `STATE.TXT`; none where there is no such file.
pub fn read(blocks: Vec<(u32, String)>, name: &str) -> Option<String> {
    let mut card = Told::of(blocks);
    let (stem, end) = name.split_once('.').unwrap_or((name, ""));
    let short = format!("{stem:<8}{end:<3}").into_bytes();
    let mut file = File::default();
    file.open(&mut card, short.iter().copied()).ok()?;
    let mut bytes = Vec::new();
    while let Ok(Some(part)) = file.next_block(&mut card) {
        bytes.extend_from_slice(part);
    }
    Some(unoclp_program::decode(&bytes))
}

/// The block of these hexadecimal digits; 0 where they are none.
fn block(digits: &str) -> Block {
    let mut block = [0; BLOCK];
    for (byte, pair) in block.iter_mut().zip(digits.as_bytes().chunks(2)) {
        let pair = std::str::from_utf8(pair).unwrap_or_default();
        *byte = u8::from_str_radix(pair, 16).unwrap_or_default();
    }
    block
}
