//! The gateway as an edge node of Sparkplug B, and its boards as devices (*Sparkplug 3.0.0*).
//!
//! - `topics`: the names of the topics
//! - `payload`: what a message holds
//! - `host`: whether the primary host is there
//! - `alarms`: the alarms as metrics of the node
//!
//! A node is born once it is connected and its primary host is there, if it has one: NBIRTH, then DBIRTH of each board that
//! is there. What changes meanwhile waits, and is sent after the births as historical. Where a board is away, or has other
//! points, its death and birth say so.

mod alarms;
mod host;
mod payload;
mod topics;

use crate::alarm::Alarm;
use crate::backlog::{Backlog, MOST};
use crate::boards::{Boards, News};
use crate::change::Change;
use crate::command::{Refusal, Rights, Wish};
use crate::session::{Message, Now, Out, Session, UnderWay};
use alarms::Alarms;
use host::{Host, Turn};
use payload::{Held, Metric, Payload, datatype, time};
use prost::Message as _;
use std::collections::{BTreeSet, VecDeque};
use topics::{Came, Topics};
use unoclp_journal::Entry;
use unoclp_site::{Mqtt, Site, Sparkplug};

/// The command that asks for all births again.
const REBIRTH: &str = "Node Control/Rebirth";
/// By this a death names its birth.
const BD_SEQ: &str = "bdSeq";

/// What a board was while nobody heard it.
#[derive(Clone, Debug)]
struct Past {
    board: String,
    metrics: Vec<Metric>,
}

impl Past {
    fn of(board: String, metrics: Vec<Metric>) -> Past {
        let past = |metric| Metric {
            is_historical: Some(true),
            ..metric
        };
        Past {
            board,
            metrics: metrics.into_iter().map(past).collect(),
        }
    }
}

/// The session of one edge node.
#[derive(Debug)]
pub(crate) struct Node {
    boards: Boards,
    alarms: Alarms,
    rights: Rights,
    topics: Topics,
    host: Host,
    is_connected: bool,
    is_born: bool,
    /// The devices that are born.
    born: BTreeSet<String>,
    /// The number of the next message, from 0 with each birth of the node.
    seq: u8,
    /// The number of this birth and of its death.
    bd_seq: u8,
    out: VecDeque<Out>,
    past: Backlog<Past>,
    /// Entries of the journal that nobody has heard of before this gateway began: after the first of these, up to the other.
    unheard: Option<(u64, u64)>,
    under_way: UnderWay,
}

impl Node {
    /// That of this site. Births are counted from `first` on: after a restart the death of the last one may still come. Of the
    /// journal, nobody has heard what stands after the first of `unheard`, up to the other.
    pub fn new(site: &Site, mqtt: &Mqtt, of: &Sparkplug, first: u8, unheard: (u64, u64)) -> Node {
        Node {
            boards: Boards::new(site),
            alarms: Alarms::new(site, mqtt.acknowledge),
            rights: Rights::new(site, mqtt),
            topics: Topics::new(of),
            host: Host::new(of.host.is_some()),
            is_connected: false,
            is_born: false,
            born: BTreeSet::new(),
            seq: 0,
            bd_seq: first,
            out: VecDeque::new(),
            past: Backlog::new(MOST),
            unheard: Some(unheard).filter(|(after, last)| after < last),
            under_way: UnderWay::default(),
        }
    }

    fn bd_seq(&self) -> Metric {
        Metric {
            name: Some(BD_SEQ.to_owned()),
            datatype: Some(datatype::INT64),
            value: Some(Held::Long(self.bd_seq.into())),
            ..Metric::default()
        }
    }

    /// The death of this birth. It alone has no number of its own.
    fn death(&self) -> Message {
        let payload = Payload {
            metrics: vec![self.bd_seq()],
            ..Payload::default()
        };
        Message {
            topic: self.topics.node("NDEATH"),
            payload: payload.encode_to_vec(),
            retain: false,
            sure: true,
            number: None,
        }
    }

    fn say(&mut self, topic: String, metrics: Vec<Metric>, now: Now) {
        let payload = Payload {
            timestamp: Some(time(now.at)),
            metrics,
            seq: Some(self.seq.into()),
        };
        self.seq = self.seq.wrapping_add(1);
        self.out.push_back(Out::Publish(Message {
            topic,
            payload: payload.encode_to_vec(),
            retain: false,
            sure: false,
            number: None,
        }));
    }

