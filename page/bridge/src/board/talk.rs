//! What is said to a board.

use super::desk::Desk;
use super::fulfil::fulfil;
use super::news::{News, Seen};
use super::order::Order;
use super::undone::Undone;
use super::watched::Watched;
use crate::words::{self, both};
use std::time::Duration;
use unoclp_client::live::{Live, Parts};
use unoclp_client::start::find;
use unoclp_client::watch::{Reading, Scope};
use unoclp_client::{Client, Failure};

/// Time until a board that is lost is sought again.
const AGAIN: Duration = Duration::from_secs(1);

/// Finds the board, watches it, and does what is ordered, until the line is gone.
pub async fn talk(client: &mut Client, desk: &Desk, mut reset: bool) {
    loop {
        let lost = match find(client, reset).await {
            Ok(identity) => {
                let identity = identity.to_string();
                desk.tell(News::Found { identity });
                let failure = watch(client, desk).await;
                both(|lang| words::failure(lang, &failure))
            }
            Err(why) => both(|lang| words::not_found(lang, &why)),
        };
        desk.tell(News::Lost { why: lost.clone() });
        // Nothing that was ordered is done behind a person's back, once the board is there again.
        for (order, _) in desk.orders.take() {
            let why = lost.clone();
            desk.tell(News::Undone { order, why });
        }
        if let Err(Failure::Lost(_)) = client.pause(AGAIN, || false).await {
            return;
        }
        // A request would disturb the boot loader of a board that comes back.
        reset = true;
    }
}

/// Reads the board again and again, and does what is ordered in between; says how it was lost.
async fn watch(client: &mut Client, desk: &Desk) -> Failure {
    let mut live = Live::default();
    loop {
        let (scope, parts) = match &*desk.watched.borrow() {
            Some(watched) => watched.scope(),
            None => (Scope::default(), Parts::default()),
        };
        let reading = match live.round(client, scope, parts).await {
            Ok(reading) => reading,
            Err(failure) => return failure,
        };
        desk.tell(see(reading, &mut desk.watched.borrow_mut()));
        let are_there = || !desk.orders.borrow().is_empty();
        if let Err(failure) = live.pause(client, are_there).await {
            return failure;
        }
        while let Some((order, what)) = next(desk) {
            // What they bring about is shown at once.
            match what {
                Order::Force { .. } | Order::Release | Order::Set { .. } => {
                    live.points_have_changed();
                }
                _ => live.all_has_changed(),
            }
            match fulfil(client, desk, order, what).await {
                Ok(said) => desk.tell(News::Done { order, said }),
                Err(Undone::Told(why)) => desk.tell(News::Undone { order, why }),
                Err(Undone::Lost(failure)) => {
                    let why = both(|lang| words::failure(lang, &failure));
                    desk.tell(News::Undone { order, why });
                    return failure;
                }
            }
        }
    }
}

fn next(desk: &Desk) -> Option<(u32, Order)> {
    desk.orders.borrow_mut().pop_front()
}

fn see(reading: &Reading, watched: &mut Option<Watched>) -> News {
    let same = watched.as_ref().map(|watched| watched.is_on(reading));
    let trouble = reading.diagnostics.trouble;
    let watched = watched.as_mut().filter(|_| same == Some(true));
    let line = watched.as_ref().and_then(|watched| watched.line(trouble?));
    let live = watched.map(|watched| watched.live(reading));
    News::Seen(Box::new(Seen::of(reading, same, line, live)))
}
