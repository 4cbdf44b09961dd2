//! What lies between a step of a conversation and what is said in it.

use crate::AT_A_LINE;
use std::cell::{Cell, RefCell};
use std::future::poll_fn;
use std::rc::Rc;
use std::task::Poll;
use std::time::Duration;
use unoclp_core::Board;
use unoclp_modbus::map::Parity;

/// How bytes are sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Format {
    /// Bits per second.
    pub rate: u32,
    /// The parity.
    pub parity: Parity,
}

/// What lies between a step and what is said.
pub(crate) struct Mailbox {
    /// How bytes are sent from now on.
    pub format: Cell<Format>,
    /// The board is to be reset.
    pub reset: Cell<bool>,
    /// What is known of the other end.
    pub known: Cell<Known>,
    pub now: Cell<Duration>,
    /// When to go on if nothing comes.
    pub until: Cell<Duration>,
    pub came: RefCell<Vec<u8>>,
    pub send: RefCell<Vec<u8>>,
    pub gone: RefCell<Option<String>>,
}

/// What one conversation knows of the other end, for the next one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Known {
    /// The board, once it has said which it is.
    pub board: Board,
    /// Requests that stayed without a byte in answer, one after another.
    unanswered: u32,
    /// When the last of them was sent.
    asked: Duration,
}

impl Default for Known {
    fn default() -> Known {
        Known {
            board: AT_A_LINE,
            unanswered: 0,
            asked: Duration::ZERO,
        }
    }
}

/// So many requests without an answer, and the board may be in its boot loader.
const SILENT: u32 = 3;
/// The Mega's boot loader takes a request for its own language, and starts the firmware once it has heard nothing for 5 s.
const BOOT_LOADER: Duration = Duration::from_secs(6);

/// The port is gone, and why.
#[derive(Debug)]
pub(crate) struct Gone(pub String);

/// The line as a conversation sees it.
pub(crate) struct Link(pub Rc<Mailbox>);

impl Mailbox {
    /// One of a conversation that has not begun.
    pub fn new(format: Format) -> Mailbox {
        Mailbox {
            format: Cell::new(format),
            reset: Cell::default(),
            known: Cell::default(),
            now: Cell::default(),
            until: Cell::default(),
            came: RefCell::default(),
            send: RefCell::default(),
            gone: RefCell::default(),
        }
    }
}

impl Link {
    /// How bytes are sent.
    #[cfg(feature = "more")]
    pub fn format(&self) -> Format {
        self.0.format.get()
    }

    /// Has bytes sent so from now on.
    #[cfg(feature = "more")]
    pub fn speak(&self, format: Format) {
        self.0.format.set(format);
    }

    /// Has the board reset before anything else is sent. What has come before that is forgotten.
    #[cfg(feature = "more")]
    pub fn reset(&self) {
        self.0.came.take();
        self.0.reset.set(true);
    }

    /// The time of this step.
    pub fn now(&self) -> Duration {
        self.0.now.get()
    }

    /// The board at the other end.
    pub fn board(&self) -> Board {
        self.0.known.get().board
    }

    /// It has said which it is.
    pub fn meet(&self, board: Board) {
        let known = self.0.known.get();
        self.0.known.set(Known { board, ..known });
    }

    /// A request that was sent then has been answered, or nothing has come.
    pub fn heard(&self, answered: bool, asked: Duration) {
        let known = self.0.known.get();
        let unanswered = if answered { 0 } else { known.unanswered + 1 };
        self.0.known.set(Known {
            unanswered,
            asked,
            ..known
        });
    }

    /// It has been told to begin again.
    pub fn begins_again(&self) {
        let known = self.0.known.get();
        self.0.known.set(Known {
            unanswered: SILENT,
            asked: self.now(),
            ..known
        });
    }

    /// Until when a further request would keep the board in its boot loader; none where it would not.
    pub fn rests(&self) -> Option<Duration> {
        let known = self.0.known.get();
        let waits = known.board == Board::MEGA && known.unanswered >= SILENT;
        waits.then_some(known.asked + BOOT_LOADER)
    }

    /// Sends bytes. What has come before that is forgotten: it is late, or was never meant for us.
    pub fn send(&self, bytes: &[u8]) {
        self.0.came.take();
        self.0.send.borrow_mut().extend(bytes);
    }

    /// Adds what has come to `bytes`; false if nothing comes until then.
    pub async fn receive(&self, bytes: &mut Vec<u8>, until: Duration) -> Result<bool, Gone> {
        let has_come = self.wait(until, || !self.0.came.borrow().is_empty());
        let has_come = has_come.await?;
        bytes.append(&mut self.0.came.borrow_mut());
        Ok(has_come)
    }

    /// Waits until something is so; false if it is not so by then. It is asked at each step.
    pub async fn wait(&self, until: Duration, is_so: impl Fn() -> bool) -> Result<bool, Gone> {
        poll_fn(|_| {
            let mailbox = &*self.0;
            if let Some(why) = &*mailbox.gone.borrow() {
                return Poll::Ready(Err(Gone(why.clone())));
            }
            if is_so() {
                return Poll::Ready(Ok(true));
            }
            if mailbox.now.get() >= until {
                return Poll::Ready(Ok(false));
            }
            mailbox.until.set(until);
            Poll::Pending
        })
        .await
    }
}
