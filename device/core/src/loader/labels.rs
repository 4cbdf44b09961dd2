//! Labels, and the jumps that lead to them (NC-19).

use crate::Cause;
use crate::isa::{self, By, Kind, Rows};
use crate::width::LABEL_BYTES;

/// The labels that have been defined.
#[derive(Default)]
pub(super) struct Labels {
    /// A bit for each, label 01 the lowest.
    defined: [u8; LABEL_BYTES],
    /// Whether there is a jump.
    jumps: bool,
    /// The line of the jump that leads nowhere.
    missing: u16,
}

impl Labels {
    /// A label that exists stands here.
    pub(super) fn define(&mut self, label: u8) -> Result<(), Cause> {
        match self.add(label) {
            true => Ok(()),
            false => Err(Cause::LabelTwice),
        }
    }

    /// A jump stands here.
    pub(super) fn jump(&mut self) {
        self.jumps = true;
    }

    /// Whether the label is new.
    fn add(&mut self, label: u8) -> bool {
        let index = label.wrapping_sub(1);
        let mask = 1u8 << (index & 7);
        match self.defined.get_mut(usize::from(index >> 3)) {
            Some(byte) if *byte & mask == 0 => {
                *byte |= mask;
                true
            }
            _ => false,
        }
    }

    /// Checks the jumps of a whole program in its stored form; each call tells of one label that is
    /// missing, the first in the program, and then knows it.
    pub(super) fn check_jumps(&mut self, rows: &impl Rows, stored: &[u8]) -> Result<(), Cause> {
        if !self.jumps {
            return Ok(());
        }
        let mut rest = stored;
        while let Some((&byte, behind)) = rest.split_first() {
            // What has been stored makes sense; if not, there is nothing to be found in it.
            let Some((entry, _)) = isa::find(rows, By::Stored(byte)) else {
                break;
            };
            if let (Kind::Jump, [label, low, high, ..]) = (entry.kind, behind)
                && self.add(*label)
            {
                self.missing = u16::from_le_bytes([*low, *high]);
                return Err(Cause::NoSuchLabel);
            }
            let Some(next) = isa::stored_size(&entry, rest).and_then(|size| rest.get(size..))
            else {
                break;
            };
            rest = next;
        }
        Ok(())
    }

    /// The line of the jump that [`check_jumps`](Labels::check_jumps) last told of.
    pub(super) fn missing_line(&self) -> u16 {
        self.missing
    }
}
