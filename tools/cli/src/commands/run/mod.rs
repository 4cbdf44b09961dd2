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

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;
    use unoclp_checked::Work;

    #[derive(Parser)]
    struct Asked {
        #[command(flatten)]
        what: What,
    }

    #[test]
    fn what_runs_was_compiled_once() {
        let st = "PROGRAM p VAR a : INT; END_VAR a := a + 1; END_PROGRAM";
        for (text, passes) in [("LD I1\nST Q1\n", 2), (st, 1)] {
            let asked = Asked::parse_from(["run", "--scans", "3", "--text", text]);
            let before = Work::done();
            assert!(run(asked.what).unwrap());
            let work = Work::since(before);
            // The copy that runs is loaded for itself; a typed text runs as its tree.
            assert_eq!((work.compiles, work.passes), (1, passes), "{text}");
        }
    }
}
