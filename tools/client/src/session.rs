//! A board that is watched: found, read again and again, told in between what to do, and sought again where it is lost.
//! Whoever watches one, a terminal or a page, is a [`Desk`].

use crate::client::{Client, Failure};
use crate::identity::Identity;
use crate::live::{Live, Parts};
use crate::start::{NotFound, find};
use crate::watch::{Reading, Scope};
use std::time::Duration;

/// What there is to say of a board.
#[derive(Debug)]
pub enum Event<'e> {
    /// It has answered.
    Found(Identity),
    /// All that there is to show.
    Seen(&'e Reading),
    /// There is no board, or no longer one. It is sought on.
    Lost(&'e Away),
}

/// Why there is no board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Away {
    /// It was not found.
    NotFound(NotFound),
    /// It was there.
    Gone(Failure),
}

/// What an order may have changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Points: what is forced, or a preset.
    Points,
    /// Anything.
    All,
}

/// Who has a board watched: what is read of it, what is ordered, and who hears of it.
pub trait Desk {
    /// Something that is ordered of the board.
    type Order;

    /// How much of the board is read, and what of that is read often.
    fn wants(&self) -> (Scope, Parts);

    /// Hears this.
    fn hear(&self, event: Event<'_>);

    /// Whether something is ordered.
    fn has_orders(&self) -> bool;

    /// The next that is ordered.
    fn next(&self) -> Option<Self::Order>;

    /// What it may change.
    fn change(&self, order: &Self::Order) -> Change;

    /// Does it, and tells whoever has ordered it what has come of it.
    ///
    /// # Errors
    /// By which the board is lost.
    fn fulfil(
        &self,
        client: &mut Client,
        order: Self::Order,
    ) -> impl Future<Output = Result<(), Failure>>;

    /// It was ordered, and is not done: there is no board.
    fn undone(&self, order: Self::Order, why: &Away);
}

/// Time until a board that is lost is sought again.
const AGAIN: Duration = Duration::from_secs(1);

/// Finds the board, watches it, and does what is ordered, until the line is gone. One that has probably been `reset` is given
/// the time to start.
pub async fn talk(client: &mut Client, desk: &impl Desk, mut reset: bool) {
    loop {
        let away = match find(client, reset).await {
            Ok(identity) => {
                desk.hear(Event::Found(identity));
                Away::Gone(watch(client, desk).await)
            }
            Err(why) => Away::NotFound(why),
        };
        desk.hear(Event::Lost(&away));
        // Nothing that was ordered is done behind a person's back, once the board is there again.
        while let Some(order) = desk.next() {
            desk.undone(order, &away);
        }
        if let Err(Failure::Lost(_)) = client.pause(AGAIN, || false).await {
            return;
        }
        // A request would disturb the boot loader of a board that comes back.
        reset = true;
    }
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
    live.pause(client, || desk.has_orders()).await?;
    // What they bring about is shown at once.
    while let Some(order) = desk.next() {
        match desk.change(&order) {
            Change::Points => live.points_have_changed(),
            Change::All => live.all_has_changed(),
        }
        desk.fulfil(client, order).await?;
    }
    Ok(())
}
