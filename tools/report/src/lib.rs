//! What the points of a site are, told to a broker over MQTT, and what the site lets others write, taken from there
//! (`docs/site.md`).
//!
//! - [`Reporter`]: the way in; `shared`: how it stands, and who hears of it
//! - `boards`: what is known of each board: its points, their values, which names hold
//! - `session`: what one connection after the other says and hears, without I/O
//! - `plain`: a topic a point, commands, and what Home Assistant finds
//! - `sparkplug`: the same as an edge node of Sparkplug B
//! - `command`: what somebody asks for by a message, and why it is refused
//! - [`Alarm`]: how an alarm stands
//! - `backlog`: what a board was while nobody could hear of it
//! - `connection`: the connection itself, which comes back by itself; `tls`: whom it trusts
//!
//! What waits for a broker that is away stands in the journal, a restart of the gateway long too.
//!
//! Owns topics, payloads and their order. Must not know how a board is read or written, nor what else is served.

#![forbid(unsafe_code)]

mod alarm;
mod backlog;
mod boards;
mod change;
mod command;
mod connection;
mod plain;
mod reporter;
mod session;
mod shared;
mod sparkplug;
mod tls;

pub use alarm::Alarm;
pub use command::{Command, Refusal, Wish};
pub use reporter::Reporter;
pub use shared::{Carry, State, Tell, Trouble, Unready};
