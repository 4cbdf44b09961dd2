//! What the command line shows on a terminal, and how it reaches a board.
//!
//! - [`run`]: the whole command, by the arguments of this process; `commands`: what each word of them does
//! - [`panel`]: the simulator
//! - [`monitor`]: a board at a serial port
//! - [`port`]: the serial port
//! - `broker`: what a broker is told of a site, with the same feature; `alarms`: its alarms, and the record
//! - `shared`: the page and the boards for browsers, with the feature `page`, until `ended` says so; [`site_file`]: which boards
//! - `kept`: the journal and the history of a site; `archive`: the history for who asks over HTTP; `identity`: with which certificate; [`stores`]: where they are
//! - `own`: a teacher's exercises and machines among those of the page
//! - [`film`]: a run of a machine as an animation
//! - [`screen`]: what holds for every screen
//! - [`ascii`]: what stands for other characters where the locale has no UTF-8
//! - [`messages`]: what all of them say, in two languages
//!
//! Owns the terminal, the serial port and files. Must not know simulators of the chip, nor what a program means.

#[cfg(feature = "page")]
mod alarms;
#[cfg(feature = "page")]
mod archive;
mod arguments;
pub mod ascii;
#[cfg(feature = "page")]
mod broker;
mod commands;
#[cfg(feature = "page")]
mod ended;
pub mod film;
#[cfg(feature = "page")]
mod identity;
#[cfg(feature = "page")]
mod kept;
mod lamps;
pub mod messages;
#[cfg(feature = "page")]
mod metrics;
pub mod monitor;
mod outcome;
#[cfg(feature = "page")]
pub mod own;
pub mod panel;
pub mod port;
pub mod screen;
#[cfg(feature = "page")]
pub mod shared;
pub mod site_file;
pub mod stores;
mod variables;

pub use arguments::run;