    /// All births, as far as they are due.
    fn birth(&mut self, now: Now) {
        if !self.is_connected || !self.host.is_there() {
            return;
        }
        self.is_born = true;
        self.born.clear();
        self.seq = 0;
        let rebirth = Metric {
            name: Some(REBIRTH.to_owned()),
            datatype: Some(datatype::BOOLEAN),
            value: Some(Held::Boolean(false)),
            ..Metric::default()
        };
        let metrics = [self.bd_seq(), rebirth].map(|metric| Metric {
            timestamp: Some(time(now.at)),
            ..metric
        });
        let metrics = metrics.into_iter().chain(self.alarms.metrics(now.at));
        self.say(self.topics.node("NBIRTH"), metrics.collect(), now);
        let names: Vec<String> = self.boards.all.iter().map(|of| of.name.clone()).collect();
        for name in names {
            self.birth_of(&name, now);
        }
        self.tell_past(now);
    }

    /// The birth of a board that is there and whose points are known.
    fn birth_of(&mut self, name: &str, now: Now) {
        let Some(board) = self.boards.of(name).filter(|_| self.is_born) else {
            return;
        };
        if board.up == Some(false) || board.points().is_empty() {
            return;
        }
        let metric = |point: &unoclp_site::Point| {
            let sample = board.values.get(&point.name);
            let value = sample.and_then(|sample| sample.value);
            Metric::of(point, value, sample.map_or(now.at, |sample| sample.at))
        };
        let metrics = board.points().iter().map(metric).collect();
        self.say(self.topics.device("DBIRTH", name), metrics, now);
        self.born.insert(name.to_owned());
    }

    fn death_of(&mut self, name: &str, now: Now) {
        if self.born.remove(name) {
            self.say(self.topics.device("DDEATH", name), Vec::new(), now);
        }
    }

    /// What boards were while nobody heard them, as far as their points are those of their births.
    fn tell_past(&mut self, now: Now) {
        for _ in 0..self.past.len() {
            let Some(Past { board, metrics }) = self.past.pop() else {
                return;
            };
            if !self.born.contains(&board) {
                self.past.push(Past { board, metrics });
                continue;
            }
            let Some(of) = self.boards.of(&board) else {
                continue;
            };
            let is_of_birth = |name: &str| of.points().iter().any(|point| point.name == name);
            let mut names = metrics.iter().filter_map(|of| of.name.as_deref());
            if !names.any(is_of_birth) {
                self.past.give_up();
                continue;
            }
            // What is so still, the birth has said.
            let is_over = |metric: &Metric| {
                let name = metric.name.as_deref().filter(|name| is_of_birth(name));
                let now = name.and_then(|name| of.values.get(name));
                now.is_some_and(|now| Some(time(now.at)) != metric.timestamp)
            };
            let metrics: Vec<_> = metrics.into_iter().filter(is_over).collect();
            if !metrics.is_empty() {
                self.say(self.topics.device("DDATA", &board), metrics, now);
            }
        }
    }

    /// The value that a point has, as a host that has asked for another one shall see it.
    fn tell(&mut self, board: &str, point: &str, now: Now) {
        let Some(of) = self.boards.of(board).filter(|_| self.born.contains(board)) else {
            return;
        };
        let (Some(point), Some(sample)) = (of.point(point), of.values.get(point)) else {
            return;
        };
        let metric = Metric::of(point, sample.value, sample.at);
        self.say(self.topics.device("DDATA", board), vec![metric], now);
    }

    /// How an alarm stands, told to whoever has heard the birth.
    fn tell_alarm(&mut self, alarm: &str, now: Now) {
        let metrics = self.alarms.metrics_of(alarm, now.at);
        if self.is_born && !metrics.is_empty() {
            self.say(self.topics.node("NDATA"), metrics, now);
        }
    }

    fn carry(&mut self, wish: Wish) -> Result<(), Refusal> {
        self.out.push_back(self.under_way.carry(wish)?);
        Ok(())
    }

    fn command(&mut self, device: &str, metric: &Metric) -> Result<(), Refusal> {
        let name = metric.name.as_deref().ok_or(Refusal::NoValue)?;
        let board = self.boards.of(device).ok_or(Refusal::NotAllowed)?;
        let point = board.point(name).ok_or(Refusal::NotAllowed)?;
        let value = metric.number(point).ok_or(Refusal::NoValue)?;
        let wish = self.rights.set(device, name, value)?;
        self.carry(wish)
    }

    fn commands(&mut self, device: &str, payload: &Payload, now: Now) {
        for metric in &payload.metrics {
            if self.command(device, metric).is_err()
                && let Some(name) = &metric.name
            {
                self.tell(device, name, now);
            }
        }
    }
}

impl Session for Node {
    fn will(&mut self) -> Message {
        self.bd_seq = self.bd_seq.wrapping_add(1);
        self.death()
    }

    fn connected(&mut self, now: Now) {
        self.is_connected = true;
        let filters = self.topics.filters();
        self.out.extend(filters.into_iter().map(Out::Subscribe));
        self.birth(now);
    }

    fn lost(&mut self, _: Vec<Message>) {
        self.is_connected = false;
        self.is_born = false;
        self.born.clear();
        self.under_way.left_out(self.out.iter());
        self.host.forget();
        self.out.clear();
    }

