//! The commands that are longer than a few lines.
//!
//! - `open`: reading a program in any of the languages, and `unoclp check`; `wording`: the options for it
//! - `output`: files that are written, and what is not overwritten
//! - `adapt`: a text of another PLC with its points on this board
//! - `compile`, `card`: from a text to numeric code, and onto a card
//! - `units`: what a project is made of
//! - `list`, `sim`: a program shown, and simulated
//! - `plant`: a machine alone, and one that a program controls
//! - `grade`: the programs of a class in an exercise
//! - `mutants`: which mistakes an exercise lets pass
//! - `help`, `refuse`: the help, and what is wrong with the arguments, in Portuguese
//! - `interrupt`, `progress`: Ctrl-C; a line that changes
//! - `run`: a program on this PC, and its variables
//! - `monitor`, `settings`, `upload`: the commands that speak to a board
//! - `flash`: the firmware of a board
//! - `serve`, `site`: the page, and the boards behind it
//! - `lsp`: editors

/// Says a line, if anybody reads it: a board is not left half done because nobody does.
macro_rules! say {
    ($($part:tt)*) => {{
        use std::io::Write;
        let _ = writeln!(anstream::stdout(), $($part)*);
    }};
}

mod adapt;
mod card;
mod compile;
mod excerpt;
mod flash;
mod grade;
mod help;
mod interrupt;
mod list;
mod lsp;
mod monitor;
mod mutants;
mod open;
mod output;
mod plant;
mod progress;
mod refuse;
mod run;
mod serve;
mod settings;
mod sim;
mod site;
mod units;
mod upload;
mod wording;
mod words;

pub use adapt::adapt;
pub use card::card;
pub use compile::compile;
pub use flash::{Firmware, flash};
pub use grade::{Class, grade};
pub use help::{in_portuguese, naming_languages};
pub use list::{Picture, list};
pub use lsp::lsp;
pub use monitor::monitor;
pub use mutants::find_mutants;
pub use open::check;
pub use output::Over;
pub use plant::{Machine, OfPlant, drive, plant};
pub use refuse::refuse;
pub use run::{What, run};
pub use serve::{Doors, serve};
pub use settings::{Changes, settings};
pub use sim::{Run, scenario, simulate};
pub use site::{OfSite, site};
pub use units::units;
pub use upload::{Leave, upload};
pub use wording::{Wording, boards, langs, language};
pub use words::{Form, Paper};

use crate::messages;
use crate::port::{Found, Place, Port, find};
use anyhow::anyhow;
use clap::Args;
use unoclp_client::diagnostics::Diagnostics;
use unoclp_client::{Failure, Line, Patience};
use words::Parity;

/// Where the board is.
#[derive(Args)]
pub struct At {
    /// The serial port: /dev/ttyACM0, /dev/ttyUSB0, COM3 …
    #[arg(long)]
    port: String,
    #[command(flatten)]
    spoken: Spoken,
}

/// How a board is spoken to.
#[derive(Args)]
pub struct Spoken {
    /// The board's address
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=247))]
    address: u8,
    /// The board's rate in baud
    #[arg(long, default_value_t = 115_200, value_parser = clap::value_parser!(u32).range(2400..=115_200))]
    rate: u32,
    /// The board's parity
    #[arg(long, value_enum, default_value_t)]
    parity: Parity,
}

impl At {
    /// Where it is, and how it is spoken to.
    pub fn place(self) -> Place {
        self.spoken.at(self.port)
    }
}

impl Spoken {
    /// The board at this port.
    fn at(self, port: String) -> Place {
        let line = Line {
            address: self.address,
            rate: self.rate,
            parity: self.parity.into(),
        };
        Place { port, line }
    }
}

/// Finds the board, and says so, and whether opening the port has reset it.
fn meet(place: &Place) -> anyhow::Result<Port> {
    let patience = Patience::default();
    let Found {
        mut port,
        identity,
        may_be_reset,
    } = find(place, patience)?;
    let Place { port: name, line } = place;
    say!("{}", messages::met(identity, name, line.address));
    if may_be_reset {
        let uptime = port.talk(Diagnostics::read).map_err(failed)?.uptime;
        if u128::from(uptime) < patience.start.as_millis() {
            say!("{}", messages::was_reset());
        }
    }
    Ok(port)
}

/// The error of a request without result.
fn failed(failure: Failure) -> anyhow::Error {
    anyhow!(messages::failure(&failure))
}
