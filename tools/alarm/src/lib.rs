//! The alarms of a site: when they come, who acknowledges them, and when they are gone (`docs/site.md`).
//!
//! - [`State`], [`Turn`]: how an alarm stands, and what becomes of it
//! - `engine`: all alarms of a site, from values and time to turns, without a clock or a thread
//! - [`Alarms`]: the same as a thread, which goes on where the last one has ended; [`Standing`]: what others see of one
//!
//! Owns when an alarm comes and goes, and what acknowledging does. Must not know boards, networks, nor who may acknowledge.

#![forbid(unsafe_code)]

mod alarms;
mod engine;
mod state;

pub use alarms::{Alarms, Hear, NotDone, Standing, Value};
pub use state::{State, Turn};
