//! The page over HTTP, and the gateway that shares the board at this PC among many (`docs/remote.md`).
//!
//! - [`Pages`]: the files of the page, which somebody else has
//! - [`Tokens`], `doors`: who may watch, who may control, and from which pages
//! - [`Line`]: the one owner of the line to the board; `turns`: whose request goes next
//! - `control`, `forcing`: who controls, and who has forced points, which `release` lets go
//! - `gateway`: one visitor's way to that line, a WebSocket
//! - [`Server`]: takes connections, each within limits; `slots`: how many, and whose
//!
//! Owns what comes over the network until it is an allowed request. Must not know serial ports, the command line, nor
//! what a request asks of the board, beyond whether it only reads, stops, forces or uploads.

#![forbid(unsafe_code)]

mod control;
mod doors;
mod forcing;
mod gateway;
mod line;
mod page;
mod release;
mod server;
mod slots;
mod tokens;
mod turns;

pub use line::{Board, Line, NoAnswer};
pub use page::Pages;
pub use server::{Server, Sharing};
pub use tokens::{Role, Tokens};
