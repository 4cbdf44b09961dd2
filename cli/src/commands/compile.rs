//! `unoclp compile`.

use super::open::{Il, Shown, open};
use super::output::{Kind, create, is_same};
use crate::{Outcome, cannot_write};
use anstream::{eprintln, print};
use anyhow::{Context, bail};
use std::io::Write;
use std::path::Path;
use unoclp_cli::messages;
use unoclp_lang::Lang;
use unoclp_source::Language;

/// Compiles Instruction List to numeric code, into this file or to standard output.
pub fn compile(path: &Path, output: Option<&Path>, il: &Il) -> Outcome {
    let Some(program) = open(path, il, Shown::Beside)? else {
        return Ok(false);
    };
    let lang = il.lang();
    let name = &program.name;
    let Language::Il { dialect, warnings } = &program.language else {
        bail!(messages::is_numeric(name))
    };
    match output.filter(|output| *output != Path::new("-")) {
        None => print!("{}", String::from_utf8_lossy(&program.code)),
        Some(output) if is_same(path, output) => bail!(messages::is_compiled(name)),
        Some(output) => create(output, Kind::Program, &[])?
            .write_all(&program.code)
            .with_context(|| cannot_write(output))?,
    }
    let (dialect, warnings) = (il.dialect(*dialect), warnings.len());
    let codes = program.size.codes;
    eprintln!(
        "{name}: {}",
        match lang {
            Lang::En => format!("{dialect}; codes: {codes}, warnings: {warnings}"),
            Lang::Pt => format!("{dialect}; códigos: {codes}, avisos: {warnings}"),
        }
    );
    Ok(true)
}
