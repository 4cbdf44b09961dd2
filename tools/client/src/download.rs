//! The program that a board keeps, read back as numeric code.
//!
//! A board keeps no text: comments and names are gone, and each code stands on a line of its own. A jump is stored with its
//! line, so it stands on that line again: what is uploaded from here is kept as the same bytes.

use crate::client::{Client, Failure};
use crate::diagnostics::{Diagnostics, Kept};
use crate::map::input;
use std::fmt::Write;
use unoclp_core::isa::{Operand, START};
use unoclp_core::{Board, Loader, Program};
use unoclp_modbus::Exception;

/// Words that are read at once.
const AT_ONCE: u16 = 120;

/// Why no program was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unread {
    /// The board keeps none.
    Empty,
    /// Its firmware tells none: it is older, or that of a Nano.
    Untold,
    /// What was read is no program of this board: it changed meanwhile, or a later firmware stores it otherwise.
    Other,
    /// The line has failed.
    Failed(Failure),
}

impl From<Failure> for Unread {
    fn from(failure: Failure) -> Unread {
        Unread::Failed(failure)
    }
}

/// Reads the program of a board as numeric code, in any state of that.
///
/// # Errors
/// [`Unread`].
pub async fn download(client: &mut Client, board: Board) -> Result<String, Unread> {
    let kept = Diagnostics::read(client).await?.program;
    if kept.bytes == 0 && kept.sum == 0 {
        return Err(Unread::Empty);
    }
    if kept.bytes > board.stored_bytes {
        return Err(Unread::Other);
    }
    let end = input::PROGRAM.first + kept.bytes.div_ceil(2);
    let mut stored = Vec::new();
    let mut first = input::PROGRAM.first;
    while first < end {
        let count = (end - first).min(AT_ONCE);
        let words = client.words(input::PROGRAM.table, first, count).await;
        let words = words.map_err(|failure| match failure {
            Failure::Refused(Exception::IllegalDataAddress) => Unread::Untold,
            other => Unread::Failed(other),
        })?;
        stored.extend(words.into_iter().flat_map(u16::to_be_bytes));
        first += count;
    }
    stored.truncate(kept.bytes.into());
    text_of(&stored, kept, board).ok_or(Unread::Other)
}

/// The text of a program in its stored form; none where a board of this version does not keep that so.
fn text_of(stored: &[u8], kept: Kept, board: Board) -> Option<String> {
    let mut memory = vec![0; board.linked_bytes.max(board.stored_bytes).into()];
    let mut loader = Loader::new(&mut memory, board);
    loader.restore(&mut stored.iter().copied()).ok()?;
    let program = loader.finish().ok()?;
    (!Kept::of(&program).differs(kept)).then(|| codes(&program))
}

/// The lines of a file that is this program.
fn codes(program: &Program<'_>) -> String {
    let mut text = format!("{START}\n");
    let mut line = 2;
    // Writing to a string cannot fail.
    for step in program.steps() {
        if let Operand::Jump { line: its, .. } = step.operand {
            for _ in line..its {
                text.push('\n');
            }
            line = line.max(its);
        }
        for code in step.codes() {
            let _ = writeln!(text, "{code}");
            line = line.saturating_add(1);
        }
    }
    text
}
