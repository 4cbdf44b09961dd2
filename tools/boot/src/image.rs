//! A firmware file in Intel HEX, checked for a board.

use crate::failure::Unfit;
use crate::model::{Chip, Model};
use ihex::{ReaderError, Record};

/// What stands in flash that nobody has written.
const ERASED: u8 = 0xFF;
/// Bytes of a vector.
const VECTOR: usize = 4;
/// No record of a file that may be right reaches beyond this: the largest chip that any board here has.
const FARTHEST: usize = 0x4_0000;

/// What goes into the flash of a board, from address 0 on. It fits, and it is for the chip of that board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    bytes: Vec<u8>,
    model: Model,
}

impl Image {
    /// Reads a file in Intel HEX.
    ///
    /// # Errors
    /// [`Unfit`]: it is no such file, is damaged, is for another chip, or does not fit the board.
    pub fn read(file: &[u8], model: Model) -> Result<Image, Unfit> {
        let bytes = fill(file, model)?;
        if bytes.len() > model.chip().flash || !is_for(model.chip(), &bytes) {
            return Err(Unfit::OtherChip { model });
        }
        if bytes.len() > model.room() {
            return Err(Unfit::TooLarge {
                bytes: bytes.len(),
                model,
            });
        }
        Ok(Image { bytes, model })
    }

    /// The board that it was checked for.
    pub fn model(&self) -> Model {
        self.model
    }

    /// Its bytes from address 0 on; what the file leaves out is 0xFF.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The pages with their addresses in bytes, the last filled up.
    pub(crate) fn pages(&self) -> impl Iterator<Item = (u32, Vec<u8>)> {
        let size = self.model.chip().page;
        (0..)
            .zip(self.bytes.chunks(size))
            .map(move |(index, bytes)| {
                let mut page = bytes.to_vec();
                page.resize(size, ERASED);
                (index * size as u32, page)
            })
    }
}

/// Puts the records where they belong.
fn fill(file: &[u8], model: Model) -> Result<Vec<u8>, Unfit> {
    let mut bytes: Vec<Option<u8>> = Vec::new();
    let mut base = 0;
    let mut has_ended = false;
    for (index, line) in file.split(|&byte| byte == b'\n').enumerate() {
        let line = line.trim_ascii();
        if line.is_empty() {
            continue;
        }
        let number = index + 1;
        let not_hex = Unfit::NotHex { line: number };
        let text = str::from_utf8(line).map_err(|_| not_hex.clone())?;
        if has_ended {
            return Err(not_hex);
        }
        let record = Record::from_record_string(text).map_err(|error| match error {
            ReaderError::MissingStartCode
            | ReaderError::ContainsInvalidCharacters
            | ReaderError::UnsupportedRecordType { .. } => not_hex,
            _ => Unfit::Damaged { line: number },
        })?;
        match record {
            Record::Data { offset, value } => {
                let first = base + usize::from(offset);
                let end = first + value.len();
                // Other chips have memory there.
                if end > FARTHEST {
                    return Err(Unfit::OtherChip { model });
                }
                if bytes.len() < end {
                    bytes.resize(end, None);
                }
                for (address, value) in (first..).zip(value) {
                    if bytes[address].replace(value).is_some() {
                        return Err(Unfit::Twice { address });
                    }
                }
            }
            Record::EndOfFile => has_ended = true,
            Record::ExtendedSegmentAddress(segment) => base = usize::from(segment) << 4,
            Record::ExtendedLinearAddress(high) => base = usize::from(high) << 16,
            // Where a PC would begin; the chip begins at 0.
            Record::StartSegmentAddress { .. } | Record::StartLinearAddress(_) => {}
        }
    }
    if !has_ended {
        return Err(Unfit::CutShort);
    }
    let bytes = bytes.into_iter();
    Ok(bytes.map(|byte| byte.unwrap_or(ERASED)).collect())
}

/// Whether it begins with the interrupt vectors of this chip: so many jumps and no more. What is for another one that has
/// as many, as an ATmega168 has of those of an ATmega328P, is not told apart.
fn is_for(chip: &Chip, bytes: &[u8]) -> bool {
    let vectors = chip.vectors;
    let vector = |index: usize| bytes.get(index * VECTOR..(index + 1) * VECTOR);
    let jumps = |vector: &[u8]| {
        let word = u16::from_le_bytes([vector[0], vector[1]]);
        let (is_jmp, is_rjmp) = (word & 0xFE0E == 0x940C, word & 0xF000 == 0xC000);
        is_jmp || is_rjmp
    };
    let mut table = (0..vectors).map(vector);
    if !table.all(|vector| vector.is_some_and(jumps)) {
        return false;
    }
    // A longer table goes on with what unused vectors have in common.
    let goes_on = |index| (1..vectors).any(|own| vector(own) == vector(index));
    !(goes_on(vectors) && goes_on(vectors + 1))
}
