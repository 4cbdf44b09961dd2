//! The same PLC on a PC, against fake pins and a virtual clock.
//!
//! - [`scenario`]: the one test format of the project, and the check that every engine passes
//! - [`engine`]: what runs programs and can be compared; the PLC of `unoclp-core` as one
//! - [`live`]: a running program as it is shown
//! - [`diagram`]: a run of a scenario as a picture: what was pressed, expected and came
//! - [`wave`]: the trace of a run for a wave viewer
//! - [`random`], [`torture`]: random programs, and damaged ones for the loader
//!
//! It owns what runs a program on a PC and compares it. It knows no command line, terminal, port or line.
//! The PLC itself is `unoclp-core`; nothing here decides what a program means.

#![forbid(unsafe_code)]

pub mod diagram;
pub mod engine;
pub mod live;
pub mod random;
pub mod scenario;
pub mod torture;
pub mod wave;

use unoclp_core::Profile;

/// The board whose programs are run.
pub const BOARD: Profile = Profile::UNO;
