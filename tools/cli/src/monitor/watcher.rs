//! The thread that reads the board. It says all that it finds, and takes wishes in between.

use crate::messages;
use crate::port::{Place, Port, find};
use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::ops::ControlFlow;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender, TryRecvError};
use std::thread;
use std::time::Duration;
use unoclp_client::diagnostics::Diagnostics;
use unoclp_client::identity::Identity;
use unoclp_client::live::Parts;
use unoclp_client::map::{Command, State, flag};
use unoclp_client::session::{self, Away, Change, Desk, Event};
use unoclp_client::watch::{Reading, Scope, Wish};
use unoclp_client::{Client, Failure, Patience};
use unoclp_modbus::Exception;

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
    /// A wish was not fulfilled, and why.
    Refused(String),
    /// There is no board, or no longer one, and why. It is sought on.
    Lost(String),
}

/// Time until a lost board is sought again.
const AGAIN: Duration = Duration::from_secs(1);

/// Starts a thread that watches the board. It ends when nobody wishes or listens any more.
///
/// What is forced ends at the board behind `end_forcing` seconds without a request, 1 to 254.
pub fn watch(
    place: Place,
    patience: Patience,
    scope: Scope,
    end_forcing: Option<u8>,
) -> (Sender<Wish>, Receiver<News>) {
    let (wish, wishes) = mpsc::channel();
    let (say, news) = mpsc::channel();
    thread::spawn(move || {
        let watcher = Watcher {
            place,
            patience,
            scope,
            end_forcing,
            wishes,
            say,
        };
        // It ends by nobody being there; there is nobody to tell that either.
        let _ = watcher.run();
    });
    (wish, news)
}

/// Nobody wishes or listens any more.
struct Gone;

struct Watcher {
    place: Place,
    patience: Patience,
    scope: Scope,
    end_forcing: Option<u8>,
    wishes: Receiver<Wish>,
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
            while self.wish(AGAIN)?.is_some() {
                self.say(News::Refused(messages::no_board_to_do_it()))?;
            }
        }
    }

    /// Watches the board until it is lost.
    fn watch(&self, mut port: Port) -> Result<Failure, Gone> {
        let desk = At {
            watcher: self,
            wishes: RefCell::default(),
            listens: Cell::new(true),
        };
        let attend = || loop {
            match self.wishes.try_recv() {
                Ok(wish) => desk.wishes.borrow_mut().push_back(wish),
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

    /// The next wish, if there is one within this time.
    fn wish(&self, within: Duration) -> Result<Option<Wish>, Gone> {
        match self.wishes.recv_timeout(within) {
            Ok(wish) => Ok(Some(wish)),
            Err(RecvTimeoutError::Timeout) => Ok(None),
            Err(RecvTimeoutError::Disconnected) => Err(Gone),
        }
    }
}

/// The monitor at a board that it has found.
struct At<'w> {
    watcher: &'w Watcher,
    wishes: RefCell<VecDeque<Wish>>,
    listens: Cell<bool>,
}

impl At<'_> {
    fn say(&self, news: News) {
        self.listens
            .set(self.listens.get() && self.watcher.say(news).is_ok());
    }
}

impl Desk for At<'_> {
    type Order = Wish;

    /// A person looks at all of it.
    fn wants(&self) -> (Scope, Parts) {
        (self.watcher.scope, Parts::ALL)
    }

    fn hear(&self, event: Event<'_>) {
        // That it is found and lost is said with its port.
        if let Event::Seen(reading) = event {
            self.say(News::Read(Box::new(reading.clone())));
        }
    }

    fn has_orders(&self) -> bool {
        !self.wishes.borrow().is_empty()
    }

    fn next(&self) -> Option<Wish> {
        self.wishes.borrow_mut().pop_front()
    }

    fn change(&self, wish: &Wish) -> Change {
        match wish {
            Wish::Force(..) | Wish::Release => Change::Points,
            Wish::Command(_) => Change::All,
        }
    }

    async fn fulfil(&self, client: &mut Client, wish: Wish) -> Result<(), Failure> {
        match wish.fulfil_until(client, self.watcher.end_forcing).await {
            Err(Failure::Refused(exception)) => {
                let board = Diagnostics::read(client).await?;
                self.say(News::Refused(refused(wish, exception, &board)));
                Ok(())
            }
            other => other,
        }
    }

    fn undone(&self, _: Wish, _: &Away) {
        self.say(News::Refused(messages::no_board_to_do_it()));
    }
}

/// Why a board has refused something.
fn refused(wish: Wish, exception: Exception, board: &Diagnostics) -> String {
    match (exception, wish) {
        (Exception::ServerDeviceFailure, _) => refusal(wish, board),
        (Exception::IllegalFunction, Wish::Command(_)) => messages::refused_commands(),
        (Exception::IllegalFunction, _) => messages::refused_writing(),
        (other, _) => messages::failure(&Failure::Refused(other)),
    }
}

/// Why a board does not do something now.
fn refusal(wish: Wish, board: &Diagnostics) -> String {
    let scan = wish == Wish::Command(Command::SingleScan);
    if board.state == Some(State::Fault) {
        messages::refused_in_fault()
    } else if board.has(flag::STOP_SWITCH) {
        messages::refused_by_switch()
    } else if board.has(flag::UPLOAD) {
        messages::refused_in_upload()
    } else if scan {
        messages::refused_scan()
    } else {
        messages::refused()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_says_what_stands_in_its_way() {
        let board = |state, flags| Diagnostics {
            state: Some(state),
            flags,
            ..Diagnostics::default()
        };
        let (run, scan) = (Command::Run, Command::SingleScan);
        for (command, board, says) in [
            (run, board(State::Fault, 0), "FAULT: r restarts"),
            (run, board(State::Stop, flag::STOP_SWITCH), "A5 is closed"),
            (scan, board(State::Stop, flag::UPLOAD), "upload"),
            (scan, board(State::Run, 0), "press space"),
            (run, board(State::Stop, 0), "cannot do that now"),
        ] {
            let said = refusal(Wish::Command(command), &board);
            assert!(said.contains(says), "{said}");
        }
    }
}
