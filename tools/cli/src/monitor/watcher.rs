//! The thread that reads the board. It says all that it finds, and takes wishes in between.

use crate::messages;
use crate::port::{Place, Port, find};
use std::cell::Cell;
use std::ops::ControlFlow;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender, TryRecvError};
use std::thread;
use std::time::Duration;
use unoclp_client::diagnostics::Diagnostics;
use unoclp_client::identity::Identity;
use unoclp_client::map::{Command, State, flag};
use unoclp_client::watch::{self, Reading, Scope, Seen, Wish, Wishes};
use unoclp_client::{Failure, Patience};
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
        let wishes = Wishes::default();
        let listens = Cell::new(true);
        let mut see = |seen| listens.set(listens.get() && self.say(news(seen)).is_ok());
        let attend = || loop {
            match self.wishes.try_recv() {
                Ok(wish) => wishes.push(wish),
                Err(TryRecvError::Empty) if listens.get() => return ControlFlow::Continue(()),
                Err(_) => return ControlFlow::Break(Gone),
            }
        };
        let talk = async |client: &mut _| {
            watch::watch(client, self.scope, self.end_forcing, &wishes, &mut see).await
        };
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

/// What is seen of a board, in the words of the monitor.
fn news(seen: Seen) -> News {
    match seen {
        Seen::Reading(reading) => News::Read(reading),
        Seen::Refused(wish, Exception::ServerDeviceFailure, board) => {
            News::Refused(refusal(wish, &board))
        }
        Seen::Refused(wish, Exception::IllegalFunction, _) => News::Refused(match wish {
            Wish::Command(_) => messages::refused_commands(),
            Wish::Force(..) | Wish::Release => messages::refused_writing(),
        }),
        Seen::Refused(_, exception, _) => {
            News::Refused(messages::failure(&Failure::Refused(exception)))
        }
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
