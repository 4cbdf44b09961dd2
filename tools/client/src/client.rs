//! Requests to a board, each sent until it is answered.

use crate::AT_A_LINE;
use crate::identity::Identity;
use crate::link::{Format, Gone, Link};
use crate::start_text::{QUIET, is_start_text};
use std::time::Duration;
use unoclp_core::Board;
use unoclp_modbus::client::{NoReply, Reply, Request};
use unoclp_modbus::map::{Command, Parity, Span, holding, setting};
use unoclp_modbus::{Exception, Table};

/// How a board is spoken to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// The board's address, 1 to 247.
    pub address: u8,
    /// Bits per second.
    pub rate: u32,
    /// The parity.
    pub parity: Parity,
}

impl Line {
    /// How bytes are sent on it.
    pub fn format(self) -> Format {
        Format {
            rate: self.rate,
            parity: self.parity,
        }
    }
}

impl Default for Line {
    /// That of a board that was never set otherwise.
    fn default() -> Line {
        Line {
            address: setting::ADDRESS.default as u8,
            rate: u32::from(setting::RATE.default) * 100,
            parity: Parity::default(),
        }
    }
}

/// How long to wait.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Patience {
    /// For an answer, besides the time that its bytes take on the line.
    pub answer: Duration,
    /// How often a request is sent until it is answered.
    pub attempts: u32,
    /// For a board from its reset on: boot loader, card and program memory take their time.
    pub start: Duration,
    /// For the answer to the end of an upload, while which the program is stored.
    pub store: Duration,
}

impl Default for Patience {
    fn default() -> Patience {
        Patience {
            answer: Duration::from_secs(1),
            attempts: 3,
            start: Duration::from_secs(8),
            store: Duration::from_secs(8),
        }
    }
}

/// Why a request has no result. Its words are those of whoever shows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// Nothing came back.
    Silent,
    /// What came back was no answer to it.
    Garbled,
    /// The board refuses it.
    Refused(Exception),
    /// The port is gone, and why.
    Lost(String),
}

impl From<Gone> for Failure {
    fn from(Gone(why): Gone) -> Failure {
        Failure::Lost(why)
    }
}

/// A board without these addresses is a board without what stands there.
pub(crate) fn if_there<T>(read: Result<T, Failure>) -> Result<Option<T>, Failure> {
    match read {
        Ok(read) => Ok(Some(read)),
        Err(Failure::Refused(Exception::IllegalDataAddress)) => Ok(None),
        Err(other) => Err(other),
    }
}

/// The client of one board, for one conversation.
pub struct Client {
    link: Link,
    address: u8,
    /// Silence between frames.
    gap: Duration,
    /// The longest request and the longest answer, on the line.
    transit: Duration,
    patience: Patience,
}

impl Client {
    pub(crate) fn new(link: Link, line: Line, patience: Patience) -> Client {
        let character = Duration::from_secs(11) / line.rate.max(1);
        Client {
            link,
            address: line.address,
            gap: (character * 4).max(Duration::from_millis(2)),
            transit: character * 512,
            patience,
        }
    }

    #[cfg(feature = "more")]
    pub(crate) fn link(&self) -> &Link {
        &self.link
    }

    /// How long it waits.
    pub fn patience(&self) -> Patience {
        self.patience
    }

    /// The board at the other end: a UNO until another has [said](Client::identify) what it is.
    pub fn board(&self) -> Board {
        self.link.board()
    }

    /// A span with as many points as the board has.
    pub(crate) fn span(&self, span: Span) -> Span {
        span.on(&self.board())
    }

    /// Whether the board has inputs that a second word forces.
    pub(crate) fn has_more_inputs(&self) -> bool {
        self.span(holding::FORCED_MORE).values > 0
    }

    /// Reads the bits of a span.
    ///
    /// # Errors
    /// As for every request: [`Failure`].
    pub async fn bits(&mut self, span: Span) -> Result<Vec<bool>, Failure> {
        let request = Request::read(self.address, span.table, span.first, span.addresses());
        let count = span.addresses().into();
        self.ask(&request, |reply| reply.bits().take(count).collect())
            .await
    }

    /// Reads words.
    ///
    /// # Errors
    /// [`Failure`].
    pub async fn words(
        &mut self,
        table: Table,
        first: u16,
        count: u16,
    ) -> Result<Vec<u16>, Failure> {
        let request = Request::read(self.address, table, first, count);
        self.ask(&request, |reply| reply.words().collect()).await
    }

    /// Writes a holding register.
    ///
    /// # Errors
    /// [`Failure`].
    pub async fn set_word(&mut self, span: Span, value: u16) -> Result<(), Failure> {
        let request = Request::write_word(self.address, span.first, value);
        self.ask(&request, |_| ()).await
    }

    /// Writes several holding registers, from the first of this span on; at most 123.
    ///
    /// # Errors
    /// [`Failure`].
    pub async fn set_words(&mut self, span: Span, values: &[u16]) -> Result<(), Failure> {
        match Request::write_words(self.address, span.first, values) {
            Some(request) => self.ask(&request, |_| ()).await,
            // No board takes as many.
            None => Err(Failure::Refused(Exception::IllegalDataValue)),
        }
    }

