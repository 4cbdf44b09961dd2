//! Images of cards, as the blocks that are not empty.

use crate::words::{self, Both, both};
use serde::Serialize;
use unoclp_card::image::{Fat, Image};

/// The file in which the board keeps inputs and outputs, before it has done so.
const STATE: &[u8] = include_bytes!("../../programs/STATE.TXT");

/// A card.
#[derive(Debug, Serialize)]
pub struct Card {
    /// Of the whole card.
    bytes: usize,
    /// Those that are not empty: number, and hexadecimal digits of 512 bytes.
    blocks: Vec<(usize, String)>,
}

/// A card with this PROGRAM.TXT on it, and a STATE.TXT if that is asked for.
///
/// # Errors
/// Where it does not fit.
pub fn card(program: &str, state: bool) -> Result<Card, Both> {
    let mut image = Image::new(Fat::Fat16).file("PROGRAM.TXT", program);
    if state {
        image = image.file("STATE.TXT", STATE);
    }
    let image = image
        .build()
        .map_err(|error| both(|lang| words::no_card(lang, &error)))?;
    let blocks = image.chunks(512).enumerate();
    let full = blocks.filter(|(_, block)| block.iter().any(|&byte| byte != 0));
    let digits = |block: &[u8]| block.iter().map(|byte| format!("{byte:02x}")).collect();
    Ok(Card {
        bytes: image.len(),
        blocks: full
            .map(|(number, block)| (number, digits(block)))
            .collect(),
    })
}
