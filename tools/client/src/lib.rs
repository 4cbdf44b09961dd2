//! A board at the other end of a line, over Modbus: the client's side of `docs/modbus.md`, as a state machine without
//! I/O, threads or clock.
//!
//! - [`Conversation`]: bytes and times in, bytes and times out; drives what is said
//! - [`client`]: requests and their answers
//! - [`identity`], [`diagnostics`]: what a board says of itself
//! - [`start`]: finding the board at the other end
//! - [`upload`]: a program over the line in place of the card
//! - [`watch`]: one reading of all that a screen shows, and what may be wished of the board
//! - [`live`]: the same many times a second, of what a program uses
//! - [`session`]: a board from finding it to losing it, for whoever watches one: a terminal, a page
//! - [`point`]: writing of single points
//! - [`settings`]: address, rate, parity, direction pin and lock
//!
//! Owns what is asked of a board, in which order, and what its answers are. Must not know ports, threads, clocks, words:
//! what it gives are values. What the addresses stand for is [`map`]'s, which the firmware serves too.

#![forbid(unsafe_code)]

pub mod client;
mod conversation;
pub mod diagnostics;
pub mod identity;
mod link;
pub mod live;
pub mod point;
pub mod session;
pub mod settings;
pub mod start;
pub mod upload;
pub mod watch;

pub use client::{Client, Failure, Line, Patience};
pub use conversation::{Conversation, Next, Step};
pub use unoclp_modbus::map::Parity;
pub use unoclp_modbus::{lock, map};

/// The board that one at the other end of a line is taken for until it has said which it is.
pub const AT_A_LINE: unoclp_core::Board = unoclp_core::Board::UNO;
