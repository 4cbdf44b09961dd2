//! Seeded schedules of faults: gateway, mosquitto and PostgreSQL are killed, boards are unplugged, and the disk is full, one
//! after the other and together. From its commit to the journal on, each sample reaches the history exactly once, and the broker at least once,
//! in order.
#![cfg(target_os = "linux")]

#[path = "../../../tools/report/tests/it/broker.rs"]
#[allow(dead_code, reason = "each test uses its part")]
mod broker;
#[path = "../../../tools/history/tests/it/server.rs"]
#[allow(dead_code, reason = "each test uses its part")]
mod database;

use broker::Broker;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::Duration;
use unoclp_faults::{Place, Tap, count};
use unoclp_history::Query;
use unoclp_testing::{Random, rounds};

/// As `NAME:BROKER:FOLDER`, or `NAME:BROKER:FOLDER:PORT:DATABASE`: what the gateway below is told.
const PLACE: &str = "UNOCLP_FAULTS";
/// No test waits for longer: what has not come by then does not come. A busy disk makes a commit wait for a minute.
const PATIENCE: Duration = Duration::from_secs(300);
/// Schedules that run beside each other: they mostly wait.
const BESIDE: usize = 6;

/// What is killed below.
#[test]
fn a_gateway_counts() {
    let Ok(told) = std::env::var(PLACE) else {
        return;
    };
    let mut parts = told.split(':');
    let mut next = || parts.next().map(str::to_owned);
    count(&Place {
        name: next().unwrap(),
        broker: next().unwrap().parse().unwrap(),
        folder: next().unwrap().into(),
        postgres: next().map(|port| (port.parse().unwrap(), next().unwrap())),
    });
}

/// A gateway that counts.
struct Gateway {
    /// In which schedule.
    seed: u64,
    child: Child,
    stdin: ChildStdin,
    says: Receiver<String>,
}

impl Gateway {
    fn begin(seed: u64, place: &Place) -> Gateway {
        let (name, broker, folder) = (&place.name, place.broker, place.folder.display());
        let told = match &place.postgres {
            None => format!("{name}:{broker}:{folder}"),
            Some((port, database)) => format!("{name}:{broker}:{folder}:{port}:{database}"),
        };
        // A file that must not grow is an error to it, as a disk that is full; not its end.
        let mut child = Command::new("env")
            .arg("--ignore-signal=XFSZ")
            .arg(std::env::current_exe().unwrap())
            .args(["--exact", "a_gateway_counts", "--nocapture"])
            .env(PLACE, told)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let lines = BufReader::new(child.stdout.take().unwrap()).lines();
        let (send, says) = channel();
        thread::spawn(move || {
            for line in lines.map_while(Result::ok) {
                // After the end of a schedule nobody listens.
                let _ = send.send(line);
            }
        });
        let stdin = child.stdin.take().unwrap();
        Gateway {
            seed,
            child,
            stdin,
            says,
        }
    }

    /// The next line that has this word: what is behind it.
    fn hears(&self, word: &str) -> String {
        loop {
            let line = self.says.recv_timeout(PATIENCE);
            let line = line.unwrap_or_else(|why| panic!("schedule {}: {word}: {why}", self.seed));
            if let Some((_, rest)) = line.split_once(word) {
                return rest.trim().to_owned();
            }
        }
    }

    /// It has committed so often more; gives how far it is.
    fn commits(&self, times: usize) -> u64 {
        let once = |_: u64, _| self.hears("committed ").parse().unwrap();
        (0..times).fold(0, once)
    }

    /// No file may grow, or each may again.
    fn disk(&self, is_full: bool) {
        let limit = if is_full {
            "--fsize=0:unlimited"
        } else {
            "--fsize=unlimited"
        };
        let pid = self.child.id().to_string();
        let set = Command::new("prlimit")
            .args(["--pid", &pid, limit])
            .status();
        assert!(set.unwrap().success());
    }

    fn kill(mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }

    fn tell(&mut self, what: &str) {
        writeln!(self.stdin, "{what}").unwrap();
    }

    /// It ends as a service does.
    fn end(mut self) {
        self.tell("end");
        assert!(self.child.wait().unwrap().success());
    }
}

