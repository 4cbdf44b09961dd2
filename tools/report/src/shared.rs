//! How it stands with a broker, and who hears of it.

use crate::command::{Refusal, Wish};
use std::io;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Has a wish done, and hears what has become of it.
pub type Carry = Arc<dyn Fn(Wish, Box<dyn FnOnce(Result<(), Refusal>) + Send>) + Send + Sync>;

/// Hears when a broker is there, and why it is not. `None`: it is there.
pub type Tell = Arc<dyn Fn(Option<&Trouble>) + Send + Sync>;

/// Why a broker is not there.
#[derive(Debug)]
pub enum Trouble {
    /// The system says so.
    Io(io::Error),
    /// It does not show a certificate that is trusted.
    Tls(String),
    /// User or password are not right.
    NotAllowed,
    /// It takes no connection.
    Refused,
    /// It does not answer.
    Slow,
    /// It has ended the connection.
    Closed,
    /// What the client says.
    Other(String),
}

/// Why nothing can be reported at all.
#[derive(Debug)]
pub enum Unready {
    /// The file of the certificate has none.
    NoCertificate,
    /// The system trusts no certificate.
    NoTrust,
    /// The system refuses a thread, or random bytes.
    System(io::Error),
}

/// How it stands with the broker.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct State {
    /// Connections that there are.
    pub connected: u64,
    /// Connections that there should be.
    pub wanted: u64,
    /// Samples that wait.
    pub waiting: u64,
    /// Samples that were given up.
    pub dropped: u64,
}

/// What a connection tells of itself.
#[derive(Default)]
pub(crate) struct Shared {
    /// Whether there is a connection, and how many samples were given up.
    now: Mutex<(bool, u64)>,
    tell: Option<Tell>,
    /// Whether the trouble has been told.
    told: Mutex<Option<bool>>,
}

impl Shared {
    pub fn new(tell: Option<Tell>) -> Shared {
        Shared {
            tell,
            ..Shared::default()
        }
    }

    /// Whether there is a connection, and how many samples were given up.
    pub fn now(&self) -> (bool, u64) {
        *lock(&self.now)
    }

    pub fn connected(&self, is_connected: bool) {
        lock(&self.now).0 = is_connected;
        if is_connected && lock(&self.told).replace(true) != Some(true) {
            self.say(None);
        }
    }

    pub fn dropped(&self, dropped: u64) {
        lock(&self.now).1 = dropped;
    }

    /// Tells it once, until the broker is there again.
    pub fn trouble(&self, why: Trouble) {
        if lock(&self.told).replace(false) != Some(false) {
            self.say(Some(&why));
        }
    }

    fn say(&self, why: Option<&Trouble>) {
        if let Some(tell) = &self.tell {
            tell(why);
        }
    }
}

fn lock<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}
