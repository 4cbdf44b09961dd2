//! What the commands do that are more than a few lines.
//!
//! - `open`: reading a program in either language, and `unoclp check`
//! - `compile`, `card`: from Instruction List to numeric code, and onto a card
//! - `monitor`, `settings`, `upload`: the commands that speak to a board

mod card;
mod compile;
mod monitor;
mod open;
mod settings;
mod upload;
mod words;

pub use card::card;
pub use compile::compile;
pub use monitor::monitor;
pub use open::{Il, Shown, check, open};
pub use settings::{Changes, settings};
pub use upload::upload;
pub use words::Form;

use anstream::println;
use clap::Args;
use unoclp_board::diagnostics::Diagnostics;
use unoclp_board::start::{Found, find};
use unoclp_board::{Line, Patience};
use words::Parity;

/// Where the board is.
#[derive(Args)]
pub struct At {
    /// The serial port: /dev/ttyACM0, /dev/ttyUSB0, COM3 …
    #[arg(long)]
    port: String,
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
    /// How to speak to it.
    pub fn line(self) -> Line {
        Line {
            port: self.port,
            address: self.address,
            rate: self.rate,
            parity: self.parity.into(),
        }
    }
}

/// Finds the board and says so; and whether opening the port has reset it.
fn meet(line: &Line) -> anyhow::Result<Found> {
    let patience = Patience::default();
    let mut found = find(line, patience)?;
    println!(
        "{} at {}, address {}",
        found.identity, line.port, line.address
    );
    if found.may_be_reset {
        let uptime = Diagnostics::read(&mut found.client)?.uptime;
        if u128::from(uptime) < patience.start.as_millis() {
            println!("opening the port has reset the board; the next time it will not");
        }
    }
    Ok(found)
}
