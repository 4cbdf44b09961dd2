//! `unoclp units`.

use super::excerpt::renderer;
use super::open::read;
use crate::messages;
use crate::outcome::Outcome;
use anstream::print;
use std::path::Path;
use unoclp_exercise::scenario::ProgramFile;
use unoclp_lang as lang;
use unoclp_program::harmless_lines;

/// Prints the units and variables of a project; of what is none, what is wrong with it.
pub fn units(path: &Path) -> Outcome {
    let ProgramFile { name, bytes } = read(path)?;
    let (text, units) = unoclp_program::units(&bytes);
    match units {
        Ok(lines) => {
            print!("{}", harmless_lines(&lines));
            Ok(true)
        }
        Err(told) => {
            let told = lang::show(&name, &text, &told, messages::spoken(), &renderer());
            print!("{told}");
            Ok(false)
        }
    }
}
