//! `unoclp sim`: the simulator in a terminal.
//!
//! - `app`: what is shown and how keys and time change it; knows no terminal
//! - `buttons`: the inputs, as buttons that keys press
//! - `analogue`: the analogue inputs, as knobs that keys turn
//! - `memory`: counters, registers, markers and the like
//! - `ladder`: the rungs as lines of text, with what is energised
//! - `listing`: the text of the program, with what each line has come to
//! - `drawn`: which of the two is shown
//! - `slow`: a scan in slow motion: where it stands, and its breakpoints
//! - `view`: from the app to the screen
//! - `run`: the loop of frames and key events

mod analogue;
mod app;
mod buttons;
mod drawn;
mod ladder;
mod listing;
mod memory;
mod run;
mod slow;
mod view;

#[cfg(test)]
mod tests;

pub use app::App;
pub(crate) use drawn::Drawn;
pub(crate) use listing::Marked;
pub use run::run;

use ratatui::style::{Color, Modifier, Style};

/// How what is 1 is drawn.
const ON: Style = Style::new().fg(Color::Green).add_modifier(Modifier::BOLD);
