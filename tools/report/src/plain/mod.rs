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

use crate::alarm::Alarm;
use crate::boards::{Board, Boards, News, Sample};
use crate::change::Change;
use crate::command::{Refusal, Rights, Wish, value};
use crate::session::{Message, Now, Out, Session, UnderWay};
use home::Home;
use std::collections::{BTreeMap, VecDeque};
use std::time::Duration;
use topics::{Asked, Topics};
use unoclp_journal::Entry;
use unoclp_site::{Mqtt, Site};

/// What is said of a gateway or a board that is there, or not.
const ONLINE: &str = "online";
const OFFLINE: &str = "offline";
/// What is to be said before any sample: of more, no further refusal is told.
const URGENT: usize = 1_000;
/// As long as so many samples wait here, none are read from the journal.
const ENOUGH: usize = 64;

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
    /// What points were, in order,
    samples: VecDeque<Message>,
    /// as far as this entry of the journal.
    read: u64,
    /// All values are to be told again, once all of the journal is told.
    is_due: bool,
    under_way: UnderWay,
    /// The alarms of the site, each once somebody has said how it stands.
    alarms: BTreeMap<String, Option<Alarm>>,
}

impl Plain {
    /// That of this site, of whose journal the broker has all up to `read`.
    pub fn new(site: &Site, mqtt: &Mqtt, read: u64) -> Plain {
        Plain {
            boards: Boards::new(site),
            rights: Rights::new(site, mqtt),
            topics: Topics::new(&mqtt.topic),
            home: mqtt.home_assistant.then(|| Home::new(&mqtt.topic)),
            every: mqtt.every,
            again: mqtt.every,
            is_connected: false,
            urgent: VecDeque::new(),
            samples: VecDeque::new(),
            read,
            is_due: false,
            under_way: UnderWay::default(),
            alarms: site
                .alarms
                .iter()
                .map(|alarm| (alarm.name.clone(), None))
                .collect(),
        }
    }

    fn say(&mut self, topic: String, payload: impl Into<Vec<u8>>, retain: bool) {
        // Once there is a connection, all is said again.
        if self.is_connected {
            self.urgent.push_back(Out::Publish(Message {
                topic,
                payload: payload.into(),
                retain,
                sure: true,
                number: None,
            }));
        }
    }

