//! The serial port that a board is at: it carries the bytes of a conversation, and keeps its time.
//!
//! - `place`: which port, and what is spoken there
//! - `open`: opening the port without resetting the board behind it
//! - `reset`: the board, reset for its boot loader

mod open;
mod place;
mod reset;

pub use open::NotOpened;
pub use place::Place;

use crate::messages;
use serialport::{ClearBuffer, SerialPort};
use std::convert::Infallible;
use std::io::{self, ErrorKind, Read, Write};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};
use unoclp_client::identity::Identity;
use unoclp_client::start;
use unoclp_client::{Client, Conversation, Failure, Format, Known, Line, Next, Patience};
use unoclp_core::Board;

/// An open serial port.
pub struct Port {
    port: Box<dyn SerialPort>,
    line: Line,
    patience: Patience,
    /// What its conversations have come to know.
    known: Known,
    /// Where the time of its conversations begins.
    begun: Instant,
    /// How bytes are sent at present.
    format: Format,
}

/// The longest time for which a conversation goes on unattended.
const ATTEND: Duration = Duration::from_millis(10);

impl Port {
    /// Opens the port. Also tells whether that has probably reset a UNO.
    ///
    /// # Errors
    /// If the port is not there or may not be used.
    pub fn open(place: &Place, patience: Patience) -> Result<(Port, bool), NotOpened> {
        let begun = Instant::now();
        let (port, may_be_reset) = open::open(place)?;
        let port = Port {
            port,
            line: place.line,
            patience,
            known: Known::default(),
            begun,
            format: place.line.format(),
        };
        Ok((port, may_be_reset))
    }

    /// The board at the port, once it has said which it is.
    pub fn board(&self) -> Board {
        self.known.board
    }

    /// Has a conversation with the board. That the port is gone is said to the conversation, which ends by it.
    pub fn talk<T>(&mut self, talk: impl AsyncFnOnce(&mut Client) -> T) -> T {
        let never = || ControlFlow::<Infallible>::Continue(());
        let ControlFlow::Continue(outcome) = self.attended(talk, never);
        outcome
    }

    /// The same, attended every 10 ms or sooner, until `attend` breaks it off.
    pub fn attended<T, B>(
        &mut self,
        talk: impl AsyncFnOnce(&mut Client) -> T,
        mut attend: impl FnMut() -> ControlFlow<B>,
    ) -> ControlFlow<B, T> {
        let mut conversation = Conversation::new(self.line, self.patience, talk);
        conversation.know(self.known);
        let mut came = Vec::new();
        loop {
            attend()?;
            let step = conversation.step(self.begun.elapsed(), &came);
            self.known = conversation.known();
            came.clear();
            let until = match step.next {
                Next::Done(outcome) => return ControlFlow::Continue(outcome),
                Next::Wait(until) => until,
            };
            let spoken = self.speak(step.format);
            if step.reset {
                self.reset();
            }
            let carried = spoken.and_then(|()| self.carry(&step.send, until, &mut came));
            if let Err(error) = carried {
                conversation.lose(messages::io(&error));
            }
        }
    }

    /// Sends and takes bytes in this form from now on.
    fn speak(&mut self, format: Format) -> io::Result<()> {
        if format != self.format {
            self.port.set_baud_rate(format.rate)?;
            self.port.set_parity(open::parity(format.parity))?;
            self.format = format;
        }
        Ok(())
    }

    /// Sends these bytes, and takes what comes until then, or until it is time to attend.
    fn carry(&mut self, send: &[u8], until: Duration, came: &mut Vec<u8>) -> io::Result<()> {
        if !send.is_empty() {
            // What has come before a request is no answer to it.
            self.port.clear(ClearBuffer::Input)?;
            self.port.write_all(send)?;
        }
        let left = until.saturating_sub(self.begun.elapsed());
        self.port.set_timeout(left.min(ATTEND))?;
        let mut chunk = [0; 256];
        match self.port.read(&mut chunk) {
            Ok(0) => Err(ErrorKind::UnexpectedEof.into()),
            Ok(count) => {
                came.extend(&chunk[..count]);
                Ok(())
            }
            Err(error) => match error.kind() {
                ErrorKind::TimedOut | ErrorKind::Interrupted => Ok(()),
                _ => Err(error),
            },
        }
    }
}

impl Port {
    /// Finds the board of another place at this port, which is open.
    ///
    /// # Errors
    /// [`NotFound`].
    pub fn seek(&mut self, place: &Place, may_be_reset: bool) -> Result<Identity, NotFound> {
        self.line = place.line;
        let found = self.talk(async |client| start::find(client, may_be_reset).await);
        found.map_err(|why| NotFound::at(place, why))
    }
}

/// A board that has answered.
pub struct Found {
    /// Its port.
    pub port: Port,
    /// What it says that it is.
    pub identity: Identity,
    /// Opening the port has probably reset it.
    pub may_be_reset: bool,
}

/// Why there is no board to speak to.
#[derive(Debug, thiserror::Error)]
pub enum NotFound {
    /// The port cannot be used.
    #[error(transparent)]
    Port(#[from] NotOpened),
    /// Nobody answers.
    #[error("{}", messages::no_answer(messages::spoken_line(*line), port))]
    Silent {
        /// Where it was sought.
        port: String,
        /// What was spoken.
        line: Line,
    },
    /// Something else comes than answers.
    #[error("{}", messages::no_modbus(port, line.rate, messages::parity(line.parity)))]
    Garbled {
        /// Where it was sought.
        port: String,
        /// What was spoken.
        line: Line,
    },
    /// Something else answers.
    #[error("{}", messages::no_unoclp(port, messages::foreign(foreign.as_ref())))]
    Foreign {
        /// Where it was sought.
        port: String,
        /// What it says that it is, if it says so.
        foreign: Option<Identity>,
    },
    /// The port has gone.
    #[error("{port}: {}", messages::failure(failure))]
    Failed {
        /// Where it was sought.
        port: String,
        /// What has happened.
        failure: Failure,
    },
}

/// Opens the port and finds the board. A board that this has reset is given the time to start.
///
/// # Errors
/// [`NotFound`].
pub fn find(place: &Place, patience: Patience) -> Result<Found, NotFound> {
    let (mut port, may_be_reset) = Port::open(place, patience)?;
    let identity = port.seek(place, may_be_reset)?;
    Ok(Found {
        port,
        identity,
        may_be_reset,
    })
}

impl NotFound {
    fn at(place: &Place, why: start::NotFound) -> NotFound {
        let Place { port, line } = place.clone();
        match why {
            start::NotFound::Silent => NotFound::Silent { port, line },
            start::NotFound::Garbled => NotFound::Garbled { port, line },
            start::NotFound::Foreign(foreign) => NotFound::Foreign { port, foreign },
            start::NotFound::Failed(failure) => NotFound::Failed { port, failure },
        }
    }
}
