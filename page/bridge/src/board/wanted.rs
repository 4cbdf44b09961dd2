//! Settings that a person wants, looked at before a board is asked.

use crate::ask::Field;
use crate::given::Given;
use crate::words::{self, Both, both};
use unoclp_client::map::{Parity, setting};
use unoclp_client::settings::Settings;
use unoclp_client::words as told;

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

impl Field for Wanted {
    const TYPE: &'static str = "Settings";

    fn read(given: &mut Given, key: &str) -> Result<Wanted, Both> {
        let mut given = given.below(key)?;
        Ok(Wanted {
            address: given.real("address")?,
            rate: given.number("rate")?,
            parity: given.number("parity")?,
            direction: given.truth("direction")?,
            lock: given.number_if("lock")?,
        })
    }
}

impl Wanted {
    /// What the board is asked to keep. What it says to that is the client's.
    ///
    /// # Errors
    /// What is none of its settings at all, by name.
    pub(super) fn checked(&self) -> Result<Settings, Both> {
        let (least, most) = (setting::ADDRESS.least, setting::ADDRESS.most);
        let address = self.address;
        let is_address =
            address.fract() == 0.0 && (f64::from(least)..=f64::from(most)).contains(&address);
        if !is_address {
            return Err(both(|lang| words::no_address(lang, address, least, most)));
        }
        let parity = Parity::of(self.parity).ok_or_else(|| both(told::refused_value))?;
        Ok(Settings {
            address: address as u8,
            rate: self.rate,
            parity,
            direction: self.direction,
            lock: self.lock,
        })
    }
}
