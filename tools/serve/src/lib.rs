//! The page over HTTP, and the gateway that shares the boards at this PC among many (`docs/remote.md`, `docs/site.md`).
//!
//! - [`Pages`]: the files of the page, which somebody else has
//! - [`Guard`]: who is let in, by [`Tokens`] or as one of the [`Users`]; `tries`: how often; `doors`: from which pages
//! - `written`: what a request writes, and who may; `deeds`: what was done, for the record
//! - [`Line`]: the way to a board, of which `owner` has the port; `turns`: whose request goes next
//! - `control`, `forcing`: who controls, and who has forced points, which `release` lets go
//! - `gateway`: one visitor's way to that line, a WebSocket
//! - [`Remote`]: a line that is a Modbus TCP server
//! - [`News`]: what is told of the boards
//! - [`Watched`]: boards that are read again and again, and what has changed
//! - [`Modbus`]: the same boards over Modbus TCP
//! - [`Orders`]: values that others write by name
//! - [`Sharing`]: what is shared
//! - `api`: what other programs read over HTTP
//! - [`Server`]: takes connections, each within limits; `slots`: how many, and whose; [`Tls`]: how they are encrypted
//!
//! Owns what comes over the network until it is an allowed request. Must not know serial ports, the command line, nor
//! what a request asks of the board, beyond whether it only reads, stops, forces or uploads.

#![forbid(unsafe_code)]

mod api;
mod control;
mod deeds;
mod doors;
mod forcing;
mod gateway;
mod guard;
mod holding;
mod line;
mod modbus;
mod news;
mod orders;
mod owner;
mod page;
mod poll;
mod release;
mod remote;
mod server;
mod sharing;
mod slots;
mod tls;
mod tokens;
mod tries;
mod turns;
mod written;

pub use api::{Metric, Metrics, Past};
pub use guard::{Guard, Users};
pub use line::Line;
pub use modbus::Modbus;
pub use news::{News, Tell};
pub use orders::{Acknowledgement, Done, Order, Ordered, Orders};
pub use owner::{Board, NoAnswer};
pub use page::Pages;
pub use poll::{Change, Keep, Watched};
pub use remote::{Absent, Remote};
pub use server::Server;
pub use sharing::{SharedBoard, Sharing};
pub use tls::{Identity, Tls, Unfit};
pub use tokens::{Role, Tokens};
pub use unoclp_alarm::NotDone;
