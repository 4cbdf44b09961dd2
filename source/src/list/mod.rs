//! `unoclp list`: a program as a ladder diagram, as Instruction List, or as numeric code with the
//! meaning of each line.

mod numeric;

use crate::Written;
use crate::{BOARD, load};
use std::path::Path;
use unoclp_core::Fault;
use unoclp_ladder::{Drawing, Ladder, Names, Style, listing, to_svg};
use unoclp_lang::instructions_to_il;

/// What a program is listed as.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// A ladder diagram
    #[default]
    Ladder,
    /// Instruction List, in the words of IEC 61131-3
    Il,
    /// Numeric code, each line with its letters and its meaning
    Numeric,
}

/// Lists a program in so many columns, as far as the form can be narrow.
///
/// # Errors
/// The first fault of the program.
pub fn list(file: &Written, form: Form, width: usize) -> Result<String, Fault> {
    let mut memory = vec![0; BOARD.plc_bytes()];
    let program = load(&file.bytes, &mut memory)?;
    let source = file.source(program.steps());
    match form {
        Form::Numeric => Ok(numeric::listing(&program, &source)),
        Form::Il => Ok(instructions_to_il(program.steps(), BOARD)),
        Form::Ladder => {
            let ladder = Ladder::new(program.steps());
            let names = file.names(&ladder, program.steps());
            Ok(listing(&draw(&ladder, &names, width), &source, &names))
        }
    }
}

/// A ladder diagram as an SVG document. Its title is the first comment of the file, or the file's name.
///
/// # Errors
/// The first fault of the program.
pub fn svg(file: &Written, width: usize) -> Result<String, Fault> {
    let mut memory = vec![0; BOARD.plc_bytes()];
    let program = load(&file.bytes, &mut memory)?;
    let source = file.source(program.steps());
    let ladder = Ladder::new(program.steps());
    let names = file.names(&ladder, program.steps());
    let path = Path::new(&file.name);
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let title = source.title.first().map_or(&*name, String::as_str);
    Ok(to_svg(
        &draw(&ladder, &names, width),
        &source,
        &names,
        title,
    ))
}

fn draw<'l>(ladder: &'l Ladder, names: &Names, width: usize) -> Drawing<'l> {
    let live = |_| None;
    ladder.draw(&Style {
        width,
        names,
        live: &live,
    })
}
