//! Address, rate, parity and direction pin, as a board keeps them for its next start, and its lock.

use crate::client::{Client, Failure, if_there};
use crate::map::{Parity, Span, holding};

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
    /// What the board refuses from everyone: bits of [`lock`](crate::lock), which can only grow. None: its firmware
    /// has no lock.
    pub lock: Option<u8>,
}

/// The rates that a board meets well.
pub const RATES: [u32; 8] = [2400, 4800, 9600, 19200, 28800, 38400, 57600, 115_200];

/// The lock, which is the last of the settings.
const LOCK: Span = Span {
    first: holding::SETTINGS.end() - 1,
    values: 1,
    ..holding::SETTINGS
};

impl Settings {
    /// Reads them.
    ///
    /// # Errors
    /// [`Failure`]; [`Failure::Garbled`] too where they are none of this version.
    pub async fn read(client: &mut Client) -> Result<Settings, Failure> {
        let Span {
            table,
            first,
            values,
            ..
        } = holding::SETTINGS;
        let words = match if_there(client.words(table, first, values).await)? {
            Some(words) => words,
            None => client.words(table, first, LOCK.first - first).await?,
        };
        let &[address, rate, parity, direction, ref lock @ ..] = &words[..] else {
            return Err(Failure::Garbled);
        };
        let byte = |word| u8::try_from(word).map_err(|_| Failure::Garbled);
        Ok(Settings {
            address: byte(address)?,
            rate: u32::from(rate) * 100,
            parity: Parity::of(parity).ok_or(Failure::Garbled)?,
            direction: direction != 0,
            lock: lock.first().map(|&lock| byte(lock)).transpose()?,
        })
    }

    /// Writes them in place of these old ones: the lock holds at once, all else from the next start on. The board must
    /// not be in RUN.
    ///
    /// # Errors
    /// [`Failure`].
    pub async fn write(&self, old: Settings, client: &mut Client) -> Result<(), Failure> {
        let line = [
            self.address.into(),
            (self.rate / 100) as u16,
            self.parity as u16,
            self.direction.into(),
        ];
        let words: Vec<u16> = line.into_iter().chain(self.lock.map(u16::from)).collect();
        match client.set_words(holding::SETTINGS, &words).await {
            // They were taken, but the answer was lost, and their repetition meets their lock or one change too many.
            Err(Failure::Refused(_)) if *self != old && Settings::read(client).await? == *self => {
                Ok(())
            }
            other => other,
        }
    }

    /// Whether the board refuses what falls under this bit of [`lock`](crate::lock).
    pub fn locks(&self, bit: u8) -> bool {
        self.lock.unwrap_or(0) & bit != 0
    }

    /// The same without the lock: what is used from the next start on only.
    pub fn without_lock(self) -> Settings {
        Settings { lock: None, ..self }
    }
}

/// Reads the lock alone: bits of [`lock`](crate::lock), 0 where the board has none.
///
/// # Errors
/// [`Failure`].
pub async fn read_lock(client: &mut Client) -> Result<u8, Failure> {
    let word = client.words(LOCK.table, LOCK.first, LOCK.values).await;
    let word = if_there(word)?.and_then(|words| words.first().copied());
    u8::try_from(word.unwrap_or(0)).map_err(|_| Failure::Garbled)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_is_asked_bit_by_bit_and_can_be_left_out() {
        let of = |lock| Settings {
            address: 1,
            rate: 9600,
            parity: Parity::None,
            direction: false,
            lock,
        };
        for lock in [None, Some(0), Some(0b01), Some(0b10), Some(0b11)] {
            let settings = of(lock);
            for bit in [0b01, 0b10] {
                assert_eq!(
                    settings.locks(bit),
                    lock.unwrap_or(0) & bit == bit,
                    "{lock:?}"
                );
            }
            assert_eq!(settings.without_lock(), of(None));
        }
    }
}
