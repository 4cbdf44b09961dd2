//! What the command line shows on a terminal.
//!
//! - [`panel`]: the simulator
//! - [`monitor`]: a board at a serial port

pub mod monitor;
pub mod panel;
