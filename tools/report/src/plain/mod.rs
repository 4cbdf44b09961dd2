//! A topic a point: values as JSON, commands, availability, and what Home Assistant finds.
//!
//! - `topics`: the names of the topics
//! - `json`: a value as it is told
//! - `home`: what Home Assistant finds

mod home;
mod json;
#[cfg(test)]
mod tests;
mod topics;

use crate::backlog::{Backlog, MOST};
use crate::boards::{Boards, News, Sample};
use crate::change::Change;
use crate::command::{Command, Refusal, Rights, WAITING, value};
use crate::session::{Message, Now, Out, Session, Stand};
use home::Home;
use std::collections::VecDeque;
use std::time::Duration;
use topics::{Asked, Topics};
use unoclp_site::{Mqtt, Site};

/// What is said of a gateway or a board that is there, or not.
const ONLINE: &str = "online";
const OFFLINE: &str = "offline";
/// What is to be said before any sample: of more, no further refusal is told.
const URGENT: usize = 1_000;

/// The session of one gateway.
#[derive(Debug)]
pub(crate) struct Plain {
    boards: Boards,
    rights: Rights,
    topics: Topics,
    home: Option<Home>,
    every: Duration,
    /// When all values are told again.
    again: Duration,
    is_connected: bool,
    urgent: VecDeque<Out>,
    samples: Backlog<Message>,
    /// Commands that boards have not answered yet.
    under_way: usize,
}

impl Plain {
    /// That of this site.
    pub fn new(site: &Site, mqtt: &Mqtt) -> Plain {
        Plain {
            boards: Boards::new(site),
            rights: Rights::new(site, mqtt),
            topics: Topics::new(&mqtt.topic),
            home: mqtt.home_assistant.then(|| Home::new(&mqtt.topic)),
            every: mqtt.every,
            again: mqtt.every,
            is_connected: false,
            urgent: VecDeque::new(),
            samples: Backlog::new(MOST),
            under_way: 0,
        }
    }

    fn say(&mut self, topic: String, payload: impl Into<Vec<u8>>, retain: bool) {
        // Once there is a connection, all is said anew.
        if self.is_connected {
            self.urgent.push_back(Out::Publish(Message {
                topic,
                payload: payload.into(),
                retain,
                sure: true,
                sample: false,
            }));
        }
    }

    fn sample(&mut self, board: &str, point: &str, sample: Sample) {
        let Some(of) = self.boards.of(board).and_then(|board| board.point(point)) else {
            return;
        };
        self.samples.push(Message {
            topic: self.topics.point(board, point),
            payload: json::sample(of, sample).into_bytes(),
            retain: true,
            sure: true,
            sample: true,
        });
    }

    /// Says all that a broker may not know.
    fn tell_all(&mut self) {
        for at in 0..self.boards.all.len() {
            let Some(board) = self.boards.all.get(at) else {
                return;
            };
            let (name, up) = (board.name.clone(), board.up);
            if let Some(up) = up {
                self.tell_presence(&name, up);
            }
            self.tell_home(&name);
        }
        self.tell_values();
    }

    fn tell_values(&mut self) {
        let values = self.boards.all.iter().flat_map(|board| {
            let of =
                |(point, sample): (&String, &Sample)| (board.name.clone(), point.clone(), *sample);
            board.values.iter().map(of)
        });
        for (board, point, sample) in values.collect::<Vec<_>>() {
            self.sample(&board, &point, sample);
        }
    }

    fn tell_presence(&mut self, board: &str, up: bool) {
        let topic = self.topics.board(board);
        self.say(topic, if up { ONLINE } else { OFFLINE }, true);
    }

    /// Tells Home Assistant of a board, once its points are known.
    fn tell_home(&mut self, name: &str) {
        let (Some(home), Some(board)) = (&mut self.home, self.boards.of(name)) else {
            return;
        };
        if let Some((topic, payload)) = home.config(board, &self.rights, &self.topics) {
            self.say(topic, payload, true);
        }
    }

