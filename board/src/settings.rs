//! Address, rate, parity and direction pin, as a board keeps them for its next start.

use crate::client::{Client, Failure};
use crate::map::{Parity, holding};
use std::fmt;

/// What is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// 1 to 247.
    pub address: u8,
    /// Bits per second: one of [`RATES`], if others are to meet it.
    pub rate: u32,
    /// The parity.
    pub parity: Parity,
    /// Whether A4 is HIGH while a reply is sent.
    pub direction: bool,
}

/// The rates that a board meets well.
pub const RATES: [u32; 8] = [2400, 4800, 9600, 19200, 28800, 38400, 57600, 115_200];

impl fmt::Display for Settings {
    /// `address 1, 115200 baud, no parity, direction pin off`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Settings {
            address,
            rate,
            parity,
            direction,
        } = self;
        let direction = if *direction { "on" } else { "off" };
        write!(
            f,
            "address {address}, {rate} baud, {parity}, direction pin {direction}"
        )
    }
}

impl Settings {
    /// Reads them.
    ///
    /// # Errors
    /// [`Failure`]; [`Failure::Garbled`] too where they are none of this version.
    pub async fn read(client: &mut Client) -> Result<Settings, Failure> {
        let span = holding::SETTINGS;
        let words = client.words(span.table, span.first, span.values).await?;
        let &[address, rate, parity, direction] = &words[..] else {
            return Err(Failure::Garbled);
        };
        Ok(Settings {
            address: u8::try_from(address).map_err(|_| Failure::Garbled)?,
            rate: u32::from(rate) * 100,
            parity: Parity::of(parity).ok_or(Failure::Garbled)?,
            direction: direction != 0,
        })
    }

    /// Writes them, for the next start. The board must not be in RUN.
    ///
    /// # Errors
    /// [`Failure`].
    pub async fn write(&self, client: &mut Client) -> Result<(), Failure> {
        let words = [
            self.address.into(),
            (self.rate / 100) as u16,
            self.parity as u16,
            self.direction.into(),
        ];
        client.set_words(holding::SETTINGS, &words).await
    }
}
