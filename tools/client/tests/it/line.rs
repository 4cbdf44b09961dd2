//! The line between a conversation and the board in memory.

use crate::fake::{Board, Fate, Trick, answer};
use std::collections::VecDeque;
use std::time::Duration;
use unoclp_client::{Client, Conversation, Known, Line, Next, Patience};

pub const MS: Duration = Duration::from_millis(1);

/// What a client waits by default; tests that wait in vain wait no real time.
pub const PATIENCE: Patience = Patience {
    answer: Duration::from_millis(100),
    attempts: 3,
    start: Duration::from_secs(8),
    store: Duration::from_secs(8),
};

/// A board at the end of a line.
pub struct Wire {
    pub board: Board,
    trick: Trick,
    /// The time.
    pub now: Duration,
    /// What is on its way to the client, and when it comes.
    coming: VecDeque<(Duration, Vec<u8>)>,
    /// How long an answer takes, and the pause after each of its bytes.
    pub delay: Duration,
    pub byte: Duration,
    /// The times at which requests were sent, with what they were.
    pub sent: Vec<(Duration, Vec<u8>)>,
    /// What conversations know of the board, each from the one before it.
    known: Known,
}

impl Wire {
    /// A board that answers.
    pub fn new(board: Board) -> Wire {
        Wire::with(board, |_, _| Fate::Answered)
    }

    /// A board whose requests, each without its checksum, meet the fate that the trick says.
    pub fn with(
        board: Board,
        trick: impl FnMut(&mut Board, &[u8]) -> Fate + Send + 'static,
    ) -> Wire {
        Wire {
            board,
            trick: Box::new(trick),
            now: Duration::from_secs(1_000_000),
            coming: VecDeque::new(),
            delay: 3 * MS,
            byte: Duration::ZERO,
            sent: Vec::new(),
            known: Known::default(),
        }
    }

    /// Something comes that nobody has asked for, at this time from now on.
    pub fn say(&mut self, within: Duration, text: &[u8]) {
        self.come(self.now + within, text.to_vec());
    }

    /// Has a conversation, from its first step to its end.
    pub fn talk<T>(&mut self, talk: impl AsyncFnOnce(&mut Client) -> T) -> T {
        self.talk_with(PATIENCE, talk)
    }

    /// The same with this patience.
    pub fn talk_with<T>(
        &mut self,
        patience: Patience,
        talk: impl AsyncFnOnce(&mut Client) -> T,
    ) -> T {
        let mut conversation = Conversation::new(Line::default(), patience, talk);
        conversation.know(self.known);
        let mut came = Vec::new();
        loop {
            let step = conversation.step(self.now, &came);
            self.known = conversation.known();
            if !step.send.is_empty() && self.carry(&step.send) == Fate::Unplugged {
                conversation.lose("unplugged".to_owned());
            }
            let until = match step.next {
                Next::Done(outcome) => return outcome,
                Next::Wait(until) => until,
            };
            assert!(until < Duration::MAX, "it waits forever");
            came = match self.coming.pop_front_if(|(at, _)| *at <= until) {
                Some((at, bytes)) => {
                    self.now = self.now.max(at);
                    bytes
                }
                None => {
                    self.now = self.now.max(until);
                    Vec::new()
                }
            };
        }
    }

    /// Brings a request to the board, and its answer onto the line.
    fn carry(&mut self, request: &[u8]) -> Fate {
        self.sent.push((self.now, request.to_vec()));
        let (fate, reply) = answer(&mut self.board, &mut self.trick, request);
        let mut at = self.now + self.delay;
        if fate == Fate::Slow {
            at += 4000 * MS;
        }
        for byte in reply {
            self.come(at, vec![byte]);
            at += self.byte;
        }
        fate
    }

    fn come(&mut self, at: Duration, bytes: Vec<u8>) {
        let behind = self.coming.partition_point(|(other, _)| *other <= at);
        self.coming.insert(behind, (at, bytes));
    }
}