    fn refuse(&mut self, board: &str, point: &str, refusal: Refusal) {
        // Who is refused that often knows.
        if self.urgent.len() < URGENT && self.boards.of(board).is_some() {
            let topic = self.topics.refused(board);
            let payload = json::refused(point, refusal);
            self.say(topic, payload, false);
        }
    }

    fn command(&mut self, board: &str, point: &str, payload: &[u8]) -> Result<(), Refusal> {
        let value = value(payload)?;
        let command = self.rights.command(board, point, value)?;
        if self.under_way >= WAITING {
            return Err(Refusal::TooMany);
        }
        self.under_way += 1;
        self.urgent.push_back(Out::Carry(command));
        Ok(())
    }
}

impl Session for Plain {
    fn will(&mut self) -> Message {
        Message {
            topic: self.topics.gateway(),
            payload: OFFLINE.into(),
            retain: true,
            sure: true,
            sample: false,
        }
    }

    fn connected(&mut self, _: Now) {
        self.is_connected = true;
        self.urgent
            .push_back(Out::Subscribe(self.topics.commands()));
        if let Some(home) = &self.home {
            self.urgent.push_back(Out::Subscribe(home.status()));
        }
        let topic = self.topics.gateway();
        self.say(topic, ONLINE, true);
        self.tell_all();
    }

    fn lost(&mut self, unsure: Vec<Message>) {
        self.is_connected = false;
        let under_way = self.urgent.iter();
        let dropped = under_way.filter(|out| matches!(out, Out::Carry(_))).count();
        self.under_way = self.under_way.saturating_sub(dropped);
        self.urgent.clear();
        let samples = unsure.into_iter().filter(|message| message.sample);
        self.samples.put_back(samples.collect());
    }

    fn changed(&mut self, changes: &[Change], _: Now) {
        for news in self.boards.take(changes) {
            let News {
                board,
                turn,
                samples,
            } = news;
            for (point, sample) in samples {
                if !turn.gone.contains(&point) {
                    self.sample(&board, &point, sample);
                }
            }
            for point in &turn.gone {
                // What a broker keeps of a point that is no more would come back with each who asks.
                let topic = self.topics.point(&board, point);
                self.samples.push(Message {
                    topic,
                    payload: Vec::new(),
                    retain: true,
                    sure: true,
                    sample: true,
                });
            }
            if turn.is_other {
                self.tell_home(&board);
            }
        }
    }

    fn presence(&mut self, board: &str, up: bool, _: Now) {
        if let Some(of) = self.boards.of_mut(board) {
            of.up = Some(up);
            self.tell_presence(board, up);
        }
    }

    fn heard(&mut self, topic: &str, payload: &[u8], retained: bool, _: Now) {
        if let Some(home) = &self.home
            && topic == home.status()
        {
            if payload == ONLINE.as_bytes() {
                self.tell_all();
            }
            return;
        }
        let Some(Asked { board, point }) = self.topics.asked(topic) else {
            return;
        };
        let outcome = match retained {
            true => Err(Refusal::Retained),
            false => self.command(&board, &point, payload),
        };
        if let Err(refusal) = outcome {
            self.refuse(&board, &point, refusal);
        }
    }

    fn done(&mut self, command: &Command, outcome: Result<(), Refusal>, _: Now) {
        self.under_way = self.under_way.saturating_sub(1);
        if let Err(refusal) = outcome {
            self.refuse(&command.board, &command.grant.point, refusal);
        }
    }

    fn tick(&mut self, now: Now) {
        if now.since >= self.again {
            self.again = now.since + self.every;
            if self.is_connected {
                self.tell_values();
            }
        }
    }

    fn next(&mut self) -> Option<Out> {
        if !self.is_connected {
            return None;
        }
        let urgent = self.urgent.pop_front();
        urgent.or_else(|| self.samples.pop().map(Out::Publish))
    }

    fn farewell(&mut self, _: Now) -> Vec<Message> {
        vec![self.will()]
    }

    fn stand(&self) -> Stand {
        Stand {
            waiting: self.samples.len(),
            dropped: self.samples.dropped(),
        }
    }
}