/// A server of PostgreSQL for one schedule at a time.
struct Postgres {
    server: Mutex<database::Server>,
    databases: AtomicU32,
}

/// What a schedule does next.
#[derive(Clone, Copy, Debug)]
enum Fault {
    /// The gateway is killed at the moment at which it has committed,
    Boundary,
    /// or at any moment.
    Anywhere,
    /// The gateway ends in order.
    End,
    /// The broker is killed, and begun again later.
    Broker,
    /// So is the database.
    Database,
    /// The disk is full for a while.
    Disk,
    /// Broker and gateway are killed together.
    Both,
    /// The board is unplugged, and is there again later,
    Unplugged,
    /// or the gateway is killed meanwhile.
    UnpluggedAndKilled,
}

const FAULTS: [Fault; 9] = [
    Fault::Boundary,
    Fault::Anywhere,
    Fault::End,
    Fault::Broker,
    Fault::Database,
    Fault::Disk,
    Fault::Both,
    Fault::Unplugged,
    Fault::UnpluggedAndKilled,
];

fn schedule(seed: u64, postgres: &Postgres) {
    let mut random = Random(seed);
    let folder = tempfile::tempdir().unwrap();
    let mut broker = Broker::new();
    let tap = Tap::new(broker.port).unwrap();
    // Each third schedule has its history in PostgreSQL.
    let mut server = seed
        .is_multiple_of(3)
        .then(|| postgres.server.lock().unwrap());
    let database = server.as_ref().map(|server| {
        let name = format!("s{}", postgres.databases.fetch_add(1, Ordering::Relaxed));
        server.database(&name);
        (server.port, name)
    });
    let place = Place {
        name: "b".into(),
        folder: folder.path().to_owned(),
        broker: tap.port,
        postgres: database,
    };
    let mut gateway = Gateway::begin(seed, &place);
    let (mut least, mut gaps) = (0, 0);
    let mut done = Vec::new();
    for _ in 0..3 + random.below(4) {
        let fault = random.pick(&FAULTS);
        done.push(fault);
        least = gateway.commits(1 + random.below(4)).max(least);
        match (fault, &mut server) {
            (Fault::Boundary, _) => {
                gateway.kill();
                gateway = Gateway::begin(seed, &place);
            }
            (Fault::Anywhere, _) => {
                for _ in 0..random.below(2_000) {
                    thread::yield_now();
                }
                gateway.kill();
                gateway = Gateway::begin(seed, &place);
            }
            (Fault::End, _) => {
                gateway.end();
                gateway = Gateway::begin(seed, &place);
            }
            (Fault::Broker, _) => {
                broker.kill();
                least = gateway.commits(2).max(least);
                broker.begin();
            }
            (Fault::Both, _) => {
                broker.kill();
                gateway.kill();
                broker.begin();
                gateway = Gateway::begin(seed, &place);
            }
            (Fault::Unplugged | Fault::UnpluggedAndKilled, _) => {
                gateway.tell("unplug");
                least = gateway.hears("away ").parse::<u64>().unwrap().max(least);
                gaps += 1;
                if matches!(fault, Fault::UnpluggedAndKilled) {
                    gateway.kill();
                    gateway = Gateway::begin(seed, &place);
                } else {
                    gateway.tell("plug");
                    gateway.hears("back");
                }
            }
            (Fault::Database, Some(server)) => {
                server.kill();
                least = gateway.commits(2).max(least);
                server.begin();
            }
            (Fault::Disk | Fault::Database, _) => {
                gateway.disk(true);
                gateway.hears("failing");
                gateway.disk(false);
                // Or the next disk that is full would be the same one to it.
                gateway.hears("again");
            }
        }
    }
    gateway.tell("finish");
    let last: u64 = gateway.hears("done ").parse().unwrap();
    assert!(gateway.child.wait().unwrap().success());
    let story = format!("schedule {seed}: {done:?}");
    assert!(last >= least, "{story}: {last} < {least}");
    assert_eq!(exactly_once(&place, last, &story), gaps, "{story}");
    in_order(&place, &tap, last, &story);
}

