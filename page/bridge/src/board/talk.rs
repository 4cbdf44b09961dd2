//! What is said to a board, and what a page hears of it.

use super::desk::Desk;
use super::fulfil::fulfil;
use super::news::{News, Seen};
use super::order::Order;
use super::undone::Undone;
use super::watched::Watched;
use crate::words::{self, Both, both};
use unoclp_client::live::Parts;
use unoclp_client::session::{self, Away, Change, Event};
use unoclp_client::watch::{Reading, Scope};
use unoclp_client::{Client, Failure};

impl session::Desk for Desk {
    /// With the number by which the news speak of it.
    type Order = (u32, Order);

    fn wants(&self) -> (Scope, Parts) {
        let watched = self.watched.borrow();
        watched.as_ref().map(Watched::scope).unwrap_or_default()
    }

    fn hear(&self, event: Event<'_>) {
        self.tell(match event {
            Event::Found(identity) => News::Found {
                identity: identity.to_string(),
            },
            Event::Seen(reading) => see(reading, &mut self.watched.borrow_mut()),
            Event::Lost(away) => News::Lost { why: why(away) },
        });
    }

    fn has_orders(&self) -> bool {
        !self.orders.borrow().is_empty()
    }

    fn next(&self) -> Option<(u32, Order)> {
        self.orders.borrow_mut().pop_front()
    }

    fn change(&self, (_, order): &(u32, Order)) -> Change {
        match order {
            Order::Force { .. } | Order::Release | Order::Set { .. } => Change::Points,
            _ => Change::All,
        }
    }

    async fn fulfil(
        &self,
        client: &mut Client,
        (order, what): (u32, Order),
    ) -> Result<(), Failure> {
        match fulfil(client, self, order, what).await {
            Ok(said) => self.tell(News::Done { order, said }),
            Err(Undone::Told(why)) => self.tell(News::Undone { order, why }),
            Err(Undone::Lost(failure)) => {
                let why = both(|lang| words::failure(lang, &failure));
                self.tell(News::Undone { order, why });
                return Err(failure);
            }
        }
        Ok(())
    }

    fn undone(&self, (order, _): (u32, Order), away: &Away) {
        let why = why(away);
        self.tell(News::Undone { order, why });
    }
}

fn why(away: &Away) -> Both {
    both(|lang| match away {
        Away::NotFound(why) => words::not_found(lang, why),
        Away::Gone(failure) => words::failure(lang, failure),
    })
}

fn see(reading: &Reading, watched: &mut Option<Watched>) -> News {
    let same = watched.as_ref().map(|watched| watched.is_on(reading));
    let trouble = reading.diagnostics.trouble;
    let watched = watched.as_mut().filter(|_| same == Some(true));
    let line = watched.as_ref().and_then(|watched| watched.line(trouble?));
    let live = watched.map(|watched| watched.live(reading));
    News::Seen(Box::new(Seen::of(reading, same, line, live)))
}
