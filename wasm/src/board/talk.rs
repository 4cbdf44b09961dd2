//! What is said to a board.

use super::desk::Desk;
use super::fulfil::{Undone, fulfil};
use super::news::{News, Seen};
use super::order::Order;
use super::watched::Watched;
use crate::words::{self, both};
use std::time::Duration;
use unoclp_board::start::find;
use unoclp_board::watch::{Parts, Reading, Scope};
use unoclp_board::{Client, Failure};

/// Time from reading to reading: the line is for orders too.
const PAUSE: Duration = Duration::from_millis(20);
/// Time until a board that is lost is sought again.
const AGAIN: Duration = Duration::from_secs(1);
/// Of so many readings one is of everything.
const WHOLE: u32 = 16;

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
    let mut reading = Reading::default();
    let mut round = 0_u32;
    loop {
        let (scope, parts) = match &*desk.watched.borrow() {
            Some(watched) => watched.scope(),
            None => (Scope::default(), Parts::default()),
        };
        let read = match round % WHOLE {
            0 => Reading::read(client, scope).await,
            _ => reading
                .renew(client, scope, parts)
                .await
                .map(|()| std::mem::take(&mut reading)),
        };
        reading = match read {
            Ok(reading) => reading,
            Err(failure) => return failure,
        };
        round = round.wrapping_add(1);
        desk.tell(see(&reading, &mut desk.watched.borrow_mut()));
        let are_there = || !desk.orders.borrow().is_empty();
        if let Err(failure) = client.pause(PAUSE, are_there).await {
            return failure;
        }
        while let Some((order, what)) = next(desk) {
            // What they have brought about is shown at once.
            round = 0;
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
