//! `unoclp list`: a program as a ladder diagram, or as numeric code with the meaning of each line.

mod numeric;

use crate::{BOARD, engine};
use std::path::Path;
use unoclp_core::Fault;
use unoclp_ladder::{Drawing, Ladder, Names, Source, Style, listing, to_svg};

/// What a program is listed as.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Form {
    /// A ladder diagram
    #[default]
    Ladder,
    /// Numeric code, each line with its letters and its meaning
    Numeric,
}

/// Lists a program file in so many columns, as far as the form can be narrow.
///
/// # Errors
/// The first fault of the file.
pub fn list(file: &[u8], form: Form, width: usize) -> Result<String, Fault> {
    let mut memory = vec![0; BOARD.plc_bytes()];
    let program = engine::load(file, &mut memory)?;
    let source = Source::new(file, program.steps());
    if form == Form::Numeric {
        return Ok(numeric::listing(&program, &source));
    }
    let names = Names::new();
    let ladder = Ladder::new(program.steps());
    Ok(listing(&draw(&ladder, &names, width), &source, &names))
}

/// A ladder diagram as an SVG document. Its title is the first comment of the file, or the file's name.
///
/// # Errors
/// The first fault of the file.
pub fn svg(file: &[u8], path: &Path, width: usize) -> Result<String, Fault> {
    let mut memory = vec![0; BOARD.plc_bytes()];
    let program = engine::load(file, &mut memory)?;
    let source = Source::new(file, program.steps());
    let names = Names::new();
    let ladder = Ladder::new(program.steps());
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
