//! The tools of unoclp for a page in a browser: one text in, one text out, both JSON.
//!
//! The page writes a request where [`unoclp_room`] says, calls [`unoclp_call`], and finds the answer at
//! [`unoclp_answer`]. Everything else is [`answer`], which tests call without a browser.
//!
//! A machine beside a board takes a step each simulated millisecond, too often for texts: [`unoclp_step`] has numbers alone,
//! and [`Wires`] is where they lie. Tests call [`step`].
//!
//! - `ask`: which requests there are, what each takes, and what it is answered; `given`: how that is read; `answer`: the types of
//!   answers, and what TypeScript calls them
//! - `call`, `more`: how they are answered; `json`: how answers are written
//! - `facts`: the board that a program is for, and what it has
//! - `program`: a text as a person has written it, and what there is to show of it
//! - `start`: the program that a page begins with
//! - `tell`: problems, with their places
//! - `draw`: ladders and lists; `adapt`: a text with its points on this board
//! - `edit`: a program that a person draws; `chart`: charts, drawn and changed
//! - `exercise`: scenarios as checks of a student's program
//! - `card`: images of cards
//! - `machine`: a machine beside the board
//! - `replay`: what went wrong with a machine, to be seen again
//! - `board`: conversations with a board, simulated or real
//! - `clock`: the times of a page
//!
//! Owns the form of requests and answers. Must not know how they are carried, nor what a page looks like.
//! Nothing in a request makes it panic: what is wrong is an answer.

#![deny(unsafe_code)]

#[cfg(feature = "full")]
mod adapt;
mod answer;
mod ask;
#[cfg(feature = "full")]
mod assist;
mod board;
mod call;
#[cfg(feature = "full")]
mod card;
#[cfg(feature = "full")]
mod chart;
mod clock;
mod draw;
#[cfg(feature = "full")]
mod edit;
#[cfg(feature = "full")]
mod exercise;
mod facts;
mod given;
mod json;
#[cfg(feature = "full")]
mod machine;
#[cfg(feature = "full")]
mod more;
mod program;
#[cfg(feature = "full")]
mod project;
#[cfg(feature = "full")]
mod replay;
#[cfg(feature = "full")]
mod slow;
#[cfg(any(test, not(feature = "full")))]
mod start;
mod tell;
mod words;

use given::Given;
use std::cell::RefCell;
use words::No;

thread_local! {
    static DESK: RefCell<Desk> = RefCell::new(Desk::default());
}

/// What lies between the page and its calls.
#[derive(Default)]
struct Desk {
    request: Vec<u8>,
    answer: Vec<u8>,
    boards: board::Boards,
    #[cfg(feature = "full")]
    wires: Wires,
}

/// Room for a request of so many bytes, and where it is.
#[allow(unsafe_code, reason = "a page finds an export by its name")]
#[unsafe(no_mangle)]
pub extern "C" fn unoclp_room(bytes: usize) -> *mut u8 {
    DESK.with_borrow_mut(|desk| {
        desk.request.clear();
        desk.request.resize(bytes, 0);
        desk.request.as_mut_ptr()
    })
}

/// Answers the request; gives the bytes of the answer.
#[allow(unsafe_code, reason = "a page finds an export by its name")]
#[unsafe(no_mangle)]
pub extern "C" fn unoclp_call() -> usize {
    DESK.with_borrow_mut(|desk| {
        desk.answer = answer(&desk.request, &mut desk.boards).into_bytes();
        desk.answer.len()
    })
}

/// Where the last answer is, until the next call.
#[allow(unsafe_code, reason = "a page finds an export by its name")]
#[unsafe(no_mangle)]
pub extern "C" fn unoclp_answer() -> *const u8 {
    DESK.with_borrow(|desk| desk.answer.as_ptr())
}

pub use board::Boards;
#[cfg(feature = "full")]
pub use machine::Wires;

/// Where the page writes, of the output with each number, what share of 255 it was high, before [`unoclp_step`].
#[cfg(feature = "full")]
#[allow(unsafe_code, reason = "a page finds an export by its name")]
#[unsafe(no_mangle)]
pub extern "C" fn unoclp_shares() -> *mut u8 {
    DESK.with_borrow_mut(|desk| desk.wires.shares.as_mut_ptr())
}

/// Where the page reads what A 00 and those after it are, 16 bits each, after [`unoclp_step`].
#[cfg(feature = "full")]
#[allow(unsafe_code, reason = "a page finds an export by its name")]
#[unsafe(no_mangle)]
pub extern "C" fn unoclp_readings() -> *const u16 {
    DESK.with_borrow(|desk| desk.wires.readings.as_ptr())
}

/// The machine goes on for so many ms: see [`step`]; -1 where none is open. A number of JavaScript holds both.
#[cfg(feature = "full")]
#[allow(unsafe_code, reason = "a page finds an export by its name")]
#[unsafe(no_mangle)]
pub extern "C" fn unoclp_step(levels: u32, ms: u32) -> f64 {
    DESK.with_borrow_mut(|desk| {
        step(&mut desk.boards, levels, &mut desk.wires, ms).map_or(-1.0, f64::from)
    })
}

/// The machine that is open goes on for so many ms, at most 250, with these outputs: bit n is output n + 1. Gives the inputs
/// that are 1 in the same way; none where no machine is open.
#[cfg(feature = "full")]
pub fn step(boards: &mut Boards, levels: u32, wires: &mut Wires, ms: u32) -> Option<u32> {
    let machine = boards.machine.as_mut()?;
    Some(machine.pass(levels, wires, ms))
}

/// The answer to a request: `{"ok": …}`, `{"error": {"en": …, "pt": …}}`, where a field is wrong with its `field` and
/// `offers` too, or `{"more": true}` from a module without the
/// feature `full` for what takes it.
pub fn answer(request: &[u8], boards: &mut Boards) -> String {
    let told = Given::read(request).map_err(No::Told);
    match told.and_then(|given| call::answer(given, boards)) {
        Ok(ok) => format!("{{\"ok\":{ok}}}"),
        Err(No::Told(both)) => {
            let both = serde_json::to_string(&both).unwrap_or_default();
            format!("{{\"error\":{both}}}")
        }
        #[cfg(feature = "full")]
        Err(No::Amiss(amiss)) => {
            let amiss = serde_json::to_string(&amiss).unwrap_or_default();
            format!("{{\"error\":{amiss}}}")
        }
        Err(No::More) => "{\"more\":true}".to_owned(),
    }
}
