//! A board at the other end of a line, over Modbus: the client's side of `docs/modbus.md`, as a state machine without
//! I/O, threads or clock.
//!
//! - [`Conversation`]: bytes and times in, bytes and times out; drives what is said
//! - [`client`]: requests and their answers
//! - [`identity`], [`diagnostics`]: what a board says of itself
//! - [`start`]: finding the board at the other end
//! - [`download`]: the program that a board keeps, read back
//! - [`upload`]: a program over the line in place of the card
//! - [`flash`]: a firmware by its boot loader
//! - [`watch`]: one reading of all that a screen shows, commands and forces
//! - [`live`]: the same many times a second, of what a program uses
//! - [`session`]: a board from finding it to losing it, and all that is heard of it meanwhile: one machine, whose views are
//!   the terminal, the page and the gateway
//! - [`order`]: all that may be ordered of a board; [`event`]: all that is heard of it, and what comes of an order
//! - [`point`]: writing of single points
//! - [`settings`]: address, rate, parity, direction pin and lock; [`settle`]: changing them
//! - [`words`]: what there is to say of all that
//!
//! Owns what is asked of a board, in which order, what its answers are, and their words. Must not know ports, threads, clocks,
//! nor who shows what. What the addresses stand for is [`map`]'s, which the firmware serves too.

#![forbid(unsafe_code)]

pub mod client;
mod conversation;
pub mod diagnostics;
#[cfg(feature = "more")]
pub mod download;
pub mod event;
#[cfg(feature = "more")]
pub mod flash;
pub mod identity;
mod link;
pub mod live;
pub mod order;
pub mod point;
pub mod session;
pub mod settings;
#[cfg(feature = "more")]
pub mod settle;
pub mod start;
mod start_text;
pub mod upload;
pub mod watch;
pub mod words;

pub use client::{Client, Failure, Line, Patience};
pub use conversation::{Conversation, Next, Step};
pub use link::{Format, Known};
pub use order::Order;
pub use unoclp_modbus::map::Parity;
pub use unoclp_modbus::{lock, map};

/// The board that one at the other end of a line is taken for until it has said which it is.
pub const AT_A_LINE: unoclp_core::Board = unoclp_core::Board::UNO;
