//! `unoclp adapt`.

use super::open::{no_program, read};
use super::output::write_new;
use super::wording::Wording;
use crate::messages;
use crate::outcome::Outcome;
use anstream::{eprintln, print};
use anyhow::{anyhow, bail};
use std::path::Path;
use unoclp_exercise::scenario::ProgramFile;

/// Writes a copy of a text with the points that the board lacks on others, into this file or to standard output.
pub fn adapt(path: &Path, output: Option<&Path>, wording: &Wording) -> Outcome {
    let ProgramFile { name, bytes } = read(path)?;
    let adapted = wording.of(name.clone(), bytes).adapted();
    let adapted = adapted.map_err(|why| anyhow!(no_program(&name, why)))?;
    let Some(adapted) = adapted else {
        bail!(messages::not_adapted(name))
    };
    let board = wording.board().name;
    if adapted.moved.is_empty() && adapted.left.is_empty() {
        eprintln!("{name}: {}", messages::nothing_to_adapt(board));
        return Ok(true);
    }
    match output.filter(|output| *output != Path::new("-")) {
        None => print!("{}", adapted.text),
        Some(output) => write_new(output, adapted.text.as_bytes())?,
    }
    for (old, new) in &adapted.moved {
        eprintln!("{old} -> {new}");
    }
    if !adapted.left.is_empty() {
        let left = adapted.left.join(", ");
        eprintln!("{name}: {}", messages::no_place(board, left));
    }
    Ok(adapted.left.is_empty())
}
