//! Why a firmware is not on a board.

use crate::model::Model;
use crate::stage::Stage;
use crate::words;
use unoclp_words::Lang;

/// Why a file is no image for a board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// A line is no record of Intel HEX.
    NotHex {
        /// Counted from 1.
        line: usize,
    },
    /// A record is cut, or its checksum is wrong.
    Damaged {
        /// Counted from 1.
        line: usize,
    },
    /// The record that ends a file is missing.
    CutShort,
    /// Two records fill the same byte.
    Twice {
        /// Its address.
        address: usize,
    },
    /// It is for another chip.
    OtherChip {
        /// The board whose chip it was to be for.
        model: Model,
    },
    /// It does not fit.
    TooLarge {
        /// Its size.
        bytes: usize,
        /// The board that it was to fit.
        model: Model,
    },
}

impl Unfit {
    /// The stable number.
    pub const fn number(&self) -> u8 {
        match self {
            Unfit::NotHex { .. } => 11,
            Unfit::Damaged { .. } => 12,
            Unfit::CutShort => 13,
            Unfit::Twice { .. } => 14,
            Unfit::OtherChip { .. } => 15,
            Unfit::TooLarge { .. } => 16,
        }
    }

    /// What is wrong, and what to do: `FW-12: …`
    pub fn text(&self, lang: Lang) -> String {
        let text = match self {
            Unfit::NotHex { line } => words::not_hex(lang, line),
            Unfit::Damaged { line } => words::damaged(lang, line),
            Unfit::CutShort => words::cut_short(lang),
            Unfit::Twice { address } => words::twice(lang, hex(*address)),
            Unfit::OtherChip { model } => {
                let chip = model.chip();
                words::other_chip(lang, chip.name, chip.boards, model.firmware().name())
            }
            Unfit::TooLarge { bytes, model } => {
                words::too_large(lang, bytes, model.room(), model.name())
            }
        };
        numbered(self.number(), text)
    }
}

/// What has gone wrong at the board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Trouble {
    /// No boot loader answers; nothing comes at all.
    Silent,
    /// Something comes, but no answer of a boot loader.
    Foreign,
    /// It is another chip.
    OtherChip {
        /// What it says that it is.
        signature: [u8; 3],
        /// The board that it was to be.
        model: Model,
    },
    /// An answer has not come, or not all of it.
    BrokenOff,
    /// What came was no answer.
    Garbled,
    /// The flash holds something else than what was written.
    Differs {
        /// The first address that does.
        address: u32,
        /// What was written.
        written: u8,
        /// What is read.
        read: u8,
    },
    /// The port is gone, and why.
    Lost(String),
}

/// Why an image is not on a board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// What has gone wrong.
    pub trouble: Trouble,
    /// While this was done. Behind [`Stage::Meeting`] the board has lost the firmware that it had.
    pub stage: Stage,
}

impl Failure {
    /// The stable number.
    pub const fn number(&self) -> u8 {
        match self.trouble {
            Trouble::Silent => 21,
            Trouble::Foreign => 22,
            Trouble::OtherChip { .. } => 23,
            Trouble::BrokenOff => 24,
            Trouble::Garbled => 25,
            Trouble::Differs { .. } => 26,
            Trouble::Lost(_) => 27,
        }
    }

    /// What is wrong, what the board holds now, and what to do: `FW-21: …`
    pub fn text(&self, lang: Lang) -> String {
        let text = match &self.trouble {
            Trouble::Silent => words::silent(lang, models()),
            Trouble::Foreign => words::foreign(lang, models()),
            Trouble::OtherChip { signature, model } => {
                let [is, wanted] = [*signature, model.chip().signature]
                    .map(|[a, b, c]| format!("{a:02X} {b:02X} {c:02X}"));
                words::says_other_chip(lang, is, model.chip().name, wanted)
            }
            Trouble::BrokenOff => words::broken_off(lang),
            Trouble::Garbled => words::garbled(lang),
            Trouble::Differs {
                address,
                written,
                read,
            } => {
                let [written, read] = [written, read].map(|byte| format!("{byte:02X}"));
                words::differs(lang, hex(*address as usize), written, read)
            }
            Trouble::Lost(why) => words::lost(lang, why),
        };
        let left = left(self.stage, lang);
        numbered(self.number(), format!("{text}. {left}"))
    }
}

/// The boards that there are, as one is named.
fn models() -> String {
    Model::ALL.map(Model::name).join(", ")
}

/// What a board holds where writing has ended in this stage.
pub(crate) fn left(stage: Stage, lang: Lang) -> String {
    match stage {
        Stage::Meeting => words::untouched(lang),
        Stage::Writing | Stage::Comparing | Stage::Finishing => words::without_firmware(lang),
    }
}

fn hex(address: usize) -> String {
    format!("0x{address:04X}")
}

fn numbered(number: u8, text: String) -> String {
    format!("FW-{number}: {text}")
}
