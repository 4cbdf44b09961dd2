//! How what is ordered of a board is done.

use super::desk::Desk;
use super::news::{Kept, News};
use super::order::Order;
#[cfg(feature = "full")]
use super::settle::settle;
use super::undone::Undone;
use super::watched::Watched;
use crate::program::source;
use crate::words::{self, Both, both, told};
use unoclp_client::Client;
use unoclp_client::map::{Command, State};
use unoclp_client::point;
use unoclp_client::settings::Settings;
use unoclp_client::upload::{Broken, Pass, Progress, go_on, needs, stop, upload_program};
use unoclp_client::watch::{Side, Wish};
use unoclp_lang::no_such_point;
use unoclp_point::Address;
use unoclp_program::{Lang, not_sent};
use unoclp_workspace::Analysis;

/// Does what is ordered; gives what there is to say after it.
pub(super) async fn fulfil(
    client: &mut Client,
    desk: &Desk,
    number: u32,
    order: Order,
) -> Result<Option<Both>, Undone> {
    match order {
        Order::Run => wish(client, Wish::Command(Command::Run)).await,
        Order::Stop => wish(client, Wish::Command(Command::Stop)).await,
        Order::Scan => wish(client, Wish::Command(Command::SingleScan)).await,
        Order::Restart => wish(client, Wish::Command(Command::Restart)).await,
        Order::Release => wish(client, Wish::Release).await,
        Order::Force { output, number, to } => {
            let side = if output { Side::Outputs } else { Side::Inputs };
            wish(client, Wish::Force(side, number.saturating_sub(1), to)).await
        }
        Order::Set { point: name, value } => {
            let point = Address::parse(&name);
            if let Some(lacking) = point.and_then(|point| no_such_point(point, client.board())) {
                return Err(Undone::Told(both(|lang| told(&lacking, lang))));
            }
            let point = point.filter(|point| point::is_written(*point));
            let point = point.ok_or_else(|| both(|lang| words::no_point(lang, &name)))?;
            point::set(client, point, value).await?;
            Ok(None)
        }
        Order::Press { .. } | Order::Turn { .. } => Err(Undone::Told(both(words::own_contacts))),
        Order::Upload { text, stay } => put(client, desk, number, &text, stay).await.map(Some),
        Order::Watch { text } => {
            let watched = Watched::new(&text)?;
            desk.watched.replace(Some(watched));
            Ok(None)
        }
        Order::Settings => {
            let settings = Settings::read(client).await?;
            desk.tell(News::Settings(settings.into()));
            Ok(None)
        }
        #[cfg(feature = "full")]
        Order::Settle { settings } => settle(client, desk, settings).await,
    }
}

/// What is forced ends at the board after so many seconds without a request: a page may be closed at any moment.
const END_FORCING: u8 = 30;

async fn wish(client: &mut Client, wish: Wish) -> Result<Option<Both>, Undone> {
    wish.fulfil_until(client, Some(END_FORCING)).await?;
    Ok(None)
}

async fn put(
    client: &mut Client,
    desk: &Desk,
    number: u32,
    text: &Analysis,
    stay: bool,
) -> Result<Both, Undone> {
    let source = source(text)?;
    if not_sent(source, Lang::En).is_some() {
        let why = both(|lang| not_sent(source, lang).unwrap_or_default());
        return Err(Undone::Told(why));
    }
    let needs = needs(source.program());
    let before = stop(client).await?;
    if before.program.version < needs {
        let board = before.program.version;
        let old = Broken::TooOld { board, needs };
        return Err(Undone::Told(both(|lang| words::broken(lang, &old))));
    }
    let mut show = |progress| {
        desk.tell(match progress {
            Progress::Sent { pass, bytes, of } => News::Sent {
                order: number,
                bytes: bytes + if pass == Pass::Store { of } else { 0 },
                of: 2 * of,
            },
            Progress::Storing => News::Storing { order: number },
        });
    };
    let kept = upload_program(client, source.program(), &source.code, &mut show).await;
    let kept = kept.map_err(|broken| both(|lang| words::broken(lang, &broken)))?;
    desk.tell(News::Stored(Kept::from(kept)));
    desk.watched.replace(Some(Watched::new(text)?));
    // A board in no state of this version goes on as one in STOP.
    let state = before.state.unwrap_or(State::Stop);
    let behind = go_on(client, state, kept, stay).await?;
    Ok(both(|lang| words::behind(lang, behind)))
}
