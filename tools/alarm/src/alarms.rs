//! The thread that judges the alarms of a site, and who asks it.

use crate::engine::Engine;
use crate::state::{State, Turn};
use std::collections::BTreeMap;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};
use unoclp_record::{Asked, Failure, Happening, Record, now};
use unoclp_site::{Alarm, Severity, Text};

/// What waits for the thread. Whoever brings more waits for it.
const WAITING: usize = 4_096;
/// How long nothing need come.
const IDLE: Duration = Duration::from_secs(3_600);

/// What others see of an alarm.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Standing {
    /// What it is called.
    pub name: String,
    /// What is said of it.
    pub text: Text,
    /// How severe it is.
    pub severity: Severity,
    /// The boards whose points its condition reads, each once.
    pub boards: Vec<String>,
    /// How it stands.
    pub state: State,
    /// Since when: ms since 1970; none where that was always so.
    pub since: Option<i64>,
    /// Who has acknowledged it last, where somebody has.
    pub who: Option<String>,
}

/// What a point is.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// The board.
    pub board: String,
    /// The point.
    pub point: String,
    /// The value; none where it is not known any more.
    pub value: Option<f64>,
}

/// Why an alarm is not acknowledged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotDone {
    /// There is no alarm of this name.
    NoAlarm,
    /// It needs no acknowledging.
    Nothing,
    /// Alarms are not judged any more.
    Ended,
}

/// Hears how an alarm stands, each time that changes, and how it did at the beginning (no turn).
pub type Hear = Box<dyn Fn(&Standing, Option<Turn>) + Send>;

enum Input {
    Changed(Vec<Value>),
    Presence(String, bool),
    Acknowledge(String, String, SyncSender<Result<State, NotDone>>),
}

/// The alarms of a site. With the last of it they are judged no more.
pub struct Alarms {
    inputs: Mutex<Option<SyncSender<Input>>>,
    standing: Arc<Mutex<Vec<Standing>>>,
    record: Arc<Record>,
    thread: Mutex<Option<JoinHandle<()>>>,
}

impl std::fmt::Debug for Alarms {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Alarms")
    }
}

impl Alarms {
    /// Begins to judge, where the record has ended. What becomes of alarms is put into it, and then told.
    ///
    /// # Errors
    /// Where the record cannot be read.
    pub fn begin(alarms: Vec<Alarm>, record: Arc<Record>, hear: Hear) -> Result<Alarms, Failure> {
        let last = record.last()?.into_iter();
        let last: BTreeMap<String, Happening> = last.map(|of| (of.alarm.clone(), of)).collect();
        let standing = alarms.iter().map(|of| standing(of, last.get(&of.name)));
        let standing: Arc<Mutex<Vec<Standing>>> = Arc::new(Mutex::new(standing.collect()));
        let (send, inputs) = sync_channel(WAITING);
        let thread = Thread {
            standing: standing.clone(),
            record: record.clone(),
            hear,
            begin: Instant::now(),
        };
        let begun = thread::Builder::new().name("alarms".to_owned());
        let begun = begun.spawn(move || thread.run(&alarms, &inputs));
        let begun = begun.map_err(|why| Failure::Other(why.to_string()))?;
        Ok(Alarms {
            inputs: Mutex::new(Some(send)),
            standing,
            record,
            thread: Mutex::new(Some(begun)),
        })
    }

    /// Points are these now.
    pub fn changed(&self, values: Vec<Value>) {
        self.put(Input::Changed(values));
    }

    /// A board is there, or away.
    pub fn presence(&self, board: &str, up: bool) {
        self.put(Input::Presence(board.to_owned(), up));
    }

    /// Somebody acknowledges an alarm. Gives how it stands then; it is recorded.
    ///
    /// # Errors
    /// [`NotDone`].
    pub fn acknowledge(&self, alarm: &str, who: &str) -> Result<State, NotDone> {
        let (send, done) = sync_channel(1);
        self.put(Input::Acknowledge(alarm.to_owned(), who.to_owned(), send));
        done.recv().unwrap_or(Err(NotDone::Ended))
    }

