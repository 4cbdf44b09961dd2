//! The boards that a firmware is written to.

/// A board: how fast its boot loader speaks, which protocol, and what flash it leaves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Model {
    /// The Arduino UNO, with Optiboot.
    #[default]
    Uno,
    /// The Arduino Nano, with Optiboot.
    Nano,
    /// The Arduino Nano with the boot loader that it had until 2018.
    NanoOld,
    /// The Arduino Mega 2560, with the boot loader that it comes with.
    Mega,
}

/// The chip of a board, as its boot loader and a firmware show it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Chip {
    pub name: &'static str,
    /// The boards that have it.
    pub boards: &'static str,
    /// What it says that it is.
    pub signature: [u8; 3],
    /// Bytes of a page of its flash.
    pub page: usize,
    /// How many interrupt vectors it has, two words each.
    pub vectors: usize,
    /// Bytes of its flash.
    pub flash: usize,
    /// How its boot loader is spoken to.
    pub protocol: Protocol,
}

/// Who speaks how: STK500v1 (Atmel's AVR061) or STK500v2 (AVR068).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Protocol {
    V1,
    V2,
}

/// Datasheet DS40002061, section 12.1, tables 27-11 and 28-7.
const ATMEGA328P: Chip = Chip {
    name: "ATmega328P",
    boards: "UNO, Nano",
    signature: [0x1E, 0x95, 0x0F],
    page: 128,
    vectors: 26,
    flash: 0x8000,
    protocol: Protocol::V1,
};

/// Datasheet DS40002211, section 14.1, tables 30-6 and 30-8.
const ATMEGA2560: Chip = Chip {
    name: "ATmega2560",
    boards: "Mega 2560",
    signature: [0x1E, 0x98, 0x01],
    page: 256,
    vectors: 57,
    flash: 0x4_0000,
    protocol: Protocol::V2,
};

impl Model {
    /// All that a firmware can be written to.
    pub const ALL: [Model; 4] = [Model::Uno, Model::Nano, Model::NanoOld, Model::Mega];

    /// As the command line names it.
    pub const fn name(self) -> &'static str {
        match self {
            Model::Uno => "uno",
            Model::Nano => "nano",
            Model::NanoOld => "nano-old",
            Model::Mega => "mega",
        }
    }

    /// That of this name.
    pub fn named(name: &str) -> Option<Model> {
        Model::ALL.into_iter().find(|model| model.name() == name)
    }

    /// The board whose firmware it takes.
    pub const fn firmware(self) -> Model {
        match self {
            Model::Uno => Model::Uno,
            Model::Nano | Model::NanoOld => Model::Nano,
            Model::Mega => Model::Mega,
        }
    }

    /// Bits per second that its boot loader speaks.
    pub const fn rate(self) -> u32 {
        match self {
            Model::Uno | Model::Nano | Model::Mega => 115_200,
            Model::NanoOld => 57_600,
        }
    }

    /// Bytes of flash before the boot loader. A Nano keeps 2 KB for it, whichever it has (`boards.txt` of the Arduino
    /// core).
    pub const fn room(self) -> usize {
        match self {
            Model::Uno => 32_256,
            Model::Nano | Model::NanoOld => 30_720,
            Model::Mega => 253_952,
        }
    }

    pub(crate) const fn chip(self) -> &'static Chip {
        match self {
            Model::Uno | Model::Nano | Model::NanoOld => &ATMEGA328P,
            Model::Mega => &ATMEGA2560,
        }
    }
}
