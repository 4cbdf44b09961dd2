//! `unoclp upload`.

use super::meet;
use super::open::faulty;
use super::open::{Il, Shown, open};
use crate::Outcome;
use anstream::{eprint, println};
use anyhow::{Context, bail};
use std::io::{IsTerminal, stderr};
use std::path::Path;
use unoclp_board::diagnostics::Kept;
use unoclp_board::map::{State, flag};
use unoclp_board::upload::{Behind, Broken, Progress, go_on, stop, upload as send};
use unoclp_cli::port::Place;

/// Checks a program, and puts it on a board.
pub fn upload(path: &Path, place: &Place, stays: bool, il: &Il) -> Outcome {
    let Some(program) = open(path, il, Shown::Here)? else {
        return Ok(false);
    };
    println!("{}: {}: OK", program.name, program.size);
    let sent = Kept::of(program.program());

    let mut port = meet(place)?;
    let before = port.talk(stop).context("the board cannot be stopped")?;
    let state = match before.state {
        Some(state) => state,
        None => bail!("the board is in a state that this version of unoclp does not know"),
    };
    match state {
        State::Run => println!("STOP"),
        State::Stop if before.has(flag::STOP_SWITCH) => println!("A5 is closed: in STOP"),
        State::Stop => println!("in STOP"),
        State::Fault => match before.trouble {
            Some(trouble) => println!("in FAULT, {trouble}"),
            None => println!("in FAULT"),
        },
    }

    let code = &program.code;
    let uploaded = port.talk(async |client| send(client, code, sent, &mut show).await);
    hide();
    let kept = match uploaded {
        Ok(kept) => kept,
        Err(Broken::Fault(trouble)) => {
            let Some(fault) = trouble.fault() else {
                bail!("the board says {trouble}");
            };
            println!("the board refuses the program, and keeps the one that it had:");
            println!("{}", faulty(&program, fault));
            return Ok(false);
        }
        Err(broken) => return Err(broken.into()),
    };
    println!("stored: {} bytes, check sum {:04X}", kept.bytes, kept.sum);

    let behind = port.talk(async |client| go_on(client, state, kept, stays).await);
    let behind = behind.context("the program is stored, but the board does not start it")?;
    match behind {
        Behind::Run => println!("RUN"),
        Behind::Stop => println!("in STOP"),
        Behind::Switch => println!("A5 is closed: in STOP, until A5 is opened"),
        Behind::Faulty => println!("in FAULT: it runs the program from its next restart on"),
        Behind::Card => bail!(
            "the program was stored, but the board's card has another PROGRAM.TXT, which it took at \
             its restart; take the card out, or put the program on it"
        ),
        Behind::Trouble(trouble) => {
            bail!("the program is stored; restarted, the board says {trouble}")
        }
    }
    Ok(true)
}

/// Shows the progress in a line that changes, where somebody sees it.
fn show(progress: Progress) {
    if stderr().is_terminal() {
        match progress {
            Progress::Sent { pass, bytes, of } => {
                eprint!("{ANEW}{pass}: {bytes} of {of} bytes");
            }
            Progress::Storing => eprint!("{ANEW}writing program memory …"),
        }
    }
}

/// Takes the line back.
fn hide() {
    if stderr().is_terminal() {
        eprint!("{ANEW}");
    }
}

/// Back to the beginning of an empty line.
const ANEW: &str = "\r\x1b[K";
