//! Inputs of blocks that a text stores to before it calls them: `ST T1.IN`. Each is a marker, and keeps what it was
//! given last, as the standard has it.

use super::meaning::{Block, Names, Place};
use crate::tree::Bit;
use unoclp_point::Address;

/// The spellings of an input; the first is its own.
fn spellings(place: Place) -> &'static [&'static [&'static str]] {
    match place {
        Place::Timer(_) => &[&["IN"]],
        Place::Counter(_) => &[&["CU"], &["CD"], &["R", "RESET"], &["LD", "LOAD"]],
        Place::Trigger(..) => &[&["CLK"]],
        Place::Latch(..) => &[&["S", "S1", "SET", "SET1"], &["R", "R1", "RESET", "RESET1"]],
        _ => &[],
    }
}

impl Names<'_> {
    /// The place of an input of a block; none where there is no such input.
    pub(super) fn input(&mut self, place: Place, member: &str) -> Option<Place> {
        let block = match place {
            Place::Timer(timer) => Block::Timer(timer),
            Place::Counter(counter) => Block::Counter(counter),
            Place::Trigger(_, marker) => Block::Edge(marker),
            Place::Latch(_, marker) => Block::Latch(marker),
            _ => return None,
        };
        let mut all = spellings(place).iter();
        let input = all.find(|input| input.contains(&member))?.first()?;
        let marker = match self.block_inputs.get(&(block, *input)) {
            Some(&marker) => marker,
            None => {
                let marker = self.temps.named_marker(false);
                self.block_inputs.insert((block, *input), marker);
                marker
            }
        };
        Some(Place::Bit(Bit::At(Address::Marker(marker))))
    }

    /// Whether the text stores to this part of a block.
    pub(crate) fn stores(&self, name: &str, member: &str) -> bool {
        let name = name.to_uppercase();
        self.near.is_stored(&format!("{name}.{member}"))
    }
}
