//! Finding the board at the other end of a line.

use crate::client::{Client, Failure};
use crate::identity::Identity;
use crate::map::VENDOR;
use std::time::Duration;
use unoclp_modbus::Exception;

/// Why there is no board to speak to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotFound {
    /// Nobody answers.
    Silent,
    /// Something else comes than answers.
    Garbled,
    /// Something else answers; with what it says that it is, if it says so.
    Foreign(Option<Identity>),
    /// It is not to be found out.
    Failed(Failure),
}

/// Silence after which a board is taken for one that has no boot text to say.
pub(crate) const QUIET: Duration = Duration::from_millis(2500);

/// Finds the board. One that has probably been reset as the port was opened is given the time to start.
///
/// # Errors
/// [`NotFound`].
pub async fn find(client: &mut Client, may_be_reset: bool) -> Result<Identity, NotFound> {
    let patience = client.patience().start;
    let begun = client.now();
    if may_be_reset {
        // A request would disturb the boot loader, which speaks another language.
        let said = client.listen(QUIET.min(patience), is_start_text).await;
        said.map_err(NotFound::Failed)?;
    }
    let identity = loop {
        match client.identify().await {
            Err(Failure::Silent | Failure::Garbled)
                if may_be_reset && client.now() - begun < patience => {}
            other => break other,
        }
    };
    judged(identity)
}

/// Who is there, by the answer to the question what it is.
///
/// # Errors
/// [`NotFound`].
pub fn judged(identity: Result<Identity, Failure>) -> Result<Identity, NotFound> {
    match identity {
        Ok(identity) if identity.vendor == VENDOR => Ok(identity),
        Ok(identity) => Err(NotFound::Foreign(Some(identity))),
        Err(Failure::Silent) => Err(NotFound::Silent),
        Err(Failure::Garbled) => Err(NotFound::Garbled),
        Err(Failure::Refused(Exception::IllegalFunction)) => Err(NotFound::Foreign(None)),
        Err(failure) => Err(NotFound::Failed(failure)),
    }
}

/// Whether this is all that a board says when it starts: it ends with `RUN`, `STOP` or a fault.
pub(crate) fn is_start_text(said: &[u8]) -> bool {
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
