//! Settings that a person wants, looked at before a board is asked.

use crate::given::Given;
use crate::words::{self, Both, both};
use unoclp_client::map::{Parity, setting};
use unoclp_client::settings::{RATES, Settings};

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
    pub(super) fn checked(&self, old: Settings) -> Result<Settings, Both> {
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
