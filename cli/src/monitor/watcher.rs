//! The thread that reads the board. It says all that it finds, and takes wishes in between.

use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;
use unoclp_board::client::{Client, Failure};
use unoclp_board::diagnostics::Diagnostics;
use unoclp_board::identity::Identity;
use unoclp_board::map::{Command, State, flag};
use unoclp_board::start::find;
use unoclp_board::watch::{Reading, Scope, Wish};
use unoclp_board::{Line, Patience};
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

/// Time from reading to reading: a few a second are enough to look at, and leave the line to others.
const PAUSE: Duration = Duration::from_millis(50);

/// Time until a lost board is sought again.
const AGAIN: Duration = Duration::from_secs(1);

/// Starts a thread that watches the board. It ends when nobody wishes or listens any more.
pub fn watch(line: Line, patience: Patience, scope: Scope) -> (Sender<Wish>, Receiver<News>) {
    let (wish, wishes) = mpsc::channel();
    let (say, news) = mpsc::channel();
    thread::spawn(move || {
        let watcher = Watcher {
            line,
            patience,
            scope,
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
    line: Line,
    patience: Patience,
    scope: Scope,
    wishes: Receiver<Wish>,
    say: Sender<News>,
}

impl Watcher {
    fn run(self) -> Result<(), Gone> {
        loop {
            match find(&self.line, self.patience) {
                Ok(found) => {
                    self.say(News::Found {
                        identity: found.identity,
                        may_be_reset: found.may_be_reset,
                    })?;
                    let failure = self.read(found.client)?;
                    self.say(News::Lost(failure.to_string()))?;
                }
                Err(not_found) => self.say(News::Lost(not_found.to_string()))?,
            }
            while self.wish(AGAIN)?.is_some() {
                self.say(News::Refused("there is no board to do it".to_owned()))?;
            }
        }
    }

    /// Reads the board until it is lost.
    fn read(&self, mut client: Client) -> Result<Failure, Gone> {
        loop {
            match Reading::read(&mut client, self.scope) {
                Ok(reading) => self.say(News::Read(Box::new(reading)))?,
                Err(failure) => return Ok(failure),
            }
            let mut pause = PAUSE;
            while let Some(wish) = self.wish(pause)? {
                match fulfil(wish, &mut client) {
                    Ok(None) => {}
                    Ok(Some(refusal)) => self.say(News::Refused(refusal))?,
                    Err(failure) => return Ok(failure),
                }
                // What it has brought about is shown at once.
                pause = Duration::ZERO;
            }
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

/// Does what is wished; says why where the board refuses it.
fn fulfil(wish: Wish, client: &mut Client) -> Result<Option<String>, Failure> {
    match wish.fulfil(client) {
        Ok(()) => Ok(None),
        Err(Failure::Refused(Exception::ServerDeviceFailure)) => {
            let diagnostics = Diagnostics::read(client)?;
            Ok(Some(refusal(wish, &diagnostics).to_owned()))
        }
        Err(Failure::Refused(exception)) => Ok(Some(format!("{}", Failure::Refused(exception)))),
        Err(failure) => Err(failure),
    }
}

/// Why a board does not do something now.
fn refusal(wish: Wish, board: &Diagnostics) -> &'static str {
    let scan = wish == Wish::Command(Command::Scan);
    if board.state == Some(State::Fault) {
        "the board is in FAULT: r restarts it"
    } else if board.has(flag::STOP_SWITCH) {
        "A5 is closed, which holds the board in STOP"
    } else if board.has(flag::UPLOAD) {
        "an upload is under way: r restarts the board without it"
    } else if scan {
        "single scans are for STOP: space stops the board"
    } else {
        "the board does not do that now"
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
        let (run, scan) = (Command::Run, Command::Scan);
        for (command, board, says) in [
            (run, board(State::Fault, 0), "FAULT: r restarts"),
            (run, board(State::Stop, flag::STOP_SWITCH), "A5 is closed"),
            (scan, board(State::Stop, flag::UPLOAD), "upload"),
            (scan, board(State::Run, 0), "space stops"),
            (run, board(State::Stop, 0), "not do that now"),
        ] {
            let said = refusal(Wish::Command(command), &board);
            assert!(said.contains(says), "{said}");
        }
    }
}
