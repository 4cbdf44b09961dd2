//! `unoclp monitor`.

use crate::{Outcome, read, refuse};
use anyhow::bail;
use std::io::{IsTerminal, stdin, stdout};
use std::path::Path;
use unoclp_host_sim::board::{Line, Patience};
use unoclp_host_sim::diagnosis::diagnose;
use unoclp_host_sim::monitor::{App, Program, run, watch};

/// Shows a board until the person leaves.
pub fn monitor(path: Option<&Path>, line: Line) -> Outcome {
    let program = match path {
        None => None,
        Some(path) => {
            let file = read(path)?;
            if let Err(faults) = diagnose(&file.bytes) {
                return Ok(refuse(&file, &faults));
            }
            Some(Program::new(file.name, &file.bytes)?)
        }
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