    /// Writes a coil.
    ///
    /// # Errors
    /// [`Failure`].
    pub async fn set_bit(&mut self, address: u16, on: bool) -> Result<(), Failure> {
        let request = Request::write_coil(self.address, address, on);
        self.ask(&request, |_| ()).await
    }

    /// As [`set_words`](Client::set_words), if the answer may take longer.
    pub(crate) async fn set_words_within(
        &mut self,
        answer: Duration,
        span: Span,
        values: &[u16],
    ) -> Result<(), Failure> {
        let usual = std::mem::replace(&mut self.patience.answer, answer);
        let outcome = self.set_words(span, values).await;
        self.patience.answer = usual;
        outcome
    }

    /// As [`forward`](Client::forward), if the answer may take longer.
    ///
    /// # Errors
    /// As there.
    pub async fn forward_within(
        &mut self,
        answer: Duration,
        request: &Request,
    ) -> Result<Vec<u8>, Failure> {
        let usual = std::mem::replace(&mut self.patience.answer, answer);
        let outcome = self.forward(request).await;
        self.patience.answer = usual;
        outcome
    }

    /// Asks what the board is.
    ///
    /// # Errors
    /// [`Failure`]; [`Failure::Garbled`] too for an identification without vendor, product and version.
    pub async fn identify(&mut self) -> Result<Identity, Failure> {
        let request = Request::identify(self.address);
        let identity = self.ask(&request, |reply| Identity::of(reply.texts()));
        let identity = identity.await?.ok_or(Failure::Garbled)?;
        self.link.meet(identity.board().unwrap_or(AT_A_LINE));
        Ok(identity)
    }

    /// What the board says of its own accord, until it has been quiet for `quiet` or has said it all.
    pub(crate) async fn listen(
        &mut self,
        quiet: Duration,
        is_all: impl Fn(&[u8]) -> bool,
    ) -> Result<Vec<u8>, Failure> {
        let mut said = Vec::new();
        while !is_all(&said) && self.link.receive(&mut said, self.now() + quiet).await? {}
        Ok(said)
    }

    /// The time of this step.
    pub(crate) fn now(&self) -> Duration {
        self.link.now()
    }

    /// Says nothing for so long, or until something is so: then true.
    ///
    /// # Errors
    /// [`Failure::Lost`].
    pub async fn pause(&self, pause: Duration, is_so: impl Fn() -> bool) -> Result<bool, Failure> {
        Ok(self.link.wait(self.now() + pause, is_so).await?)
    }

    /// Leaves a board alone that may be in its boot loader, until that has given up or the firmware has said its text.
    async fn rest(&mut self) -> Result<(), Failure> {
        let Some(until) = self.link.rests() else {
            return Ok(());
        };
        self.link.heard(true, until);
        let mut said = Vec::new();
        let mut quiet = until;
        while !is_start_text(&said) && self.link.receive(&mut said, quiet).await? {
            quiet = self.now() + QUIET;
        }
        Ok(())
    }

    /// Sends a request until it is answered; gives what there is to take from the answer.
    async fn ask<T>(
        &mut self,
        request: &Request,
        take: impl Fn(Reply<'_>) -> T,
    ) -> Result<T, Failure> {
        let mut failure = Failure::Silent;
        for _ in 0..self.patience.attempts {
            match self.attempt(request, &take).await {
                Err(Failure::Silent) => {}
                Err(Failure::Garbled) => failure = Failure::Garbled,
                other => return other,
            }
        }
        Err(failure)
    }

    async fn attempt<T>(
        &mut self,
        request: &Request,
        take: impl Fn(Reply<'_>) -> T,
    ) -> Result<T, Failure> {
        let came = self.forward(request).await?;
        match request.answer(&came) {
            Some(Ok(reply)) => Ok(take(reply)),
            Some(Err(NoReply::Refused(exception))) => Err(Failure::Refused(exception)),
            Some(Err(NoReply::Garbled)) | None => Err(Failure::Garbled),
        }
    }

    /// Sends a request once, of whatever client, and gives the whole frame of its answer; a refusal is one.
    ///
    /// # Errors
    /// [`Failure`], but not [`Failure::Refused`].
    pub async fn forward(&mut self, request: &Request) -> Result<Vec<u8>, Failure> {
        self.rest().await?;
        self.pause(self.gap, || false).await?;
        self.link.send(request.bytes());
        let asked = self.now();
        let until = asked + self.transit + self.patience.answer;
        let mut came = Vec::new();
        let is_answer = loop {
            if let Some(answer) = request.answer(&came) {
                break !matches!(answer, Err(NoReply::Garbled));
            }
            if !self.link.receive(&mut came, until).await? {
                let nothing = came.is_empty();
                self.link.heard(!nothing, asked);
                return Err(if nothing {
                    Failure::Silent
                } else {
                    Failure::Garbled
                });
            }
        };
        self.link.heard(true, asked);
        if is_answer {
            if request.written(holding::COMMAND) == Some(Command::Restart as u16) {
                self.link.begins_again();
            }
            return Ok(came);
        }
        // The rest of what is no answer is over before the next attempt.
        while self
            .link
            .receive(&mut came, self.now() + self.gap * 8)
            .await?
        {}
        Err(Failure::Garbled)
    }
}