    fn wants(&self) -> Option<u64> {
        self.unheard.map(|(after, _)| after)
    }

    fn read(&mut self, entries: &[Entry], _: u64, now: Now) {
        let Some((_, last)) = self.unheard.take() else {
            return;
        };
        for Entry { sample, .. } in entries.iter().filter(|entry| entry.number <= last) {
            let board = self.boards.of(&sample.board);
            let Some(point) = board.and_then(|board| board.point(&sample.point)) else {
                continue;
            };
            let metric = Metric::of(point, sample.value, sample.at);
            self.past.push(Past::of(sample.board.clone(), vec![metric]));
        }
        let read = entries.last().map_or(last, |entry| entry.number);
        self.unheard = Some((read, last)).filter(|(read, last)| read < last);
        if self.is_born {
            self.tell_past(now);
        }
    }

    fn told(&self) -> Option<u64> {
        let is_told = self.is_born && self.unheard.is_none() && self.past.len() == 0;
        // Readings are told at once, so that all that the journal has is told.
        (is_told && self.out.is_empty()).then_some(u64::MAX)
    }

    fn changed(&mut self, changes: &[Change], now: Now) {
        for news in self.boards.take(changes.iter().map(|change| (change, 0))) {
            let News {
                board,
                turn,
                samples,
            } = news;
            let is_born = self.born.contains(&board);
            if is_born && turn.is_other {
                self.death_of(&board, now);
            }
            if self.is_born && (turn.is_other || !is_born) {
                self.birth_of(&board, now);
                self.tell_past(now);
                if self.born.contains(&board) {
                    continue;
                }
            }
            let Some(of) = self.boards.of(&board) else {
                continue;
            };
            let metric = |(name, sample): (String, crate::boards::Sample)| {
                let point = of.point(&name)?;
                Some(Metric::of(point, sample.value, sample.at))
            };
            let metrics: Vec<_> = samples.into_iter().filter_map(metric).collect();
            if self.born.contains(&board) {
                self.say(self.topics.device("DDATA", &board), metrics, now);
            } else {
                self.past.push(Past::of(board, metrics));
            }
        }
    }

    fn alarm(&mut self, alarm: &Alarm, now: Now) {
        self.alarms.take(alarm);
        self.tell_alarm(&alarm.name, now);
    }

    fn presence(&mut self, board: &str, up: bool, now: Now) {
        let Some(of) = self.boards.of_mut(board) else {
            return;
        };
        of.up = Some(up);
        if !up {
            self.death_of(board, now);
        } else if !self.born.contains(board) {
            self.birth_of(board, now);
            self.tell_past(now);
        }
    }

    fn heard(&mut self, topic: &str, payload: &[u8], retained: bool, now: Now) {
        let Some(came) = self.topics.came(topic) else {
            return;
        };
        if came == Came::State {
            match self.host.heard(payload) {
                Turn::Same => {}
                Turn::There => self.birth(now),
                Turn::Away => {
                    if self.is_born {
                        self.out.push_back(Out::Publish(self.death()));
                        self.is_born = false;
                        self.born.clear();
                        self.out.push_back(Out::Leave);
                    }
                }
            }
            return;
        }
        // What a broker has kept, nobody asks for now.
        let Some(payload) = Payload::decode(payload).ok().filter(|_| !retained) else {
            return;
        };
        match came {
            Came::State => {}
            Came::Node => {
                let is_on = |metric: &&Metric| metric.value == Some(Held::Boolean(true));
                let asked = payload.metrics.iter().filter(is_on);
                let asked: Vec<&str> = asked.filter_map(|metric| metric.name.as_deref()).collect();
                if asked.contains(&REBIRTH) {
                    self.birth(now);
                }
                for alarm in asked.into_iter().filter_map(alarms::acknowledged) {
                    let wish = self.rights.acknowledged(alarm);
                    if wish.and_then(|wish| self.carry(wish)).is_err() {
                        self.tell_alarm(alarm, now);
                    }
                }
            }
            Came::Device(device) => self.commands(&device, &payload, now),
        }
    }

    fn done(&mut self, wish: &Wish, outcome: Result<(), Refusal>, now: Now) {
        self.under_way.done();
        match (wish, outcome) {
            (_, Ok(())) => {}
            (Wish::Set(command), Err(_)) => self.tell(&command.board, &command.grant.point, now),
            (Wish::Acknowledge(alarm), Err(_)) => self.tell_alarm(alarm, now),
        }
    }

    fn tick(&mut self, _: Now) {}

    fn next(&mut self) -> Option<Out> {
        self.out.pop_front().filter(|_| self.is_connected)
    }

    fn farewell(&mut self, _: Now) -> Vec<Message> {
        // Who was not born does not die.
        let death = self.is_born.then(|| self.death());
        death.into_iter().collect()
    }

    fn dropped(&self) -> u64 {
        self.past.dropped()
    }
}
