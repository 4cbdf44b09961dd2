//! What a site file says.

use crate::alarm::Alarm;
use crate::broker::{Broker, Secret, Sparkplug};
use crate::database::Server;
use crate::grant::Grant;
use crate::panel::Panel;
use crate::points::Points;
use crate::users::User;
use std::net::SocketAddr;
use std::time::Duration;
use unoclp_modbus::map::Parity;

/// A site: boards at lines, and what is served of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// The page.
    pub http: Http,
    /// The lines, in the order of the file; at least one.
    pub lines: Vec<Line>,
    /// The Modbus TCP server, if there is one.
    pub modbus: Option<Modbus>,
    /// What is reported to a broker, if anything is.
    pub mqtt: Option<Mqtt>,
    /// The history, if one is kept.
    pub history: Option<History>,
    /// What was read of the boards, until history and broker have it.
    pub journal: Journal,
    /// How large the record of what happens gets at most, bytes.
    pub record_bound: u64,
    /// The alarms, each with a name of its own.
    pub alarms: Vec<Alarm>,
    /// The panels: those of files, then those that boards have without one.
    pub panels: Vec<Panel>,
    /// Who may do what; nobody: tokens say so.
    pub users: Vec<User>,
}

/// Where the page is served.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Http {
    /// The address; beyond this PC only where the file says how it is encrypted, or that it is not.
    pub listen: SocketAddr,
    /// Whether connections are encrypted.
    pub tls: Encryption,
}

/// With which certificate the page is served.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Encryption {
    /// With none: nothing is encrypted.
    None,
    /// With one that the gateway makes itself, and keeps beside the site file.
    SelfSigned,
    /// With that of these files in PEM, as the site file names them.
    Files {
        /// The certificate.
        cert: String,
        /// Its key.
        key: String,
    },
}

/// A line, and the boards at it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// How it is reached.
    pub way: Way,
    /// The boards, at least one.
    pub boards: Vec<Board>,
}

/// How a line is reached.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Way {
    /// A serial port of this PC.
    Serial {
        /// Its name.
        port: String,
        /// Bits per second.
        rate: u32,
        /// The parity.
        parity: Parity,
    },
    /// A Modbus TCP server, whose units are the boards' addresses.
    Tcp {
        /// Host and port.
        server: String,
    },
}

impl Way {
    /// What it is called: `/dev/ttyACM0`, `10.0.0.7:502`.
    pub fn name(&self) -> &str {
        match self {
            Way::Serial { port, .. } => port,
            Way::Tcp { server } => server,
        }
    }
}

/// A board of a site.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Board {
    /// Its address, which no other board of its line has.
    pub address: u8,
    /// Its unit in Modbus TCP, which no other board of the site has.
    pub unit: u8,
    /// What it is called, as no other board of the site is.
    pub name: String,
    /// The file of the program that it shall run, as the site file names it.
    pub program: Option<String>,
    /// Its points.
    pub points: Points,
    /// How often its points are read.
    pub every: Duration,
}

/// What the points were, kept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct History {
    /// Where.
    pub store: Store,
    /// How long every change is kept.
    pub keep: Duration,
}

/// Where a history is kept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Store {
    /// In a file of SQLite, as the site file names it.
    File(String),
    /// In a database of PostgreSQL.
    Server {
        /// Which.
        server: Server,
        /// The user's password.
        password: Option<Secret>,
        /// Whether the connection is encrypted.
        tls: bool,
        /// The file of the authority that has signed the server's certificate, in PEM; without it, those that the system
        /// trusts.
        ca: Option<String>,
    },
}

impl std::fmt::Display for Store {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Store::File(file) => f.write_str(file),
            Store::Server { server, .. } => server.fmt(f),
        }
    }
}

/// Where samples wait on disk, and how much of it they take.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Journal {
    /// The file, as the site file names it; without it, beside the site file.
    pub store: Option<String>,
    /// From one commit to the next at least.
    pub every: Duration,
    /// How large it gets at most, bytes.
    pub bound: u64,
}

/// What is reported over MQTT.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mqtt {
    /// To whom.
    pub broker: Broker,
    /// As which user; without one, as nobody.
    pub user: Option<String>,
    /// The user's password.
    pub password: Option<Secret>,
    /// The file of the certificate that signs the broker's, in PEM; without it, those that the system trusts.
    pub ca: Option<String>,
    /// The topic above all others; no other gateway at this broker has it.
    pub topic: String,
    /// How often every value is told again.
    pub every: Duration,
    /// Whether Home Assistant is told which boards there are.
    pub home_assistant: bool,
    /// The edge node that is reported as Sparkplug B too, if one is.
    pub sparkplug: Option<Sparkplug>,
    /// What may be written; nothing else is.
    pub write: Vec<Grant>,
    /// Whether alarms may be acknowledged.
    pub acknowledge: bool,
}

/// The Modbus TCP server of a site.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Modbus {
    /// The address.
    pub listen: SocketAddr,
    /// What may be written; nothing else is.
    pub write: Vec<Grant>,
}

impl Site {
    /// Whether samples wait on disk: for a history, or a broker.
    pub fn has_journal(&self) -> bool {
        self.history.is_some() || self.mqtt.is_some()
    }

    /// Whether it is recorded what happens: alarms, and who does what.
    pub fn has_record(&self) -> bool {
        !self.alarms.is_empty() || !self.users.is_empty()
    }

    /// All boards, line by line.
    pub fn boards(&self) -> impl Iterator<Item = &Board> {
        self.lines.iter().flat_map(|line| &line.boards)
    }
}
