//! A running program as it is shown: what its last scan has made of each step, and what its boxes count.
//!
//! - [`Flow`]: what a program does at the moment
//! - [`Followed`]: a scan that may stand between two instructions
//! - [`Boxes`]: the texts of timers' and counters' boxes while it runs
//! - [`Lines`]: the lines of the text, each with what it has come to: of a text with statements by `traced`, what each
//!   statement tests or stores; of others by `stepped`, what the steps of each line have come to
//! - [`Charts`]: the steps that are active
//! - [`Twin`]: does what a board does that tells its points only
//!
//! Owns what is known of a moment. Must not know how it is drawn, nor where a board's readings come from.

mod boxes;
mod charts;
mod flow;
mod followed;
mod lines;
mod mark;
mod stepped;
mod traced;
mod twin;

pub use boxes::{Boxes, Now};
pub use charts::{Chart, Charts};
pub use flow::Flow;
pub use followed::Followed;
pub use lines::Lines;
pub use mark::Mark;
pub use twin::Twin;
