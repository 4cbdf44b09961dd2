//! The site file: which boards a gateway serves, at which lines, and what others may do with them (`docs/site.md`).
//!
//! - [`Site`]: what a file says
//! - [`read`]: from the text of a file to a site, or to all its [`Mistake`]s
//! - [`Points`]: the points of a board by the names that its program gives them
//! - [`plan`]: what a gateway would do by it, in words
//!
//! Owns the keys of the file, which values they take, and what is wrong with one: line, reason, remedy. Must not know
//! sockets, ports, threads, nor where the bytes of a file come from.

#![forbid(unsafe_code)]

mod alarm;
mod alarms;
mod broker;
mod database;
mod duration;
mod files;
mod grant;
mod grants;
mod kept;
mod keys;
mod lines;
mod made;
mod mistake;
mod mqtt;
mod named;
mod panel;
mod panels;
mod plan;
mod points;
mod read;
mod site;
mod size;
mod users;
mod values;
mod words;

pub use alarm::{Alarm, Reading, Severity, Sort, Text, UP, When};
pub use broker::{Broker, Secret, Sparkplug};
pub use database::Server;
pub use duration::duration;
pub use files::Files;
pub use grant::Grant;
pub use mistake::{Mistake, Wrong};
pub use panel::{Bind, Does, Item, Look, Panel};
pub use plan::plan;
pub use points::{Kind, Place, Point, Points};
pub use read::read;
pub use site::{Board, Encryption, History, Http, Journal, Line, Modbus, Mqtt, Site, Store, Way};
pub use users::{Role, User};
