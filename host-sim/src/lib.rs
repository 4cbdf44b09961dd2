//! The same PLC on a PC: programs are checked, simulated, and run against scenarios.
//!
//! - [`scenario`]: the one test format of the project, and the check that every engine passes
//! - [`engine`]: the PLC of `unoclp-core` as an engine for scenarios
//! - [`diagnosis`]: all faults of a program file, each shown in its source line
//! - [`list`]: a program as a ladder diagram or as numeric code with its meaning
//! - [`wave`]: the trace of a run for a wave viewer
//! - [`panel`]: the simulator in a terminal
//! - [`used`]: what a program uses of the board and its memory
//! - [`written`]: a program as a person has written it, in numeric code or Instruction List
//! - [`board`]: a board at a serial port, over Modbus
//! - [`monitor`]: such a board in a terminal
//! - [`random`], [`torture`]: random programs, and damaged ones for the loader
//!
//! The PLC itself is `unoclp-core`; nothing here decides what a program means.

pub mod board;
pub mod diagnosis;
pub mod engine;
pub mod list;
pub mod monitor;
pub mod panel;
pub mod random;
pub mod scenario;
pub mod torture;
pub mod used;
pub mod wave;
pub mod written;

use unoclp_core::Profile;

/// The board that every tool of this version checks and simulates for.
pub const BOARD: Profile = Profile::UNO;
