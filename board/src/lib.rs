//! A board at a serial port, over Modbus: the PC side of `docs/modbus.md`.
//!
//! - [`map`]: what the addresses stand for
//! - [`port`]: opening the port without resetting the board behind it
//! - [`client`]: requests and their answers
//! - [`identity`], [`diagnostics`]: what a board says of itself
//! - [`start`]: finding the board that shall be at the port
//! - [`upload`]: a program over the line in place of the card
//! - [`watch`]: one reading of all that a screen shows, and what may be asked of the board
//! - [`settings`]: address, rate, parity and direction pin

pub mod client;
pub mod diagnostics;
pub mod identity;
pub mod map;
pub mod port;
pub mod settings;
pub mod start;
pub mod upload;
pub mod watch;

pub use client::{Client, Failure, Patience};
pub use port::{Line, NotOpened, Parity};