    /// What a point was; `number`: the entry that says so.
    fn sample(&mut self, board: &str, point: &str, sample: Sample, number: Option<u64>) {
        let Some(of) = self.boards.of(board).and_then(|board| board.point(point)) else {
            return;
        };
        self.samples.push_back(Message {
            topic: self.topics.point(board, point),
            payload: json::sample(of, sample).into_bytes(),
            retain: true,
            sure: true,
            number,
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
        self.tell_home_alarms();
        for alarm in self.alarms.values().flatten().cloned().collect::<Vec<_>>() {
            self.tell_alarm(&alarm);
        }
        self.is_due = true;
    }

    fn tell_alarm(&mut self, alarm: &Alarm) {
        let topic = self.topics.alarm(&alarm.name);
        self.say(topic, json::alarm(alarm), true);
    }

    fn tell_values(&mut self) {
        let values = self.boards.all.iter().flat_map(|board| {
            let of =
                |(point, sample): (&String, &Sample)| (board.name.clone(), point.clone(), *sample);
            board.values.iter().map(of)
        });
        for (board, point, sample) in values.collect::<Vec<_>>() {
            self.sample(&board, &point, sample, None);
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

    /// Tells Home Assistant of the alarms, and of those that are no more.
    fn tell_home_alarms(&mut self) {
        let Some(home) = &mut self.home else {
            return;
        };
        let alarms = self.alarms.keys().map(|name| &**name);
        if let Some((topic, payload)) = home.alarms(alarms, &self.rights, &self.topics) {
            self.say(topic, payload, true);
        }
    }

    /// Tells what one reading of a board has changed.
    fn read_one(&mut self, entries: &[Entry]) {
        let last = entries.last().map(|last| last.number);
        let changes = entries.iter().map(|entry| (&entry.sample, entry.number));
        for news in self.boards.take(changes) {
            let News {
                board,
                turn,
                samples,
            } = news;
            for (point, sample) in samples {
                // Of a name that does not hold any more nothing is told.
                let points = self.boards.of(&board).map(Board::points);
                let points = points.unwrap_or_default();
                if points.is_empty() || points.iter().any(|of| of.name == point) {
                    self.sample(&board, &point, sample, Some(sample.number));
                }
            }
            for point in &turn.gone {
                // What a broker keeps of a point that is no more would come back with each who asks.
                let topic = self.topics.point(&board, point);
                self.samples.push_back(Message {
                    topic,
                    payload: Vec::new(),
                    retain: true,
                    sure: true,
                    number: last,
                });
            }
            if turn.is_other {
                self.tell_home(&board);
            }
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

    fn refuse_alarm(&mut self, alarm: &str, refusal: Refusal) {
        if self.urgent.len() < URGENT {
            let topic = self.topics.alarm_refused();
            self.say(topic, json::alarm_refused(alarm, refusal), false);
        }
    }

    fn carry(&mut self, wish: Wish) -> Result<(), Refusal> {
        self.urgent.push_back(self.under_way.carry(wish)?);
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
            number: None,
        }
    }

    fn connected(&mut self, _: Now) {
        self.is_connected = true;
        self.urgent
            .push_back(Out::Subscribe(self.topics.commands()));
        self.urgent.push_back(Out::Subscribe(self.topics.alarms()));
        let acknowledge = self.topics.acknowledge("+");
        self.urgent.push_back(Out::Subscribe(acknowledge));
        if let Some(home) = &self.home {
            self.urgent.push_back(Out::Subscribe(home.status()));
        }
        let topic = self.topics.gateway();
        self.say(topic, ONLINE, true);
        self.tell_all();
    }

    fn lost(&mut self, unsure: Vec<Message>) {
        self.is_connected = false;
        self.under_way.left_out(self.urgent.iter());
        self.urgent.clear();
        // What tells of no entry is said again by the next connection.
        let of_entry = |message: &Message| message.number.is_some();
        self.samples.retain(of_entry);
        for message in unsure.into_iter().filter(of_entry).rev() {
            self.samples.push_front(message);
        }
    }

    fn wants(&self) -> Option<u64> {
        (self.is_connected && self.samples.len() < ENOUGH).then_some(self.read)
    }

    fn read(&mut self, entries: &[Entry], last: u64, _: Now) {
        self.read = entries.last().map_or(last, |last| last.number);
        if entries.is_empty() && std::mem::take(&mut self.is_due) {
            self.tell_values();
        }
        // What one reading of a board has changed; so numbers of messages never fall.
        let is_of_one = |one: &Entry, other: &Entry| {
            (&one.sample.board, one.sample.at) == (&other.sample.board, other.sample.at)
        };
        for reading in entries.chunk_by(is_of_one) {
            self.read_one(reading);
        }
    }

    fn told(&self) -> Option<u64> {
        self.samples.is_empty().then_some(self.read)
    }

    fn changed(&mut self, _: &[Change], _: Now) {}

    fn presence(&mut self, board: &str, up: bool, _: Now) {
        if let Some(of) = self.boards.of_mut(board) {
            of.up = Some(up);
            self.tell_presence(board, up);
        }
    }

    fn alarm(&mut self, alarm: &Alarm, _: Now) {
        self.alarms.insert(alarm.name.clone(), Some(alarm.clone()));
        self.tell_alarm(alarm);
    }

    fn heard(&mut self, topic: &str, payload: &[u8], retained: bool, _: Now) {
        if let Some(alarm) = self.topics.alarm_of(topic) {
            // The broker has kept it from a site that had this alarm.
            if retained && !payload.is_empty() && !self.alarms.contains_key(alarm) {
                self.say(topic.to_owned(), Vec::new(), true);
                if let Some(home) = &mut self.home {
                    home.forget_alarm(alarm);
                    self.tell_home_alarms();
                }
            }
            return;
        }
        if let Some(alarm) = self.topics.acknowledged(topic) {
            let wish = match retained {
                true => Err(Refusal::Retained),
                false => acknowledges(payload).and_then(|()| self.rights.acknowledged(alarm)),
            };
            if let Err(refusal) = wish.and_then(|wish| self.carry(wish)) {
                self.refuse_alarm(alarm, refusal);
            }
            return;
        }
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
        let wish = match retained {
            true => Err(Refusal::Retained),
            false => value(payload).and_then(|value| self.rights.set(&board, &point, value)),
        };
        if let Err(refusal) = wish.and_then(|wish| self.carry(wish)) {
            self.refuse(&board, &point, refusal);
        }
    }

    fn done(&mut self, wish: &Wish, outcome: Result<(), Refusal>, _: Now) {
        self.under_way.done();
        match (wish, outcome) {
            (_, Ok(())) => {}
            (Wish::Set(command), Err(refusal)) => {
                self.refuse(&command.board, &command.grant.point, refusal);
            }
            (Wish::Acknowledge(alarm), Err(refusal)) => self.refuse_alarm(alarm, refusal),
        }
    }

    fn tick(&mut self, now: Now) {
        if now.since >= self.again {
            self.again = now.since + self.every;
            self.is_due = self.is_connected;
        }
    }

    fn next(&mut self) -> Option<Out> {
        if !self.is_connected {
            return None;
        }
        let urgent = self.urgent.pop_front();
        urgent.or_else(|| self.samples.pop_front().map(Out::Publish))
    }

    fn farewell(&mut self, _: Now) -> Vec<Message> {
        vec![self.will()]
    }

    fn dropped(&self) -> u64 {
        0
    }
}

/// Whether this is said to acknowledge: any value but 0 and `false`.
fn acknowledges(payload: &[u8]) -> Result<(), Refusal> {
    match value(payload)? {
        0.0 => Err(Refusal::NoValue),
        _ => Ok(()),
    }
}
