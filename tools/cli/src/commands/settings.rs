//! `unoclp settings`.

use super::words::{Lock, Parity};
use super::{failed, meet};
use crate::messages;
use crate::outcome::Outcome;
use crate::port::{Place, Port, find};
use anyhow::{anyhow, bail};
use clap::{Args, ValueEnum};
use unoclp_client::diagnostics::Diagnostics;
use unoclp_client::event::{Again, Undone, Unsettled};
use unoclp_client::map::{Command, State};
use unoclp_client::settings::{RATES, Settings};
use unoclp_client::settle::{go_on, keep};
use unoclp_client::upload::stop;
use unoclp_client::watch::command;
use unoclp_client::{Line, Patience, lock};

/// What shall be set again.
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
    /// Whether A4 (D20 on a Mega) is the direction pin of an RS-485 driver
    #[arg(long, value_enum, value_name = "on|off")]
    set_direction: Option<Switch>,
    /// Also lock these functions, separated by commas; the board then refuses them to every client
    #[arg(long, value_enum, value_name = "WHAT", value_delimiter = ',')]
    lock: Vec<Lock>,
}

/// On or off.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Switch {
    On,
    Off,
}

impl Changes {
    /// What is to be set, if anything is.
    fn apply(&self, old: Settings) -> anyhow::Result<Option<Settings>> {
        let Changes {
            set_address,
            set_rate,
            set_parity,
            set_direction,
            lock,
        } = self;
        let is_any = set_address.is_some()
            || set_rate.is_some()
            || set_parity.is_some()
            || set_direction.is_some()
            || !lock.is_empty();
        if !lock.is_empty() && old.lock.is_none() {
            bail!(messages::no_lock());
        }
        // It can only grow.
        let lock = |old| lock.iter().fold(old, |bits, lock| bits | lock.bits());
        Ok(is_any.then(|| Settings {
            address: set_address.unwrap_or(old.address),
            rate: set_rate.unwrap_or(old.rate),
            parity: set_parity.map_or(old.parity, Into::into),
            direction: set_direction.map_or(old.direction, |switch| switch == Switch::On),
            lock: old.lock.map(lock),
        }))
    }
}

/// Shows the settings that a board keeps, and sets those that shall change; it restarts to use them.
pub fn settings(place: &Place, changes: &Changes) -> Outcome {
    if let Some(rate) = changes.set_rate
        && !RATES.contains(&rate)
    {
        bail!(messages::unsettled(&Unsettled::Rate(rate)));
    }
    let mut port = meet(place)?;
    let old = port.talk(Settings::read).map_err(failed)?;
    say!("{}", messages::settings(old));
    let Some(new) = changes.apply(old)? else {
        return Ok(true);
    };
    // Defaults that the pins have brought back are kept by writing them: they hold in STOP or FAULT.
    let is_new = new != old;
    if !is_new && port.talk(Diagnostics::read).map_err(failed)?.state == Some(State::Run) {
        return Ok(true);
    }
    if old.locks(lock::SETTINGS) {
        bail!(messages::unsettled(&Unsettled::Locked));
    }
    let before = port
        .talk(stop)
        .map_err(|why| undone(&Undone::NotStopped(why)))?;
    if let Err(why) = port.talk(async |client| keep(client, old, new).await) {
        // What stood in the way is told, whatever comes of this.
        let _ = go_back(&mut port, before.state);
        return Err(undone(&why));
    }
    if new.lock != old.lock {
        let what = messages::lock(new.lock.unwrap_or(0));
        say!("{}", messages::locked_now(what, messages::to_unlock()));
    } else if !is_new {
        say!("{}", messages::settings_kept());
    }
    if new.without_lock() == old.without_lock() {
        go_back(&mut port, before.state)?;
    } else if new.locks(lock::COMMANDS) {
        say!("{}", messages::settings(new));
        say!("{}", messages::reset_to_use());
    } else {
        restart(port, place, new)?;
    }
    Ok(true)
}

/// Puts a board back into RUN that was there before, as far as it lets.
fn go_back(port: &mut Port, before: Option<State>) -> anyhow::Result<()> {
    match port.talk(async |client| go_on(client, before).await) {
        Ok(Again::WasNot) => {}
        Ok(Again::Runs) => say!("RUN"),
        Ok(Again::Held) => say!("{}", messages::in_stop_until()),
        Ok(Again::Locked) => say!("{}", messages::reset_to_run()),
        Err(why) => return Err(failed(why)),
    }
    Ok(())
}

fn undone(why: &Undone) -> anyhow::Error {
    anyhow!(messages::undone(why))
}

/// Restarts the board, and meets it where it is then.
fn restart(mut port: Port, place: &Place, new: Settings) -> anyhow::Result<()> {
    say!("{}", messages::restarting(messages::settings(new)));
    port.talk(async |client| command(client, Command::Restart).await)
        .map_err(failed)?;
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
    .map_err(|why| anyhow!(messages::settings_without_answer(why)))?;
    say!("{}", messages::answers_from(messages::spoken_line(line)));
    Ok(())
}
