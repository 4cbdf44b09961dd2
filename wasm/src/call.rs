//! The requests of a page.

use crate::board::{Boards, Open, Order};
use crate::draw::{As, Speak};
use crate::program::Text;
use crate::words::No;
#[cfg(feature = "full")]
use crate::{card, exercise};
use crate::{draw, program};
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// What a page may ask.
#[derive(Debug, Deserialize)]
#[serde(tag = "ask", rename_all = "camelCase")]
#[cfg_attr(
    not(feature = "full"),
    expect(dead_code, reason = "what it asks takes the other module")
)]
pub enum Request {
    /// What there is to say of a text: its problems, or its program.
    Check {
        #[serde(flatten)]
        text: Text,
    },
    /// Its ladder, for a page that shows it live, in so many columns where that is enough.
    Ladder {
        #[serde(flatten)]
        text: Text,
        width: usize,
        #[serde(default)]
        speak: Speak,
    },
    /// Its program in another form.
    List {
        #[serde(flatten)]
        text: Text,
        #[serde(rename = "as")]
        form: As,
        width: usize,
        #[serde(default)]
        speak: Speak,
    },
    /// Whether its program does what a scenario expects.
    Exercise {
        #[serde(flatten)]
        text: Text,
        scenario: String,
        title: String,
    },
    /// The image of a card with this PROGRAM.TXT.
    Card { program: String, state: bool },
    /// A file of a card, by its name, from the blocks that are not empty.
    Read {
        blocks: Vec<(u32, String)>,
        name: String,
    },
    /// A conversation with a board.
    Open(Open),
    /// A step of it: what has come since the last one, at this time in ms since any moment.
    Step { board: u32, now: f64, came: Vec<u8> },
    /// Something to be done by the board.
    Order { board: u32, order: Order },
    /// The line is gone, and why.
    Lose { board: u32, why: String },
    /// Firmware for a board, as Intel hex; the answer is the rate of its boot loader.
    Flash { hex: String, model: String },
    /// A step of that.
    FlashStep { now: f64, came: Vec<u8> },
    /// The line is gone meanwhile, and why.
    FlashLose { why: String },
    /// The end of a conversation.
    Close { board: u32 },
}

/// Answers a request.
///
/// # Errors
/// Why there is no answer.
pub fn answer(request: Request, boards: &mut Boards) -> Result<Value, No> {
    match request {
        Request::Check { text } => program::check(text).map(value),
        Request::Ladder { text, width, speak } => draw::ladder(text, width, speak).map(value),
        // Instruction List that is made is compiled again, by all that there is.
        #[cfg(feature = "full")]
        Request::List {
            text,
            form,
            width,
            speak,
        } => draw::listed(text, form, width, speak).map(value),
        #[cfg(feature = "full")]
        Request::Exercise {
            text,
            scenario,
            title,
        } => exercise::exercise(text, &title, &scenario).map(value),
        #[cfg(feature = "full")]
        Request::Card { program, state } => Ok(value(card::card(&program, state)?)),
        #[cfg(feature = "full")]
        Request::Read { blocks, name } => Ok(value(card::read(blocks, &name))),
        #[cfg(feature = "full")]
        Request::Flash { hex, model } => Ok(value(boards.flash.begin(&hex, &model)?)),
        #[cfg(feature = "full")]
        Request::FlashStep { now, came } => Ok(value(boards.flash.step(now, &came)?)),
        #[cfg(feature = "full")]
        Request::FlashLose { why } => {
            boards.flash.lose(why);
            Ok(Value::Null)
        }
        #[cfg(not(feature = "full"))]
        Request::List { .. }
        | Request::Exercise { .. }
        | Request::Card { .. }
        | Request::Read { .. }
        | Request::Flash { .. }
        | Request::FlashStep { .. }
        | Request::FlashLose { .. } => Err(No::More),
        Request::Open(open) => boards.open(open).map(value),
        Request::Step { board, now, came } => Ok(value(boards.step(board, now, &came)?)),
        Request::Order { board, order } => Ok(value(boards.order(board, order)?)),
        Request::Lose { board, why } => Ok(value(boards.lose(board, why)?)),
        Request::Close { board } => {
            boards.close(board);
            Ok(Value::Null)
        }
    }
}

/// As JSON. What is answered has no keys but texts, and so always is.
fn value(answer: impl Serialize) -> Value {
    serde_json::to_value(answer).unwrap_or_default()
}
