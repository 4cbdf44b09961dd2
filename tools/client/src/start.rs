//! Finding the board at the other end of a line.

use crate::client::{Client, Failure};
use crate::identity::Identity;
use crate::map::VENDOR;
use crate::start_text::{QUIET, is_start_text};
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
