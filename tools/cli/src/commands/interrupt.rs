//! Ctrl-C during a conversation with a board: what is in progress ends in order. Pressed again, it ends at once.

use crate::messages;
use signal_hook::consts::SIGINT;
use signal_hook::flag;
use std::io;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The exit code of a program that Ctrl-C has ended, as shells have it.
const ENDED: i32 = 130;

/// Whether Ctrl-C was pressed.
pub struct Interrupt(Arc<AtomicBool>);

/// It was.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", messages::interrupted())]
pub struct Interrupted;

impl Interrupt {
    /// Notes Ctrl-C from now on.
    ///
    /// # Errors
    /// If the system does not let it.
    pub fn new() -> io::Result<Interrupt> {
        let pressed = Arc::new(AtomicBool::new(false));
        // This one comes first, so it sees only a second time.
        flag::register_conditional_shutdown(SIGINT, ENDED, pressed.clone())?;
        flag::register(SIGINT, pressed.clone())?;
        Ok(Interrupt(pressed))
    }

    /// Goes on until it is pressed.
    pub fn attend(&self) -> ControlFlow<Interrupted> {
        match self.0.load(Ordering::Relaxed) {
            false => ControlFlow::Continue(()),
            true => ControlFlow::Break(Interrupted),
        }
    }
}
