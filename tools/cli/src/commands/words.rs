//! The words of the command line for what the libraries know as types of their own.

use clap::ValueEnum;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use unoclp_boot::Model;

/// The boards, as --board names them.
pub fn models() -> impl TypedValueParser<Value = Model> {
    PossibleValuesParser::new(Model::ALL.map(Model::name))
        .map(|name| Model::named(&name).unwrap_or_default())
}

/// The parity bit of each byte on the line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Parity {
    /// No parity bit
    #[default]
    None,
    /// An even number of ones
    Even,
    /// An odd number of ones
    Odd,
}

impl From<Parity> for unoclp_client::Parity {
    fn from(word: Parity) -> unoclp_client::Parity {
        match word {
            Parity::None => unoclp_client::Parity::None,
            Parity::Even => unoclp_client::Parity::Even,
            Parity::Odd => unoclp_client::Parity::Odd,
        }
    }
}

/// What a board may refuse from everyone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Lock {
    /// Uploads
    Upload,
    /// Changes to the settings
    Settings,
    /// All commands except the one for an upload
    Commands,
    /// Writing coils, registers and presets, and forcing
    Writing,
    /// All of these
    All,
}

impl Lock {
    /// Bits of [`unoclp_client::lock`].
    pub fn bits(self) -> u8 {
        use unoclp_client::lock::{ALL, COMMANDS, SETTINGS, UPLOAD, WRITING};
        match self {
            Lock::Upload => UPLOAD,
            Lock::Settings => SETTINGS,
            Lock::Commands => COMMANDS,
            Lock::Writing => WRITING,
            Lock::All => ALL,
        }
    }
}

/// What a program is listed as.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Form {
    /// A ladder diagram
    #[default]
    Ladder,
    /// Instruction List, in the words of IEC 61131-3
    Il,
    /// Structured Text, which compiles to a program that does the same
    St,
    /// Numeric code, each line with its letters and its meaning
    Numeric,
    /// Its charts, as IEC 61131-3 draws them
    Sfc,
    /// Its charts, as GRAFCET (IEC 60848) draws them
    Grafcet,
    /// A function block diagram
    Fbd,
    /// A project in PLCopen XML, for OpenPLC Editor and others
    Xml,
    /// The same project, with its program in FBD
    XmlFbd,
}

impl Form {
    /// How its charts look; none where something else is listed.
    pub fn look(self) -> Option<unoclp_program::list::Look> {
        use unoclp_program::list::Look;
        match self {
            Form::Sfc => Some(Look::Norm),
            Form::Grafcet => Some(Look::Grafcet),
            _ => None,
        }
    }

    /// How it is listed; none where it is a file for others, or its charts are listed.
    pub fn listed(self) -> Option<unoclp_program::list::Form> {
        use unoclp_program::list::Form as Listed;
        match self {
            Form::Ladder => Some(Listed::Ladder),
            Form::Il => Some(Listed::Il),
            Form::St => Some(Listed::St),
            Form::Numeric => Some(Listed::Numeric),
            Form::Fbd => Some(Listed::Blocks),
            Form::Xml | Form::XmlFbd | Form::Sfc | Form::Grafcet => None,
        }
    }

    /// How its ladder is drawn in a project.
    pub fn body(self) -> unoclp_program::list::Body {
        match self {
            Form::XmlFbd => unoclp_program::list::Body::Blocks,
            _ => unoclp_program::list::Body::Ladder,
        }
    }
}

/// What a drawing is printed on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Paper {
    /// 210 × 297 mm
    A4,
    /// 8.5 × 11 inches
    Letter,
}

impl From<Paper> for unoclp_program::list::Paper {
    fn from(word: Paper) -> unoclp_program::list::Paper {
        match word {
            Paper::A4 => unoclp_program::list::Paper::A4,
            Paper::Letter => unoclp_program::list::Paper::Letter,
        }
    }
}
