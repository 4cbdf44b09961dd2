//! A board that is watched: found, read again and again, told in between what to do, and sought again where it is lost.
//! Whoever watches one, a terminal or a page, is a [`Desk`].

use crate::client::{Client, Failure};
use crate::event::Undone;
pub use crate::event::{Away, Event};
use crate::live::{Live, Parts};
use crate::order::{Change, Order};
use crate::start::find;
use crate::watch::Scope;
use std::cell::RefCell;
use std::collections::VecDeque;
use std::future::poll_fn;
use std::pin::pin;
use std::task::Poll;
use std::time::Duration;

/// Orders that wait, the next one first.
pub type Orders = RefCell<VecDeque<Order>>;

/// Who has a board watched: what is read of it, what is ordered, and who hears of it.
pub trait Desk {
    /// How much of the board is read, and what of that is read often.
    fn wants(&self) -> (Scope, Parts);

    /// What is forced ends at the board after so many seconds without a request, 1 to 254.
    fn end_forcing(&self) -> Option<u8>;

    /// What is ordered.
    fn orders(&self) -> &Orders;

    /// Hears this.
    fn hear(&self, event: Event<'_>);
}

/// Time until a board that is lost is sought again.
const AGAIN: Duration = Duration::from_secs(1);

/// Finds the board, watches it, and does what is ordered, until the line is gone. One that has probably been `reset` is given
/// the time to start.
pub async fn talk(client: &mut Client, desk: &impl Desk, mut reset: bool) {
    let wants_firmware = || {
        desk.orders()
            .borrow()
            .front()
            .is_some_and(Order::is_firmware)
    };
    loop {
        // A board that gets a firmware need not be found before.
        if let Some(found) = unless(find(client, reset), wants_firmware).await {
            let away = match found {
                Ok(identity) => {
                    desk.hear(Event::Found(&identity));
                    Away::Gone(watch(client, desk).await)
                }
                Err(why) => Away::NotFound(why),
            };
            desk.hear(Event::Lost(&away));
            leave(client, desk, &away).await;
        }
        while wants_firmware() {
            if let Some(order) = next(desk) {
                drop(fulfil(client, desk, &order).await);
            }
        }
        if let Err(Failure::Lost(_)) = client.pause(AGAIN, wants_firmware).await {
            return;
        }
        // A request would disturb the boot loader of a board that comes back.
        reset = true;
    }
}

/// Nothing that was ordered is done behind a person's back, once the board is there again.
async fn leave(client: &mut Client, desk: &impl Desk, away: &Away) {
    while let Some(order) = next(desk) {
        match order {
            order if order.is_firmware() => drop(fulfil(client, desk, &order).await),
            _ => desk.hear(Event::Undone(&Undone::Away(away.clone()))),
        }
    }
}

/// What this comes to, unless something is so before.
async fn unless<T>(what: impl Future<Output = T>, is_so: impl Fn() -> bool) -> Option<T> {
    let mut what = pin!(what);
    poll_fn(|context| match is_so() {
        true => Poll::Ready(None),
        false => what.as_mut().poll(context).map(Some),
    })
    .await
}

/// Reads the board again and again, and does what is ordered in between; says how it was lost.
pub async fn watch(client: &mut Client, desk: &impl Desk) -> Failure {
    let mut live = Live::default();
    loop {
        if let Err(failure) = round(client, desk, &mut live).await {
            return failure;
        }
    }
}

/// One reading, and what is ordered after it.
async fn round(client: &mut Client, desk: &impl Desk, live: &mut Live) -> Result<(), Failure> {
    let (scope, parts) = desk.wants();
    desk.hear(Event::Seen(live.round(client, scope, parts).await?));
    live.pause(client, || !desk.orders().borrow().is_empty())
        .await?;
    // What they bring about is shown at once.
    while let Some(order) = next(desk) {
        match order.change() {
            Change::Points => live.points_have_changed(),
            Change::All => live.all_has_changed(),
        }
        fulfil(client, desk, &order).await?;
    }
    Ok(())
}

fn next(desk: &impl Desk) -> Option<Order> {
    desk.orders().borrow_mut().pop_front()
}

/// Does what is ordered, and tells what comes of it.
async fn fulfil(client: &mut Client, desk: &impl Desk, order: &Order) -> Result<(), Failure> {
    let tell = &mut |event: Event<'_>| desk.hear(event);
    match order.fulfil(client, desk.end_forcing(), tell).await {
        Ok(done) => desk.hear(Event::Done(done)),
        Err(undone) => {
            desk.hear(Event::Undone(&undone));
            if let Some(why) = undone.lost() {
                return Err(why);
            }
        }
    }
    match order {
        // The board begins again: a request would disturb its boot loader.
        order if order.is_firmware() => Err(Failure::Silent),
        _ => Ok(()),
    }
}
