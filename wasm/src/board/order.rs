//! What may be ordered of a board.

use super::news::Line;
use crate::program::Text;
use crate::words::No;
use serde::Deserialize;

/// What may be ordered of a board.
#[derive(Debug, Deserialize)]
#[serde(tag = "do", rename_all = "camelCase")]
pub enum Order {
    /// RUN, from the beginning.
    Run,
    /// STOP.
    Stop,
    /// One single scan, in STOP.
    Scan,
    /// The whole start-up anew.
    Restart,
    /// Force an input or output, from 1, or let it go.
    Force {
        output: bool,
        number: u8,
        to: Option<bool>,
    },
    /// Let all points go.
    Release,
    /// Set an output, a marker, a register or a preset once.
    Set { point: String, value: i32 },
    /// Put this program on the board, and watch it from then on. It runs then, unless it stays in STOP.
    Upload {
        #[serde(flatten)]
        text: Text,
        #[serde(default)]
        stay: bool,
    },
    /// Watch this program from now on; it is said to be on the board.
    Watch {
        #[serde(flatten)]
        text: Text,
    },
    /// Read the settings.
    Settings,
    /// Change the settings: the lock holds at once, all else from the next start on.
    Settle { settings: Line },
}

impl Order {
    /// Whether this module can do it: a program in a typed language takes the one that has everything.
    ///
    /// # Errors
    /// [`No::More`]; what is wrong with a program is told when its turn comes.
    pub fn needs_no_more(&self) -> Result<(), No> {
        match self {
            Order::Upload { text, .. } | Order::Watch { text } => text.needs_no_more(),
            _ => Ok(()),
        }
    }
}
