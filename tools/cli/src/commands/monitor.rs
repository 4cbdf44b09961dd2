//! `unoclp monitor`.

use super::open::{Shown, open};
use super::wording::Wording;
use crate::messages;
use crate::monitor::{App, Program, run, watch};
use crate::outcome::Outcome;
use crate::port::Place;
use anstream::println;
use anyhow::{anyhow, bail};
use std::io::{IsTerminal, stdin, stdout};
use std::path::Path;
use unoclp_client::Patience;
use unoclp_core::Fault;
use unoclp_program::not_sent;

/// Shows a board until the person leaves.
pub fn monitor(
    path: Option<&Path>,
    place: Place,
    end_forcing: Option<u8>,
    wording: &Wording,
) -> Outcome {
    let program = match path {
        None => None,
        Some(path) => match open(path, wording, Shown::Here)? {
            Some(source) => {
                if let Some(why) = not_sent(&source, messages::spoken()) {
                    bail!("{}: {why}", source.name);
                }
                let fault = |fault: Fault| anyhow!(messages::fault(fault.cause));
                Some(Program::new(source).map_err(fault)?)
            }
            None => return Ok(false),
        },
    };
    if !(stdin().is_terminal() && stdout().is_terminal()) {
        bail!(messages::needs_terminal());
    }
    let scope = program.as_ref().map(Program::scope).unwrap_or_default();
    let app = App::new(place.to_string(), wording.board(), program, end_forcing);
    let (wish, news) = watch(place, Patience::default(), scope, end_forcing);
    let forced = run(app, &wish, &news)?;
    if forced.any() {
        println!("{}", messages::left_forced(forced));
    }
    Ok(true)
}
