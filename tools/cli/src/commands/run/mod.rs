//! `unoclp run`: runs a program on this PC, and shows what its variables hold at the end.
//!
//! - `what`: what is run, and how; `ran`: its result
//! - `tree`: a text in a typed language, with all types
//! - `core`: Instruction List and numeric code, as the board runs them
//! - `table`: the symbols as a table
//! - `json`: all of it as one object

mod core;
mod json;
mod ran;
mod table;
mod tree;
mod what;

use super::open::no_program;
use crate::outcome::Outcome;
use anstream::print;
use anyhow::bail;
use unoclp_program::{WrittenIn, harmless_lines};
use what::program;

pub use what::What;

/// `unoclp run`.
pub fn run(arguments: What) -> Outcome {
    let written = program(&arguments)?;
    let ran = match written.language {
        Ok(WrittenIn::Typed(language)) => tree::run(&arguments, written, language)?,
        Ok(WrittenIn::Il | WrittenIn::Numeric | WrittenIn::Xml) => core::run(&arguments, written)?,
        Err(why) => bail!(no_program(&written.name, why)),
    };
    let Some(ran) = ran else {
        return Ok(false);
    };
    match arguments.json {
        true => print!("{}", json::json(&ran)),
        false => print!("{}", harmless_lines(&table::table(&ran))),
    }
    Ok(true)
}
