//! `unoclp monitor`: a board in a terminal, like the simulator.
//!
//! - `watcher`: the thread that reads the board, and finds it again when it is lost
//! - `app`: what is shown, and which keys ask what of the board; knows no terminal and no port
//! - `program`: the program file that the board should run
//! - `view`: from the app to the screen
//! - `run`: the loop of frames, key events and news

mod app;
mod program;
mod run;
mod view;
mod watcher;

#[cfg(test)]
mod tests;

pub use app::App;
pub use program::Program;
pub use run::run;
pub use watcher::{News, watch};
