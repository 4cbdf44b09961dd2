//! Writes an image through a boot loader: bytes and the time go in, bytes and the next time come out.
//!
//! Whoever has the port carries the bytes, keeps the time, and resets the board where that is asked for:
//!
//! ```
//! use std::time::Duration;
//! use unoclp_boot::{Image, Model, Next, Writer};
//!
//! # struct Port(Duration);
//! # impl Port {
//! #     fn now(&mut self) -> Duration { self.0 += Duration::from_millis(100); self.0 }
//! #     fn reset(&mut self) {}
//! #     fn write(&mut self, _: &[u8]) {}
//! #     fn read_until(&mut self, _: Duration) -> Vec<u8> { Vec::new() }
//! # }
//! # let mut port = Port(Duration::ZERO);
//! # let hex = include_bytes!("../tests/stall.hex");
//! let image = Image::read(hex, Model::Uno).expect("a firmware");
//! let mut writer = Writer::new(&image);
//! let mut came = Vec::new();
//! let outcome = loop {
//!     let step = writer.step(port.now(), &came);
//!     if step.reset {
//!         // DTR off and on again, and what has come meanwhile is thrown away.
//!         port.reset();
//!     }
//!     port.write(&step.send);
//!     match step.next {
//!         Next::Done(outcome) => break outcome,
//!         // Whatever comes before that is passed on at once.
//!         Next::Wait(until) => came = port.read_until(until),
//!     }
//! };
//! assert!(outcome.is_err(), "nobody is there");
//! ```

use crate::failure::{self, Failure, Trouble};
use crate::image::Image;
use crate::message::Came;
use crate::model::{Model, Protocol};
use crate::script::{Exchange, Subject, script, stranger};
use crate::stage::Stage;
use std::time::Duration;
use unoclp_words::Lang;

/// How often the board is reset until its boot loader answers, and says which chip it is on.
const RESETS: u32 = 3;
/// So often then, to ask for one of the other kind.
const RESETS_OF_STRANGER: u32 = 2;
/// How often the boot loader is called after each reset. It waits for a second.
const CALLS: u32 = 2;
/// From a reset to the first call.
const WAKING: Duration = Duration::from_millis(100);
/// For the answer to a call: Optiboot blinks before it listens.
const CALL: Duration = Duration::from_millis(600);
/// Silence after the answer: late answers to earlier calls are over.
const QUIET: Duration = Duration::from_millis(50);
/// For every other answer: a page takes 9 ms to write and 50 ms on a slow line.
const ANSWER: Duration = Duration::from_millis(800);

/// An image on its way to a board.
#[derive(Clone, Debug)]
pub struct Writer {
    model: Model,
    /// How the boot loader is spoken to.
    protocol: Protocol,
    script: Vec<Exchange>,
    /// Another kind of boot loader is called, and asked which chip it is on.
    is_stranger: bool,
    signature: [u8; 3],
    /// How many exchanges are over.
    over: usize,
    state: State,
    resets: u32,
    /// What has come and is no answer yet.
    came: Vec<u8>,
    /// Something came while the boot loader was called.
    heard: bool,
    gone: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    /// The board is to be reset.
    Reset,
    /// It has just been.
    Waking,
    /// Not to be called before.
    Asleep(Duration),
    /// Called so many times; until then the answer may come.
    Called(u32, Duration),
    /// It has answered; nothing may come until then.
    Answered(Duration),
    /// The exchange is to begin.
    Ready,
    /// Its answer may come until then.
    Asked(Duration),
    /// It is over.
    Done,
}

/// What a step asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// First reset the board (on an Arduino: DTR off, for 50 ms or more, and on), and throw away what has come before.
    pub reset: bool,
    /// Then send these bytes.
    pub send: Vec<u8>,
    /// And then this.
    pub next: Next,
}

/// How it goes on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Next {
    /// By another step at this time, or as soon as bytes have come. A step before that does no harm.
    Wait(Duration),
    /// It is over: the image is on the board, has been read back and was started; or not.
    Done(Result<(), Failure>),
}

/// How far it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// What is being done.
    pub stage: Stage,
    /// So many requests have been answered.
    pub done: usize,
    /// Of so many.
    pub of: usize,
}

impl Writer {
    /// Writes this image. It begins with the first step.
    pub fn new(image: &Image) -> Writer {
        let model = image.model();
        Writer {
            model,
            protocol: model.chip().protocol,
            script: script(image),
            is_stranger: false,
            signature: [0; 3],
            over: 0,
            state: State::Reset,
            resets: 0,
            came: Vec::new(),
            heard: false,
            gone: None,
        }
    }

    /// At how many bits per second the boot loader is spoken to.
    pub fn rate(&self) -> u32 {
        self.model.rate()
    }

    /// How far it is.
    pub fn progress(&self) -> Progress {
        Progress {
            stage: self.stage(),
            done: self.over,
            of: self.script.len(),
        }
    }

    /// What the board holds where this ends now: its old firmware, or none.
    pub fn left(&self, lang: Lang) -> String {
        failure::left(self.stage(), lang)
    }

    /// The port is gone, and why: the next step says so.
    pub fn lose(&mut self, why: String) {
        self.gone = Some(why);
    }

    /// Goes on, at the time `now` since any moment, with the bytes that have come since the last step. After its end
    /// it waits forever.
    pub fn step(&mut self, now: Duration, came: &[u8]) -> Step {
        let mut send = Vec::new();
        let next = match self.go_on(now, came, &mut send) {
            Ok(until) => Next::Wait(until),
            Err(outcome) => {
                self.state = State::Done;
                Next::Done(outcome)
            }
        };
        let reset = self.state == State::Reset;
        if reset {
            self.state = State::Waking;
        }
        Step { reset, send, next }
    }

