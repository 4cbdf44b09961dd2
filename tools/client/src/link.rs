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
    /// The board at the other end.
    pub board: Cell<Board>,
    pub now: Cell<Duration>,
    /// When to go on if nothing comes.
    pub until: Cell<Duration>,
    pub came: RefCell<Vec<u8>>,
    pub send: RefCell<Vec<u8>>,
    pub gone: RefCell<Option<String>>,
}

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
            board: Cell::new(AT_A_LINE),
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
        self.0.board.get()
    }

    /// It has said which it is.
    pub fn meet(&self, board: Board) {
        self.0.board.set(board);
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
