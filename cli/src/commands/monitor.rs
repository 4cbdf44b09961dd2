//! `unoclp monitor`.

use super::open::{Il, Shown, open};
use crate::Outcome;
use anyhow::bail;
use std::io::{IsTerminal, stdin, stdout};
use std::path::Path;
use unoclp_board::{Line, Patience};
use unoclp_cli::monitor::{App, Program, run, watch};

/// Shows a board until the person leaves.
pub fn monitor(path: Option<&Path>, line: Line, il: &Il) -> Outcome {
    let program = match path {
        None => None,
        Some(path) => match open(path, il, Shown::Here)? {
            Some((program, _)) => Some(Program::new(program)?),
            None => return Ok(false),
        },
    };
    if !(stdin().is_terminal() && stdout().is_terminal()) {
        bail!("the monitor needs a terminal");
    }
    let scope = program.as_ref().map(Program::scope).unwrap_or_default();
    let place = format!("{}, address {}", line.port, line.address);
    let (wish, news) = watch(line, Patience::default(), scope);
    run(App::new(place, program), &wish, &news)?;
    Ok(true)
}
