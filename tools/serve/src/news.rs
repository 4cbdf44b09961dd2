//! What there is to tell of the boards, to whoever operates the gateway.

use crate::gateway::{Gateway, kept_by};
use std::sync::Arc;
use std::time::Duration;
use tokio::time::timeout;
use unoclp_client::diagnostics::Kept;

/// How often a board is asked which program it keeps.
const AGAIN: Duration = Duration::from_secs(10);

/// What has become of a board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum News {
    /// It is there.
    Found,
    /// It is away, and why.
    Away(String),
    /// It keeps another program than the site says: names of that program do not hold.
    OtherProgram,
    /// It keeps the program that the site says.
    Program,
}

/// Takes the news of the board of a name.
pub type Tell = Arc<dyn Fn(&str, News) + Send + Sync>;

/// Tells what changes, forever.
pub(crate) async fn attend(gateway: Arc<Gateway>, program: Option<Kept>, tell: Tell) {
    let tell = |news| tell(&gateway.name, news);
    let mut presence = gateway.line.presence();
    let mut told = None;
    let mut keeps = None;
    loop {
        let now = presence.borrow_and_update().clone();
        // Nothing is known yet before the board was looked for.
        if told.as_ref() != Some(&now) && now != Err(String::new()) {
            match &now {
                Ok(()) => tell(News::Found),
                Err(why) => tell(News::Away(why.clone())),
            }
            told = Some(now.clone());
        }
        if let (Ok(()), Some(program)) = (&now, program)
            && let Ok(kept) = kept_by(&gateway).await
        {
            let is_same = kept == program;
            if keeps != Some(is_same) {
                tell(if is_same {
                    News::Program
                } else {
                    News::OtherProgram
                });
                keeps = Some(is_same);
            }
        }
        if let Ok(Err(_)) = timeout(AGAIN, presence.changed()).await {
            return;
        }
    }
}