    /// How each alarm stands, in the order of the site file.
    pub fn standing(&self) -> Vec<Standing> {
        lock(&self.standing).clone()
    }

    /// What became of alarms.
    ///
    /// # Errors
    /// Where the record cannot be read.
    pub fn past(&self, asked: &Asked) -> Result<Vec<Happening>, Failure> {
        self.record.alarms(asked)
    }

    /// They are judged no more.
    pub fn end(&self) {
        lock(&self.inputs).take();
        if let Some(thread) = lock(&self.thread).take() {
            // One that has failed has said so.
            let _ = thread.join();
        }
    }

    fn put(&self, input: Input) {
        let inputs = lock(&self.inputs).clone();
        if let Some(inputs) = inputs {
            // After the end nobody judges.
            let _ = inputs.send(input);
        }
    }
}

impl Drop for Alarms {
    fn drop(&mut self) {
        self.end();
    }
}

/// How an alarm stands at the beginning, where this became of it last.
fn standing(of: &Alarm, last: Option<&Happening>) -> Standing {
    Standing {
        name: of.name.clone(),
        text: of.text.clone(),
        severity: of.severity,
        boards: of.when.boards(),
        state: last
            .and_then(|last| State::of(&last.state))
            .unwrap_or_default(),
        since: last.map(|last| last.at),
        who: last.and_then(|last| last.who.clone()),
    }
}

struct Thread {
    standing: Arc<Mutex<Vec<Standing>>>,
    record: Arc<Record>,
    hear: Hear,
    begin: Instant,
}

impl Thread {
    fn run(self, alarms: &[Alarm], inputs: &Receiver<Input>) {
        let begin = lock(&self.standing).clone();
        for of in &begin {
            (self.hear)(of, None);
        }
        let state = |name: &str| {
            let of = begin.iter().find(|of| of.name == name);
            of.map_or(State::Normal, |of| of.state)
        };
        let mut engine = Engine::new(alarms, state);
        loop {
            let until = engine
                .due()
                .map_or(IDLE, |due| due.saturating_sub(self.begin.elapsed()));
            let came = inputs.recv_timeout(until);
            let now = self.begin.elapsed();
            let turns = match came {
                Ok(Input::Changed(values)) => {
                    let values = values.iter().map(|of| (&*of.board, &*of.point, of.value));
                    engine.changed(values, now)
                }
                Ok(Input::Presence(board, up)) => engine.presence(&board, up, now),
                Ok(Input::Acknowledge(name, who, done)) => {
                    let alarm = alarms.iter().position(|of| of.name == name);
                    let outcome = alarm.ok_or(NotDone::NoAlarm).and_then(|alarm| {
                        let turn = engine.acknowledge(alarm).ok_or(NotDone::Nothing)?;
                        self.tell(&engine, alarm, turn, Some(who));
                        Ok(engine.state(alarm))
                    });
                    // Whoever asked may have left.
                    let _ = done.send(outcome);
                    Vec::new()
                }
                Err(RecvTimeoutError::Timeout) => Vec::new(),
                Err(RecvTimeoutError::Disconnected) => return,
            };
            for (alarm, turn) in turns {
                self.tell(&engine, alarm, turn, None);
            }
            for (alarm, turn) in engine.tick(self.begin.elapsed()) {
                self.tell(&engine, alarm, turn, None);
            }
        }
    }

    fn tell(&self, engine: &Engine<'_>, alarm: usize, turn: Turn, who: Option<String>) {
        let at = now();
        let of = {
            let mut all = lock(&self.standing);
            let Some(of) = all.get_mut(alarm) else {
                return;
            };
            of.state = engine.state(alarm);
            of.since = Some(at);
            // Who has acknowledged it before it came again is of no matter.
            if who.is_some() || turn == Turn::Came {
                of.who.clone_from(&who);
            }
            of.clone()
        };
        self.record.alarm(Happening {
            at,
            alarm: of.name.clone(),
            change: turn.word().to_owned(),
            state: of.state.word().to_owned(),
            who,
        });
        (self.hear)(&of, Some(turn));
    }
}

fn lock<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}
