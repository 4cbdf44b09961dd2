//! The part of a gateway that keeps and reports, without boards: its one point counts.

use std::io::BufRead;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use unoclp_history::{Address, Database, Failure, Keeper};
use unoclp_journal::{File, Journal, Policy, Sample};
use unoclp_report::Reporter;
use unoclp_site::{Files, Site};

/// Samples of one commit.
const BATCH: u64 = 3;
/// Who takes the entries for the history.
const HISTORY: &str = "history";

/// Where a gateway keeps, and to whom it reports.
#[derive(Clone, Debug)]
pub struct Place {
    /// What its board is called, and the topic above all others.
    pub name: String,
    /// Its files.
    pub folder: PathBuf,
    /// The port of its broker.
    pub broker: u16,
    /// The port and the database of PostgreSQL, if the history is there.
    pub postgres: Option<(u16, String)>,
}

struct NoFiles;

impl Files for NoFiles {
    fn bytes(&self, _: &str) -> Result<Vec<u8>, String> {
        Err("no such file".into())
    }
}

impl Place {
    /// Where the history is.
    pub fn database(&self) -> Database {
        match &self.postgres {
            None => Database::File(self.folder.join("h.db")),
            Some((port, database)) => Database::Server(Address {
                host: "127.0.0.1".into(),
                port: *port,
                user: "unoclp".into(),
                database: database.clone(),
                password: None,
                tls: None,
            }),
        }
    }

    fn site(&self) -> Site {
        let Place { name, broker, .. } = self;
        let text = format!(
            "[[line]]\nport = \"a\"\n[[line.board]]\nname = \"{name}\"\n[mqtt]\nbroker = \"mqtt://127.0.0.1:{broker}\"\ntopic = \"{name}\"\n",
        );
        unoclp_site::read(&text, &NoFiles).unwrap_or_else(|wrong| panic!("{wrong:?}"))
    }
}

/// Counts on from what is there: the value of each sample is its number, as its moment is. Says after each commit how far it
/// is, and when the disk takes nothing, and does again. From `unplug` to `plug` on its standard input the board is away: one
/// sample without a value says so. At `end` it ends as a service does; at `finish` it counts no more, waits until history and
/// broker have all, and says so.
pub fn count(place: &Place) {
    let file = File::open(&place.folder.join("j")).expect("the journal is there");
    let mut next = file.last() + 1;
    let site = place.site();
    let mqtt = site.mqtt.as_ref().expect("there is one");
    let readers = [&[HISTORY][..], &Reporter::readers(mqtt)].concat();
    let policy = Policy {
        every: Duration::from_millis(5),
        bound: u64::MAX,
    };
    let failing = Box::new(|why: Option<&Failure>| {
        println!("{}", if why.is_some() { "failing" } else { "again" });
    });
    let journal = Journal::begin(file, policy, &readers, failing).expect("the journal begins");
    let database = place.database();
    let open = Box::new(move || database.open());
    let history = journal.reader(HISTORY);
    let keep = Duration::from_secs(36_500 * 86_400);
    let keeper = Keeper::begin(None, open, history.clone(), keep, Box::new(|_| ()));
    let keeper = keeper.expect("a thread begins");
    let carry = Arc::new(|_, _: Box<dyn FnOnce(_) + Send>| ());
    let reporter = Reporter::begin(&site, mqtt, None, &journal, carry, Arc::new(|_| ()));
    let reporter = reporter.unwrap_or_else(|why| panic!("{why:?}"));
    let Told {
        ends,
        finishes,
        away,
    } = told();
    let put = |samples: Vec<Sample>| {
        let last = samples.last().map_or(0, |last| last.at.cast_unsigned());
        journal.put(samples);
        while history.last() < last && !ends.load(Ordering::Relaxed) {
            std::thread::yield_now();
        }
    };
    while !ends.load(Ordering::Relaxed) && !finishes.load(Ordering::Relaxed) {
        if away.load(Ordering::Relaxed) {
            reporter.presence(&place.name, false);
            put(vec![Sample {
                value: None,
                ..sample(&place.name, next)
            }]);
            next += 1;
            println!("away {}", history.last());
            while away.load(Ordering::Relaxed) && !ends.load(Ordering::Relaxed) {
                std::thread::yield_now();
            }
            reporter.presence(&place.name, true);
            println!("back");
        }
        let last = next + BATCH;
        put((next..last)
            .map(|number| sample(&place.name, number))
            .collect());
        next = last;
        println!("committed {}", history.last());
    }
    if finishes.load(Ordering::Relaxed) {
        let waits = || history.place() < history.last() || reporter.state().waiting > 0;
        while waits() && !ends.load(Ordering::Relaxed) {
            std::thread::yield_now();
        }
        if !waits() {
            println!("done {}", history.last());
        }
    }
    drop(reporter);
    journal.end();
    keeper.end();
}

fn sample(board: &str, number: u64) -> Sample {
    Sample {
        board: board.into(),
        point: "A0".into(),
        at: number as i64,
        value: Some(number as f64),
    }
}

/// What is said on the standard input: to end, to finish, and that the board is away.
#[derive(Clone, Default)]
struct Told {
    ends: Arc<AtomicBool>,
    finishes: Arc<AtomicBool>,
    away: Arc<AtomicBool>,
}

fn told() -> Told {
    let told = Told::default();
    let tell = told.clone();
    std::thread::spawn(move || {
        for line in std::io::stdin().lock().lines().map_while(Result::ok) {
            match &*line {
                "end" => tell.ends.store(true, Ordering::Relaxed),
                "finish" => tell.finishes.store(true, Ordering::Relaxed),
                "unplug" => tell.away.store(true, Ordering::Relaxed),
                "plug" => tell.away.store(false, Ordering::Relaxed),
                _ => {}
            }
        }
        // Whoever began it is gone.
        tell.ends.store(true, Ordering::Relaxed);
    });
    told
}
