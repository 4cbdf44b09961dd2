//! What a connection to a broker says and hears, one connection after the other, without I/O.

use crate::alarm::Alarm;
use crate::change::Change;
use crate::command::{Refusal, WAITING, Wish};
use std::time::Duration;
use unoclp_journal::Entry;

/// A message for the broker.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Message {
    pub topic: String,
    pub payload: Vec<u8>,
    /// The broker keeps it for whoever comes later.
    pub retain: bool,
    /// The broker says that it has it (QoS 1); else it may be lost (QoS 0).
    pub sure: bool,
    /// Once the broker has it, all entries of the journal up to this number are told; none: it tells of no entry.
    pub number: Option<u64>,
}

/// What is to be done.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Out {
    /// This is sent.
    Publish(Message),
    /// Messages with these topics are asked for.
    Subscribe(String),
    /// This shall be done; what becomes of it is told by [`Session::done`].
    Carry(Wish),
    /// This connection ends, and another begins.
    Leave,
}

/// How many wishes are not done yet.
#[derive(Debug, Default)]
pub(crate) struct UnderWay(usize);

impl UnderWay {
    /// What has a wish carried out, unless too many wait.
    pub fn carry(&mut self, wish: Wish) -> Result<Out, Refusal> {
        if self.0 >= WAITING {
            return Err(Refusal::TooMany);
        }
        self.0 += 1;
        Ok(Out::Carry(wish))
    }

    /// One is done.
    pub fn done(&mut self) {
        self.0 = self.0.saturating_sub(1);
    }

    /// Those of what is left out will not be done.
    pub fn left_out<'o>(&mut self, out: impl Iterator<Item = &'o Out>) {
        let count = out.filter(|out| matches!(out, Out::Carry(_))).count();
        self.0 = self.0.saturating_sub(count);
    }
}

/// When something happens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Now {
    /// ms since 1970, by the clock of the PC, which somebody may set.
    pub at: i64,
    /// Since the beginning, by a clock that nobody sets.
    pub since: Duration,
}

/// What is said and heard.
pub(crate) trait Session: Send + Sync {
    /// What the broker says for us once the next connection is lost. A connection begins with it.
    fn will(&mut self) -> Message;
    /// The broker has taken the connection.
    fn connected(&mut self, now: Now);
    /// The connection is gone. The broker has not said that it has these.
    fn lost(&mut self, unsure: Vec<Message>);
    /// After which entry of the journal more are wanted now; none: no more are.
    fn wants(&self) -> Option<u64>;
    /// These are the next entries of the journal, of which `last` is the last one; none: there are no more for now.
    fn read(&mut self, entries: &[Entry], last: u64, now: Now);
    /// Up to which entry all is told, once the broker has all messages that are on their way; none where something waits.
    fn told(&self) -> Option<u64>;
    /// Points of boards have changed just now. They are in the journal too, or will be.
    fn changed(&mut self, changes: &[Change], now: Now);
    /// A board is there, or away.
    fn presence(&mut self, board: &str, up: bool, now: Now);
    /// An alarm stands so from now on.
    fn alarm(&mut self, alarm: &Alarm, now: Now);
    /// A message has come.
    fn heard(&mut self, topic: &str, payload: &[u8], retained: bool, now: Now);
    /// What has become of a wish.
    fn done(&mut self, wish: &Wish, outcome: Result<(), Refusal>, now: Now);
    /// Time has passed.
    fn tick(&mut self, now: Now);
    /// What is to be done next, while there is a connection.
    fn next(&mut self) -> Option<Out>;
    /// What is said before an end that is meant.
    fn farewell(&mut self, now: Now) -> Vec<Message>;
    /// Samples that were given up here.
    fn dropped(&self) -> u64;
}
