//! Changing the settings of a board: what stands against it is known before the board is stopped for it.

use crate::client::{Client, Failure};
use crate::event::{Again, Settled, Undone, Unsettled};
use crate::lock;
use crate::map::{Command, State};
use crate::settings::{RATES, Settings};
use crate::upload::stop;
use crate::watch::command;
use unoclp_modbus::Exception;

/// Has a board keep these settings in place of its own, and go on as before.
///
/// # Errors
/// [`Undone`].
pub async fn settle(client: &mut Client, new: Settings) -> Result<Settled, Undone> {
    let old = Settings::read(client).await?;
    may_settle(new, old)?;
    let ran = stop(client).await.map_err(Undone::NotStopped)?.state;
    let kept = keep(client, old, new).await;
    // It runs again, whatever came of this.
    let again = go_on(client, ran).await?;
    kept?;
    Ok(Settled {
        is_for_next: new.without_lock() != old.without_lock(),
        again,
    })
}

/// Has a board that is not in RUN keep these settings in place of the old ones, and sees that it does.
///
/// # Errors
/// [`Undone`].
pub async fn keep(client: &mut Client, old: Settings, new: Settings) -> Result<(), Undone> {
    new.write(old, client).await.map_err(Unsettled::NotTaken)?;
    match Settings::read(client).await? == new {
        true => Ok(()),
        false => Err(Unsettled::NotKept.into()),
    }
}

/// Puts a board back into RUN that was there before, as far as it lets.
///
/// # Errors
/// [`Failure`].
pub async fn go_on(client: &mut Client, before: Option<State>) -> Result<Again, Failure> {
    if before != Some(State::Run) {
        return Ok(Again::WasNot);
    }
    match command(client, Command::Run).await {
        Ok(()) => Ok(Again::Runs),
        Err(Failure::Refused(Exception::ServerDeviceFailure)) => Ok(Again::Held),
        Err(Failure::Refused(Exception::IllegalFunction)) => Ok(Again::Locked),
        Err(why) => Err(why),
    }
}

/// Whether a board that keeps the old settings may be asked to keep the new ones.
///
/// # Errors
/// Why not.
pub fn may_settle(new: Settings, old: Settings) -> Result<(), Unsettled> {
    let was = old.lock.unwrap_or(0);
    if !RATES.contains(&new.rate) {
        Err(Unsettled::Rate(new.rate))
    } else if new.lock.unwrap_or(0) & was != was {
        Err(Unsettled::LockShrinks)
    } else if old.locks(lock::SETTINGS) {
        Err(Unsettled::Locked)
    } else {
        Ok(())
    }
}
