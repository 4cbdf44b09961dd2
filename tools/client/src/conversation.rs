//! A conversation with a board as a state machine: bytes and the time go in, bytes and the next time come out.
//!
//! What is said stands as an `async fn` over a [`Client`]; a [`Conversation`] drives it without a runtime. Whoever
//! has the port carries the bytes and keeps the time:
//!
//! ```
//! use std::time::Duration;
//! use unoclp_client::{Conversation, Line, Next, Patience};
//!
//! # struct Port(Duration);
//! # impl Port {
//! #     fn now(&mut self) -> Duration { self.0 += Duration::from_millis(100); self.0 }
//! #     fn write(&mut self, _: &[u8]) {}
//! #     fn read_until(&mut self, _: Duration) -> Vec<u8> { Vec::new() }
//! # }
//! # let mut port = Port(Duration::ZERO);
//! let mut conversation = Conversation::new(Line::default(), Patience::default(), async |client| {
//!     client.identify().await
//! });
//! let mut came = Vec::new();
//! let identity = loop {
//!     let step = conversation.step(port.now(), &came);
//!     port.write(&step.send);
//!     match step.next {
//!         Next::Done(identity) => break identity,
//!         // Whatever comes before that is passed on at once.
//!         Next::Wait(until) => came = port.read_until(until),
//!     }
//! };
//! assert!(identity.is_err(), "nobody is there");
//! ```

use crate::client::{Client, Line, Patience};
use crate::link::{Format, Known, Link, Mailbox};
use std::pin::Pin;
use std::rc::Rc;
use std::task::{Context, Poll, Waker};
use std::time::Duration;

/// Something that is being said to a board, until it comes to a `T`.
pub struct Conversation<'a, T> {
    mailbox: Rc<Mailbox>,
    /// None once it is done.
    talk: Option<Pin<Box<dyn Future<Output = T> + 'a>>>,
}

/// What a step of a conversation asks for.
#[derive(Debug, PartialEq, Eq)]
pub struct Step<T> {
    /// How bytes are sent from now on: the line's own way, but for a boot loader.
    pub format: Format,
    /// First reset the board (on an Arduino: DTR off, for 50 ms or more, and on), and throw away what has come before.
    pub reset: bool,
    /// Then send these bytes.
    pub send: Vec<u8>,
    /// And then this.
    pub next: Next<T>,
}

/// How a conversation goes on.
#[derive(Debug, PartialEq, Eq)]
pub enum Next<T> {
    /// By another step at this time, or as soon as bytes have come. A step before that does no harm.
    Wait(Duration),
    /// It is over.
    Done(T),
}

impl<'a, T> Conversation<'a, T> {
    /// What `talk` says to the board at the other end of this line. It begins with the first step.
    pub fn new(
        line: Line,
        patience: Patience,
        talk: impl AsyncFnOnce(&mut Client) -> T + 'a,
    ) -> Conversation<'a, T> {
        let mailbox = Rc::new(Mailbox::new(line.format()));
        let mut client = Client::new(Link(mailbox.clone()), line, patience);
        Conversation {
            mailbox,
            talk: Some(Box::pin(async move { talk(&mut client).await })),
        }
    }

    /// Goes on, at the time `now` since any moment, with the bytes that have come since the last step. After
    /// its end a conversation waits forever.
    pub fn step(&mut self, now: Duration, came: &[u8]) -> Step<T> {
        let mailbox = &self.mailbox;
        mailbox.now.set(now);
        mailbox.until.set(Duration::MAX);
        mailbox.came.borrow_mut().extend(came);
        // It is stepped whenever something may have changed, so nobody need be woken.
        let mut context = Context::from_waker(Waker::noop());
        let polled = match &mut self.talk {
            Some(talk) => talk.as_mut().poll(&mut context),
            None => Poll::Pending,
        };
        let next = match polled {
            Poll::Pending => Next::Wait(self.mailbox.until.get()),
            Poll::Ready(outcome) => {
                self.talk = None;
                Next::Done(outcome)
            }
        };
        Step {
            format: self.mailbox.format.get(),
            reset: self.mailbox.reset.take(),
            send: self.mailbox.send.take(),
            next,
        }
    }

    /// What it knows of the other end.
    pub fn known(&self) -> Known {
        self.mailbox.known.get()
    }

    /// Another conversation on the same clock has come to know this.
    pub fn know(&self, known: Known) {
        self.mailbox.known.set(known);
    }

    /// The port is gone, and why: the next step is told so, and all that is said from then on fails.
    pub fn lose(&mut self, why: String) {
        *self.mailbox.gone.borrow_mut() = Some(why);
    }
}
