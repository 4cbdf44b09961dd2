//! Reading the program back that a board keeps.

use super::desk::Desk;
use super::news::News;
use super::undone::Undone;
use crate::words::{self, Both, both};
use unoclp_client::download::{Unread, download};
use unoclp_client::{AT_A_LINE, Client};

/// Reads it, and gives it to the page as numeric code.
pub(super) async fn fetch(
    client: &mut Client,
    desk: &Desk,
    order: u32,
) -> Result<Option<Both>, Undone> {
    let code = download(client, AT_A_LINE).await;
    let code = code.map_err(|unread| match unread {
        Unread::Empty => both(words::unread_empty).into(),
        Unread::Untold => both(words::unread_untold).into(),
        Unread::Other => both(words::unread_other).into(),
        Unread::Failed(failure) => Undone::from(failure),
    })?;
    desk.tell(News::Fetched { order, code });
    Ok(None)
}
