//! Finding the board that shall be at a port.

use crate::client::{Client, Failure, Patience};
use crate::identity::Identity;
use crate::port::{Line, NotOpened};
use std::time::{Duration, Instant};
use unoclp_modbus::Exception;

/// A board that has answered.
pub struct Found {
    /// How to speak to it.
    pub client: Client,
    /// What it says that it is.
    pub identity: Identity,
    /// Opening the port has probably reset it.
    pub may_be_reset: bool,
}

/// Why there is no board to speak to.
#[derive(Debug, thiserror::Error)]
pub enum NotFound {
    /// The port cannot be used.
    #[error(transparent)]
    Port(#[from] NotOpened),
    /// Nobody answers.
    #[error(
        "no answer from {line}, on {}; is the board powered and wired, and are these its settings? \
         Another address or rate is given by --address and --rate; A5 and 01 to 04 closed at reset \
         bring the defaults back", line.port
    )]
    Silent {
        /// Where it was sought.
        line: Line,
    },
    /// Something else comes than answers.
    #[error(
        "what comes from {} is no Modbus at {} baud, {}; is that the board's rate (--rate, --parity)?",
        line.port, line.rate, line.parity
    )]
    Garbled {
        /// Where it was sought.
        line: Line,
    },
    /// Something else answers.
    #[error("what answers at {} is no unoclp{said}", line.port)]
    Foreign {
        /// Where it was sought.
        line: Line,
        /// What it says that it is.
        said: String,
    },
    /// The port has gone.
    #[error("{}: {failure}", line.port)]
    Failed {
        /// Where it was sought.
        line: Line,
        /// What has happened.
        failure: Failure,
    },
}

/// Silence after which a board is taken for one that has no boot text to say.
const QUIET: Duration = Duration::from_millis(2500);

/// Opens the port and finds the board. A board that this has reset is given the time to start.
///
/// # Errors
/// [`NotFound`].
pub fn find(line: &Line, patience: Patience) -> Result<Found, NotFound> {
    let begun = Instant::now();
    let (mut client, may_be_reset) = Client::open(line, patience)?;
    let failed = |failure| NotFound::Failed {
        line: line.clone(),
        failure,
    };
    if may_be_reset {
        // A request would disturb the boot loader, which speaks another language.
        let quiet = QUIET.min(patience.start);
        client.listen(quiet, is_start_text).map_err(failed)?;
    }
    let identity = loop {
        match client.identify() {
            Err(Failure::Silent | Failure::Garbled)
                if may_be_reset && begun.elapsed() < patience.start => {}
            other => break other,
        }
    };
    let line = line.clone();
    let identity = match identity {
        Ok(identity) => identity,
        Err(Failure::Silent) => return Err(NotFound::Silent { line }),
        Err(Failure::Garbled) => return Err(NotFound::Garbled { line }),
        Err(Failure::Refused(Exception::IllegalFunction)) => {
            let said = String::new();
            return Err(NotFound::Foreign { line, said });
        }
        Err(failure) => return Err(NotFound::Failed { line, failure }),
    };
    if identity.vendor != "unoclp" {
        let said = format!(" but \"{} {identity}\"", identity.vendor);
        return Err(NotFound::Foreign { line, said });
    }
    Ok(Found {
        client,
        identity,
        may_be_reset,
    })
}

/// Whether this is all that a board says when it starts: it ends with `RUN`, `STOP` or a fault.
fn is_start_text(said: &[u8]) -> bool {
    let Some(lines) = said.strip_suffix(b"\r\n") else {
        return false;
    };
    let last = lines.rsplit(|&byte| byte == b'\n').next();
    last.is_some_and(|last| last == b"RUN" || last == b"STOP" || last.starts_with(b"fault "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_start_text_ends_with_what_the_board_does() {
        for all in [
            "\r\nunoclp 0.1.0\r\n4 codes\r\nRUN\r\n",
            "STOP\r\n",
            "x\r\nfault 51: no card\r\n",
        ] {
            assert!(is_start_text(all.as_bytes()), "{all:?}");
            let part = &all.as_bytes()[..all.len() - 1];
            assert!(!is_start_text(part), "{all:?}");
        }
        for part in ["", "\r\n", "RUN", "RUN\r\nx\r\n", "unoclp 0.1.0\r\n"] {
            assert!(!is_start_text(part.as_bytes()), "{part:?}");
        }
    }
}
