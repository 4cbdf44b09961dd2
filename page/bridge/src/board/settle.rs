//! Changing the settings of a board: what a person wants is looked at first, and what is refused is named.

use super::desk::Desk;
use super::news::News;
use super::undone::Undone;
use super::wanted::Wanted;
use crate::words::{self, Both, both};
use unoclp_client::map::{Command, State};
use unoclp_client::settings::Settings;
use unoclp_client::upload::stop;
use unoclp_client::watch::Wish;
use unoclp_client::{Client, Failure, lock};
use unoclp_modbus::Exception;

/// Has the board keep what is wanted, and tells the page what it keeps then. A board in RUN is stopped meanwhile.
pub(super) async fn settle(
    client: &mut Client,
    desk: &Desk,
    wanted: Wanted,
) -> Result<Option<Both>, Undone> {
    let old = Settings::read(client).await?;
    let new = wanted.checked(old)?;
    if old.locks(lock::SETTINGS) {
        return Err(both(words::settings_locked).into());
    }
    let ran = stop(client).await?.state == Some(State::Run);
    let kept = keep(client, old, new).await;
    // It runs again, whatever came of this.
    let runs = !ran || run(client).await?;
    let kept = kept?;
    desk.tell(News::Settings(kept.into()));
    Ok(Some(both(|lang| {
        let said = if new.without_lock() == old.without_lock() {
            words::settings_kept(lang)
        } else {
            words::settings_next(lang)
        };
        if runs {
            said
        } else {
            words::but_stop(lang, said)
        }
    })))
}

/// Writes them, and sees that they are kept.
async fn keep(client: &mut Client, old: Settings, new: Settings) -> Result<Settings, Undone> {
    new.write(old, client).await?;
    let kept = Settings::read(client).await?;
    match kept == new {
        true => Ok(kept),
        false => Err(both(words::settings_not_kept).into()),
    }
}

/// Whether the board is in RUN again: its switch, a fault or its lock may be against it.
async fn run(client: &mut Client) -> Result<bool, Failure> {
    match Wish::Command(Command::Run).fulfil(client).await {
        Ok(()) => Ok(true),
        Err(Failure::Refused(Exception::ServerDeviceFailure | Exception::IllegalFunction)) => {
            Ok(false)
        }
        Err(why) => Err(why),
    }
}
