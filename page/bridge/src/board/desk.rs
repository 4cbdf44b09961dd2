//! What lies between a conversation and its page: the desk of the client's session.

use super::news::{Kept, News, Seen};
use super::watched::Watched;
use crate::words::{Both, both};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;
use unoclp_client::live::Parts;
use unoclp_client::order::Done;
use unoclp_client::session::{self, Event, Orders};
use unoclp_client::upload::{Pass, Progress};
use unoclp_client::watch::{Reading, Scope};
use unoclp_client::{Order, words};
use unoclp_workspace::Analysis;

/// What is forced ends at the board after so many seconds without a request: a page may be closed at any moment.
const END_FORCING: u8 = 30;

/// What lies between a conversation and its page.
#[derive(Default)]
pub struct Desk {
    orders: Orders,
    /// The number of each of them, and of the one under way, by which the news speak of it; of an upload the text.
    numbers: RefCell<VecDeque<(u32, Option<Rc<Analysis>>)>>,
    pub news: RefCell<Vec<News>>,
    pub watched: RefCell<Option<Watched>>,
}

impl Desk {
    /// Tells the page something with the next step.
    pub fn tell(&self, news: News) {
        self.news.borrow_mut().push(news);
    }

    /// Orders something of the board.
    pub fn order(&self, number: u32, order: Order, text: Option<Rc<Analysis>>) {
        self.numbers.borrow_mut().push_back((number, text));
        self.orders.borrow_mut().push_back(order);
    }

    /// The number of the order under way.
    fn under_way(&self) -> u32 {
        let numbers = self.numbers.borrow();
        numbers.front().map_or(0, |(number, _)| *number)
    }

    /// The order under way is over; gives its number.
    fn over(&self) -> u32 {
        let over = self.numbers.borrow_mut().pop_front();
        over.map_or(0, |(number, _)| number)
    }

    /// The board keeps the program of the order under way.
    fn watch(&self) {
        let numbers = self.numbers.borrow();
        if let Some((_, Some(text))) = numbers.front() {
            self.watched.replace(Watched::new(text).ok());
        }
    }

    fn done(&self, done: Done) -> News {
        News::Done {
            order: self.over(),
            said: words::done(unoclp_program::Lang::En, done)
                .map(|_| both(|lang| words::done(lang, done).unwrap_or_default())),
        }
    }
}

impl session::Desk for Desk {
    fn wants(&self) -> (Scope, Parts) {
        let watched = self.watched.borrow();
        watched.as_ref().map(Watched::scope).unwrap_or_default()
    }

    fn end_forcing(&self) -> Option<u8> {
        Some(END_FORCING)
    }

    fn orders(&self) -> &Orders {
        &self.orders
    }

    fn hear(&self, event: Event<'_>) {
        let order = self.under_way();
        self.tell(match event {
            Event::Found(identity) => News::Found {
                identity: identity.to_string(),
                board: identity.board().map(|board| board.id()),
            },
            Event::Seen(reading) => see(reading, &mut self.watched.borrow_mut()),
            Event::Lost(away) => News::Lost {
                why: both(|lang| words::away(lang, away)),
            },
            Event::Sent(Progress::Sent { pass, bytes, of }) => News::Sent {
                order,
                bytes: bytes + if pass == Pass::Store { of } else { 0 },
                of: 2 * of,
            },
            Event::Sent(Progress::Storing) => News::Storing { order },
            Event::Stored(kept) => {
                self.watch();
                News::Stored(Kept::from(kept))
            }
            #[cfg(feature = "full")]
            Event::Fetched(code) => News::Fetched {
                order,
                code: code.to_owned(),
            },
            Event::Settings(settings) => News::Settings(settings.into()),
            #[cfg(feature = "full")]
            Event::Flashing(progress) => News::Flashing {
                order,
                done: progress.done,
                of: progress.of,
            },
            Event::Done(done) => self.done(done),
            Event::Undone(undone) => self.undone(both(|lang| words::undone(lang, undone))),
            // A page shows the next reading.
            Event::Stopped { .. } | Event::Released(_) => return,
        });
    }
}

impl Desk {
    fn undone(&self, why: Both) -> News {
        let order = self.over();
        News::Undone { order, why }
    }
}

fn see(reading: &Reading, watched: &mut Option<Watched>) -> News {
    let same = watched.as_ref().map(|watched| watched.is_on(reading));
    let trouble = reading.diagnostics.trouble;
    let watched = watched.as_mut().filter(|_| same == Some(true));
    let line = watched.as_ref().and_then(|watched| watched.line(trouble?));
    let live = watched.map(|watched| watched.live(reading));
    News::Seen(Box::new(Seen::of(reading, same, line, live)))
}
