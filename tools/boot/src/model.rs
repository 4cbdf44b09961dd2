//! The boards that a firmware is written to.

/// Bytes of a page of the ATmega328P's flash (datasheet DS40002061, table 27-11).
pub(crate) const PAGE: usize = 128;
/// What an ATmega328P says that it is (table 28-7).
pub(crate) const SIGNATURE: [u8; 3] = [0x1E, 0x95, 0x0F];

/// A board: how fast its boot loader speaks, and what flash it leaves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Model {
    /// The Arduino UNO, with Optiboot.
    #[default]
    Uno,
    /// The Arduino Nano, with Optiboot.
    Nano,
    /// The Arduino Nano with the boot loader that it had until 2018.
    NanoOld,
    /// The Arduino Mega 2560. Its boot loader speaks another protocol, which this crate does not know yet.
    Mega,
}

impl Model {
    /// All that a firmware can be written to.
    pub const ALL: [Model; 3] = [Model::Uno, Model::Nano, Model::NanoOld];

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
}
