//! A site of two boards, and what reports it.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex};
use std::time::Duration;
use tempfile::TempDir;
use unoclp_journal::{File, Journal, Policy, Sample};
use unoclp_report::{Alarm, Carry, Command, Refusal, Reporter, State, Tell, Wish};
use unoclp_site::{Files, Site, read};

struct Folder;

const TANK: &str = "PROGRAM tank VAR level : REAL; valve AT %QX0.0 : BOOL; target : DINT; END_VAR\n\
    valve := target > 5; target := target + 0; level := level + 0.5; END_PROGRAM\n";

impl Files for Folder {
    fn bytes(&self, _: &str) -> Result<Vec<u8>, String> {
        Ok(TANK.into())
    }
}

/// The boards `tank`, of a program, and `lamp`, of none, with these lines of `[mqtt]`.
pub fn site(broker: &str, more: &str) -> Site {
    let text = format!(
        "[[line]]\nport = \"a\"\n[[line.board]]\nname = \"tank\"\nprogram = \"tank.st\"\n\
         [[line.board]]\nname = \"lamp\"\naddress = 2\n[mqtt]\nbroker = \"{broker}\"\n{more}"
    );
    read(&text, &Folder).unwrap_or_else(|wrong| panic!("{wrong:?}"))
}

/// A reporter, and the commands that it has brought.
pub struct Reporting {
    pub reporter: Reporter,
    pub journal: Journal,
    folder: Arc<TempDir>,
    pub commands: Receiver<Command>,
    pub acknowledged: Receiver<String>,
    pub told: Receiver<Option<String>>,
}

impl Reporting {
    /// Reports this site; each command is answered so.
    pub fn new(site: &Site, ca: Option<&[u8]>, outcome: Result<(), Refusal>) -> Reporting {
        Reporting::of(Arc::new(tempfile::tempdir().unwrap()), site, ca, outcome)
    }

    /// The same after a restart of the gateway: what its journal has is there still.
    pub fn again(self, site: &Site) -> Reporting {
        let folder = self.folder.clone();
        drop(self);
        Reporting::of(folder, site, None, Ok(()))
    }

    fn of(
        folder: Arc<TempDir>,
        site: &Site,
        ca: Option<&[u8]>,
        outcome: Result<(), Refusal>,
    ) -> Reporting {
        let (send, commands) = channel();
        let (acknowledge, acknowledged) = channel();
        let (tell, told) = channel();
        let mqtt = site.mqtt.as_ref().unwrap();
        let policy = Policy {
            every: Duration::ZERO,
            bound: u64::MAX,
        };
        let file = File::open(&folder.path().join("j")).unwrap();
        let readers = Reporter::readers(mqtt);
        let journal = Journal::begin(file, policy, &readers, Box::new(|_| ())).unwrap();
        let carry = carry(send, acknowledge, outcome);
        let begun = Reporter::begin(site, mqtt, ca, &journal, carry, telling(tell));
        Reporting {
            reporter: begun.unwrap_or_else(|why| panic!("{why:?}")),
            journal,
            folder,
            commands,
            acknowledged,
            told,
        }
    }

    pub fn change(&self, board: &str, values: &[(&str, Option<f64>)], at: i64) {
        let change = |(point, value): &(&str, Option<f64>)| Sample {
            board: board.into(),
            point: (*point).into(),
            at,
            value: *value,
        };
        let changes: Vec<Sample> = values.iter().map(change).collect();
        self.journal.put(changes.clone());
        self.reporter.changed(changes);
    }

    /// Waits until it stands so.
    pub fn until(&self, is: impl Fn(State) -> bool) {
        let begun = std::time::Instant::now();
        while !is(self.reporter.state()) {
            let state = self.reporter.state();
            assert!(begun.elapsed().as_secs() < 20, "{state:?}");
            std::thread::yield_now();
        }
    }
}

fn carry(
    send: Sender<Command>,
    acknowledged: Sender<String>,
    outcome: Result<(), Refusal>,
) -> Carry {
    let (send, acknowledged) = (Mutex::new(send), Mutex::new(acknowledged));
    Arc::new(move |wish, done| {
        // After the end of the test nobody listens.
        match wish {
            Wish::Set(command) => drop(send.lock().unwrap().send(command)),
            Wish::Acknowledge(alarm) => drop(acknowledged.lock().unwrap().send(alarm)),
        }
        done(outcome);
    })
}

fn telling(send: Sender<Option<String>>) -> Tell {
    let send = Mutex::new(send);
    Arc::new(move |trouble| {
        let told = trouble.map(|why| format!("{why:?}"));
        let _ = send.lock().unwrap().send(told);
    })
}

/// The alarm `hot`, and how it stands.
pub const HOT: &str = "[[alarm]]\nname = \"hot\"\nwhen = \"tank.level > 80.0\"\ntext = \"hot\"\n";

pub fn hot(state: &'static str, since: i64) -> Alarm {
    Alarm {
        name: "hot".into(),
        state,
        severity: "high",
        text: unoclp_site::Text {
            en: "hot".into(),
            pt: "quente".into(),
        },
        since: Some(since),
        who: None,
    }
}
