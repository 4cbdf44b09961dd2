//! `unoclp settings`.

use super::meet;
use super::words::Parity;
use crate::Outcome;
use anyhow::{Context, bail};
use clap::{Args, ValueEnum};
use unoclp_board::map::Command;
use unoclp_board::settings::{RATES, Settings};
use unoclp_board::upload::stop;
use unoclp_board::watch::Wish;
use unoclp_board::{Line, Patience};
use unoclp_cli::port::{Place, find};

/// What shall be set anew.
#[derive(Args)]
pub struct Changes {
    /// The address from the next start on
    #[arg(long, value_name = "1..247", value_parser = clap::value_parser!(u8).range(1..=247))]
    set_address: Option<u8>,
    /// The rate in baud from the next start on
    #[arg(long, value_name = "BAUD")]
    set_rate: Option<u32>,
    /// The parity from the next start on
    #[arg(long, value_enum, value_name = "PARITY")]
    set_parity: Option<Parity>,
    /// Whether A4 is the direction pin of an RS-485 driver
    #[arg(long, value_enum, value_name = "on|off")]
    set_direction: Option<Switch>,
}

/// On or off.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Switch {
    On,
    Off,
}

impl Changes {
    fn apply(&self, old: Settings) -> Settings {
        let direction = self.set_direction.map(|switch| switch == Switch::On);
        Settings {
            address: self.set_address.unwrap_or(old.address),
            rate: self.set_rate.unwrap_or(old.rate),
            parity: self.set_parity.map_or(old.parity, Into::into),
            direction: direction.unwrap_or(old.direction),
        }
    }
}

/// Shows the settings that a board keeps, and sets those that shall change; it restarts to use them.
pub fn settings(place: &Place, changes: &Changes) -> Outcome {
    if let Some(rate) = changes.set_rate
        && !RATES.contains(&rate)
    {
        let rates = RATES.map(|rate| rate.to_string()).join(", ");
        bail!("a board has no rate of {rate} baud; it has {rates}");
    }
    let mut port = meet(place)?;
    let old = port.talk(Settings::read)?;
    say!("{old}");
    let new = changes.apply(old);
    if new == old {
        return Ok(true);
    }
    port.talk(stop).context("the board cannot be stopped")?;
    port.talk(async |client| new.write(client).await)
        .context("the board does not take the settings")?;
    if port.talk(Settings::read)? != new {
        bail!("the board does not keep the settings: its EEPROM fails");
    }
    say!("{new}; restarting");
    let restart = Wish::Command(Command::Restart);
    port.talk(async |client| restart.fulfil(client).await)?;
    drop(port);
    let line = Line {
        address: new.address,
        rate: new.rate,
        parity: new.parity,
    };
    let port = place.port.clone();
    let patience = Patience::default();
    // It starts while it is sought.
    let attempts = patience.attempts + patience.start.as_secs() as u32;
    find(
        &Place { port, line },
        Patience {
            attempts,
            ..patience
        },
    )
    .context("the settings are kept, but the board does not answer with them")?;
    say!("it answers from {line}");
    Ok(true)
}
