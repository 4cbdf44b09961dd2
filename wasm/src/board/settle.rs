//! Changing the settings of a board: what a person wants is looked at first, and what is refused is named.

use super::desk::Desk;
use super::fulfil::Undone;
use super::news::News;
use crate::given::Given;
use crate::words::{self, Both, both};
use unoclp_board::map::{Command, Parity, State, setting};
use unoclp_board::settings::{RATES, Settings};
use unoclp_board::upload::stop;
use unoclp_board::watch::Wish;
use unoclp_board::{Client, Failure, lock};
use unoclp_modbus::Exception;

/// Settings as a person has typed them.
#[derive(Debug)]
pub struct Wanted {
    address: f64,
    rate: u32,
    /// 0 none, 1 even, 2 odd.
    parity: u16,
    direction: bool,
    /// All that shall be locked; none: the board has no lock.
    lock: Option<u8>,
}

impl Wanted {
    /// As a request gives them.
    ///
    /// # Errors
    /// Where one is missing, or of another kind.
    pub fn of(given: &mut Given) -> Result<Wanted, Both> {
        Ok(Wanted {
            address: given.real("address")?,
            rate: given.number("rate")?,
            parity: given.number("parity")?,
            direction: given.truth("direction")?,
            lock: given.number_if("lock")?,
        })
    }

    /// What the board is asked to keep.
    ///
    /// # Errors
    /// What it would not take, by name.
    fn checked(&self, old: Settings) -> Result<Settings, Both> {
        let (least, most) = (setting::ADDRESS.least, setting::ADDRESS.most);
        let address = self.address;
        let is_address =
            address.fract() == 0.0 && (f64::from(least)..=f64::from(most)).contains(&address);
        if !is_address {
            return Err(both(|lang| words::no_address(lang, address, least, most)));
        }
        if !RATES.contains(&self.rate) {
            let rates = RATES.map(|rate| rate.to_string()).join(", ");
            return Err(both(|lang| words::no_rate(lang, self.rate, &rates)));
        }
        let parity = Parity::of(self.parity).ok_or_else(|| both(words::refused_value))?;
        let was = old.lock.unwrap_or(0);
        if self.lock.unwrap_or(0) & was != was {
            return Err(both(words::lock_grows));
        }
        Ok(Settings {
            address: address as u8,
            rate: self.rate,
            parity,
            direction: self.direction,
            lock: self.lock,
        })
    }
}

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
