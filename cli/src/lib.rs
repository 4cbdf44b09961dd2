//! What the command line shows on a terminal, and how it gets at a board.
//!
//! - [`panel`]: the simulator
//! - [`monitor`]: a board at a serial port
//! - [`port`]: the serial port

pub mod monitor;
pub mod panel;
pub mod port;