/// The history has each sample once; gives how many are without a value, as the board was away.
fn exactly_once(place: &Place, last: u64, story: &str) -> usize {
    let mut store = place.database().read().unwrap();
    let rows = store.rows(&Query {
        board: place.name.clone(),
        point: "A0".into(),
        from: 0,
        to: i64::MAX,
        step: 0,
        most: usize::MAX,
    });
    let rows = rows.unwrap();
    let moments: Vec<u64> = rows.iter().map(|row| row.at.cast_unsigned()).collect();
    assert_eq!(moments, (1..=last).collect::<Vec<_>>(), "{story}");
    let (known, gaps): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.last.is_some());
    for row in known {
        assert_eq!(row.last, Some(row.at as f64), "{story}");
    }
    gaps.len()
}

/// A broker has confirmed each sample, none before the one that comes before it, and each with its number.
fn in_order(place: &Place, tap: &Tap, last: u64, story: &str) {
    let topic = format!("{0}/{0}/A0", place.name);
    let mut seen = 0;
    for (at, payload) in tap.confirmed() {
        if at != topic {
            continue;
        }
        let text = String::from_utf8(payload).unwrap();
        let part = |key: &str| -> u64 {
            let (_, rest) = text.split_once(key).unwrap();
            let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
            digits.parse().unwrap()
        };
        let number = part("\"n\":");
        if !text.contains("\"v\":null") {
            assert_eq!(part("\"v\":"), number, "{story}");
        }
        assert!(number <= seen + 1, "{story}: {number} after {seen}");
        seen = seen.max(number);
    }
    assert_eq!(seen, last, "{story}");
}

#[test]
fn under_random_schedules_nothing_is_lost_doubled_or_out_of_order() {
    assert!(
        Path::new("/usr/bin/prlimit").exists(),
        "util-linux brings it"
    );
    // A test of long makes a thousand at least.
    let all = match rounds(30) {
        few @ ..=30 => u64::from(few),
        many => u64::from(many).max(1_000),
    };
    let postgres = Postgres {
        server: Mutex::new(database::Server::new()),
        databases: AtomicU32::new(0),
    };
    let next = AtomicU32::new(0);
    thread::scope(|scope| {
        for _ in 0..BESIDE {
            scope.spawn(|| {
                loop {
                    let seed = u64::from(next.fetch_add(1, Ordering::Relaxed));
                    if seed >= all {
                        return;
                    }
                    schedule(seed, &postgres);
                }
            });
        }
    });
}

/// What each of two gateways keeps and tells is its own, whatever becomes of the other, of their broker and of their database.
#[test]
fn two_gateways_share_a_broker_and_a_database() {
    let mut server = database::Server::new();
    server.database("site");
    let mut broker = Broker::new();
    let folders = [(); 2].map(|()| tempfile::tempdir().unwrap());
    let taps = [(); 2].map(|()| Tap::new(broker.port).unwrap());
    let places = [0, 1].map(|at: usize| Place {
        name: ["east", "west"][at].into(),
        folder: folders[at].path().to_owned(),
        broker: taps[at].port,
        postgres: Some((server.port, "site".into())),
    });
    let [mut east, west] = [0, 1].map(|at| Gateway::begin(at as u64, &places[at]));
    let mut least = [0; 2];
    for round in 0..3 {
        least = [east.commits(2), west.commits(2)];
        match round {
            0 => server.kill(),
            1 => broker.kill(),
            _ => {}
        }
        east.kill();
        // The other one goes on without it.
        west.commits(3);
        east = Gateway::begin(0, &places[0]);
        match round {
            0 => server.begin(),
            1 => broker.begin(),
            _ => {}
        }
    }
    for (at, mut gateway) in [east, west].into_iter().enumerate() {
        gateway.tell("finish");
        let last: u64 = gateway.hears("done ").parse().unwrap();
        assert!(gateway.child.wait().unwrap().success());
        let name = &places[at].name;
        assert!(last >= least[at], "{name}: {last} < {}", least[at]);
        assert_eq!(exactly_once(&places[at], last, name), 0, "{name}");
        in_order(&places[at], &taps[at], last, name);
    }
}
