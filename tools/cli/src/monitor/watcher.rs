//! The thread that reads the board. It says all that it finds, and takes orders in between.

use crate::messages;
use crate::port::{Place, Port, find};
use std::cell::Cell;
use std::ops::ControlFlow;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender, TryRecvError};
use std::thread;
use std::time::Duration;
use unoclp_client::identity::Identity;
use unoclp_client::live::Parts;
use unoclp_client::order::Order;
use unoclp_client::session::{self, Desk, Event, Orders};
use unoclp_client::watch::{Reading, Scope};
use unoclp_client::{Failure, Patience};

/// What the thread says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum News {
    /// A board has answered.
    Found {
        /// What it says that it is.
        identity: Identity,
        /// Opening the port has probably reset it.
        may_be_reset: bool,
    },
    /// All that there is to show.
    Read(Box<Reading>),
    /// An order was done.
    Done,
    /// An order was not done, and why.
    Refused(String),
    /// There is no board, or no longer one, and why. It is sought on.
    Lost(String),
}

/// Time until a lost board is sought again.
const AGAIN: Duration = Duration::from_secs(1);

/// Starts a thread that watches the board. It ends when nobody orders or listens any more.
///
/// What is forced ends at the board after `end_forcing` seconds without a request, 1 to 254.
pub fn watch(
    place: Place,
    patience: Patience,
    scope: Scope,
    end_forcing: Option<u8>,
) -> (Sender<Order>, Receiver<News>) {
    let (order, orders) = mpsc::channel();
    let (say, news) = mpsc::channel();
    thread::spawn(move || {
        let watcher = Watcher {
            place,
            patience,
            scope,
            end_forcing,
            orders,
            say,
        };
        // It ends by nobody being there; there is nobody to tell that either.
        let _ = watcher.run();
    });
    (order, news)
}

/// Nobody orders or listens any more.
struct Gone;

struct Watcher {
    place: Place,
    patience: Patience,
    scope: Scope,
    end_forcing: Option<u8>,
    orders: Receiver<Order>,
    say: Sender<News>,
}

impl Watcher {
    fn run(self) -> Result<(), Gone> {
        loop {
            match find(&self.place, self.patience) {
                Ok(found) => {
                    self.say(News::Found {
                        identity: found.identity,
                        may_be_reset: found.may_be_reset,
                    })?;
                    let failure = self.watch(found.port)?;
                    self.say(News::Lost(messages::failure(&failure)))?;
                }
                Err(not_found) => self.say(News::Lost(not_found.to_string()))?,
            }
            while self.order(AGAIN)?.is_some() {
                self.say(News::Refused(messages::no_board_there()))?;
            }
        }
    }

    /// Watches the board until it is lost.
    fn watch(&self, mut port: Port) -> Result<Failure, Gone> {
        let desk = At {
            watcher: self,
            orders: Orders::default(),
            listens: Cell::new(true),
        };
        let attend = || loop {
            match self.orders.try_recv() {
                Ok(order) => desk.orders.borrow_mut().push_back(order),
                Err(TryRecvError::Empty) if desk.listens.get() => {
                    return ControlFlow::Continue(());
                }
                Err(_) => return ControlFlow::Break(Gone),
            }
        };
        let talk = async |client: &mut _| session::watch(client, &desk).await;
        match port.attended(talk, attend) {
            ControlFlow::Continue(failure) => Ok(failure),
            ControlFlow::Break(gone) => Err(gone),
        }
    }

    fn say(&self, news: News) -> Result<(), Gone> {
        self.say.send(news).map_err(|_| Gone)
    }

    /// The next order, if there is one within this time.
    fn order(&self, within: Duration) -> Result<Option<Order>, Gone> {
        match self.orders.recv_timeout(within) {
            Ok(order) => Ok(Some(order)),
            Err(RecvTimeoutError::Timeout) => Ok(None),
            Err(RecvTimeoutError::Disconnected) => Err(Gone),
        }
    }
}

/// The monitor at a board that it has found.
struct At<'w> {
    watcher: &'w Watcher,
    orders: Orders,
    listens: Cell<bool>,
}

impl At<'_> {
    fn say(&self, news: News) {
        self.listens
            .set(self.listens.get() && self.watcher.say(news).is_ok());
    }
}

impl Desk for At<'_> {
    /// A person looks at all of it.
    fn wants(&self) -> (Scope, Parts) {
        (self.watcher.scope, Parts::ALL)
    }

    fn end_forcing(&self) -> Option<u8> {
        self.watcher.end_forcing
    }

    fn orders(&self) -> &Orders {
        &self.orders
    }

    fn hear(&self, event: Event<'_>) {
        match event {
            Event::Seen(reading) => self.say(News::Read(Box::new(reading.clone()))),
            Event::Done(_) => self.say(News::Done),
            Event::Undone(why) => {
                self.say(News::Refused(messages::undone(why)));
            }
            // That it is found and lost is said with its port; nothing else is ordered here.
            _ => {}
        }
    }
}
