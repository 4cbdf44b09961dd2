//! What a connection to a broker says and hears, one connection after the other, without I/O.

use crate::change::Change;
use crate::command::{Command, Refusal};
use std::time::Duration;

/// A message for the broker.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Message {
    pub topic: String,
    pub payload: Vec<u8>,
    /// The broker keeps it for whoever comes later.
    pub retain: bool,
    /// The broker says that it has it (QoS 1); else it may be lost (QoS 0).
    pub sure: bool,
    /// It is what a point was: until the broker has it, it is sent again.
    pub sample: bool,
}

/// What is to be done.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Out {
    /// This is sent.
    Publish(Message),
    /// Messages with these topics are asked for.
    Subscribe(String),
    /// A board is told this value; what becomes of it is told by [`Session::done`].
    Carry(Command),
    /// This connection ends, and another begins.
    Leave,
}

/// When something happens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Now {
    /// ms since 1970, by the clock of the PC, which somebody may set.
    pub at: i64,
    /// Since the beginning, by a clock that nobody sets.
    pub since: Duration,
}

/// How much waits, and what was given up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Stand {
    pub waiting: usize,
    pub dropped: u64,
}

/// What is said and heard.
pub(crate) trait Session: Send + Sync {
    /// What the broker says for us once the next connection is lost. A connection begins with it.
    fn will(&mut self) -> Message;
    /// The broker has taken the connection.
    fn connected(&mut self, now: Now);
    /// The connection is gone. The broker has not said that it has these.
    fn lost(&mut self, unsure: Vec<Message>);
    /// Points of boards have changed.
    fn changed(&mut self, changes: &[Change], now: Now);
    /// A board is there, or away.
    fn presence(&mut self, board: &str, up: bool, now: Now);
    /// A message has come.
    fn heard(&mut self, topic: &str, payload: &[u8], retained: bool, now: Now);
    /// What has become of a command.
    fn done(&mut self, command: &Command, outcome: Result<(), Refusal>, now: Now);
    /// Time has passed.
    fn tick(&mut self, now: Now);
    /// What is to be done next, while there is a connection.
    fn next(&mut self) -> Option<Out>;
    /// What is said before an end that is meant.
    fn farewell(&mut self, now: Now) -> Vec<Message>;
    /// How it stands.
    fn stand(&self) -> Stand;
}