    /// Until when to wait, or how it has ended.
    fn go_on(
        &mut self,
        now: Duration,
        came: &[u8],
        send: &mut Vec<u8>,
    ) -> Result<Duration, Result<(), Failure>> {
        if self.state == State::Done {
            return Ok(Duration::MAX);
        }
        if let Some(why) = self.gone.take() {
            return Err(self.fail(Trouble::Lost(why)));
        }
        self.came.extend(came);
        loop {
            match self.state {
                State::Done => return Ok(Duration::MAX),
                State::Reset if self.resets == RESETS => {
                    if self.stage() != Stage::Meeting || self.is_stranger {
                        return Err(self.fail(match self.heard {
                            true => Trouble::Foreign,
                            false => Trouble::Silent,
                        }));
                    }
                    (self.protocol, self.script) = stranger(self.model.chip());
                    self.is_stranger = true;
                    self.resets = RESETS - RESETS_OF_STRANGER;
                }
                State::Reset => {
                    self.resets += 1;
                    return Ok(now);
                }
                State::Waking => {
                    // What came before the reset is not of the boot loader.
                    self.came.clear();
                    self.state = State::Asleep(now + WAKING);
                }
                State::Asleep(until) if now < until => return Ok(until),
                State::Asleep(_) => self.call(1, now, send),
                State::Called(calls, until) => {
                    if self.came.ends_with(&self.protocol.called()) {
                        self.state = State::Answered(now + QUIET);
                        continue;
                    }
                    if now < until {
                        return Ok(until);
                    }
                    self.heard |= !self.came.is_empty();
                    match calls {
                        CALLS => self.state = State::Reset,
                        _ => self.call(calls + 1, now, send),
                    }
                }
                State::Answered(until) if now < until => return Ok(until),
                State::Answered(_) => self.state = State::Ready,
                State::Ready => {
                    let Some(exchange) = self.script.get(self.over) else {
                        return Err(match self.is_stranger {
                            true => self.fail(Trouble::OtherChip {
                                signature: self.signature,
                                model: self.model,
                            }),
                            false => Ok(()),
                        });
                    };
                    self.came.clear();
                    if exchange.request.is_empty() {
                        self.over += 1;
                        self.resets = 0;
                        self.state = State::Reset;
                        continue;
                    }
                    send.extend(&exchange.request);
                    self.state = State::Asked(now + ANSWER);
                    return Ok(now + ANSWER);
                }
                State::Asked(until) => {
                    match self.is_answered(now >= until) {
                        Ok(false) => return Ok(until),
                        Ok(true) => {
                            self.over += 1;
                            self.state = State::Ready;
                        }
                        // A busy computer misses the second in which the boot loader waits. Nothing is written yet.
                        Err(Trouble::BrokenOff | Trouble::Garbled)
                            if self.stage() == Stage::Meeting && self.resets < RESETS =>
                        {
                            self.over = 0;
                            self.state = State::Reset;
                        }
                        Err(trouble) => return Err(self.fail(trouble)),
                    }
                }
            }
        }
    }

    fn call(&mut self, calls: u32, now: Duration, send: &mut Vec<u8>) {
        self.came.clear();
        send.extend(self.protocol.call());
        self.state = State::Called(calls, now + CALL);
    }

    /// Whether the answer to the exchange has come, and is right.
    fn is_answered(&mut self, is_late: bool) -> Result<bool, Trouble> {
        let Some(exchange) = self.script.get(self.over) else {
            return Ok(true);
        };
        // The last asks to be started, which the boot loader does of its own accord where it is not asked.
        let is_last = self.over + 1 == self.script.len() && !self.is_stranger;
        let says = match exchange.answer.read(&self.came) {
            Came::Less if !is_late => return Ok(false),
            _ if is_last => return Ok(true),
            Came::Less => return Err(Trouble::BrokenOff),
            Came::Garbled => return Err(Trouble::Garbled),
            Came::All(says) => says,
        };
        let trouble = match &exchange.subject {
            Subject::Order => None,
            Subject::Signature(from) => {
                for (place, &byte) in self.signature.iter_mut().skip(*from).zip(says) {
                    *place = byte;
                }
                let is_known = from + says.len() == self.signature.len();
                let is_other = self.signature != self.model.chip().signature;
                (is_known && is_other).then_some(Trouble::OtherChip {
                    signature: self.signature,
                    model: self.model,
                })
            }
            Subject::Flash(address, page) => differs(*address, page, says),
        };
        match trouble {
            Some(trouble) => Err(trouble),
            None => Ok(true),
        }
    }

    /// The stage of the exchange that is to be answered next.
    fn stage(&self) -> Stage {
        let exchange = self.script.get(self.over);
        exchange.map_or(Stage::Finishing, |exchange| exchange.stage)
    }

    fn fail(&self, trouble: Trouble) -> Result<(), Failure> {
        Err(Failure {
            trouble,
            stage: self.stage(),
        })
    }
}

/// What is wrong with flash that was read from this address on, if anything is.
fn differs(address: u32, written: &[u8], read: &[u8]) -> Option<Trouble> {
    let mut pairs = (address..).zip(written.iter().zip(read));
    let (address, (&written, &read)) = pairs.find(|(_, (written, read))| written != read)?;
    Some(Trouble::Differs {
        address,
        written,
        read,
    })
}
