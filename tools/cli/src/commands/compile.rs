//! `unoclp compile`.

use super::open::{Shown, open};
use super::output::{Kind, Over, is_same, write};
use super::wording::Wording;
use crate::messages;
use crate::outcome::Outcome;
use anstream::{eprintln, print};
use anyhow::bail;
use std::path::Path;

/// Compiles a text to numeric code, into this file or to standard output.
pub fn compile(path: &Path, output: Option<&Path>, over: Over, wording: &Wording) -> Outcome {
    let Some(program) = open(path, wording, Shown::Beside)? else {
        return Ok(false);
    };
    let name = &program.name;
    let (Some(told), Some(warnings)) =
        (wording.told(&program.language), program.language.warnings())
    else {
        bail!(messages::is_numeric(name))
    };
    match output.filter(|output| *output != Path::new("-")) {
        None => print!("{}", String::from_utf8_lossy(&program.file())),
        Some(output) if is_same(path, output) => bail!(messages::is_compiled(name)),
        Some(output) => write(output, program.file(), Kind::Program, &[], over)?,
    }
    let codes = program.size.codes;
    let compiled = messages::compiled(told, codes, warnings.len());
    eprintln!("{name}: {compiled}");
    if let Some(kept) = program.size.kept {
        eprintln!("{name}: {}", kept.told(messages::spoken()));
    }
    Ok(true)
}
