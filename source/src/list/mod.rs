//! A program listed: as a ladder diagram, as Instruction List, or as numeric code with the
//! meaning of each line.

mod numeric;

use crate::{BOARD, Source, names};
use std::path::Path;
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
pub fn list(source: &Source, form: Form, width: usize) -> String {
    let program = source.program();
    match form {
        Form::Numeric => numeric::listing(program, &source.map),
        Form::Il => instructions_to_il(program.steps(), BOARD),
        Form::Ladder => {
            let ladder = Ladder::new(program.steps());
            let names = names(&source.map, &ladder);
            listing(&draw(&ladder, &names, width), &source.map, &names)
        }
    }
}

/// A ladder diagram as an SVG document. Its title is the first comment of the file, or the file's name.
pub fn svg(source: &Source, width: usize) -> String {
    let ladder = Ladder::new(source.program().steps());
    let names = names(&source.map, &ladder);
    let path = Path::new(&source.name);
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let title = source.map.title.first().map_or(&*name, String::as_str);
    to_svg(&draw(&ladder, &names, width), &source.map, &names, title)
}

fn draw<'l>(ladder: &'l Ladder, names: &Names, width: usize) -> Drawing<'l> {
    let live = |_| None;
    ladder.draw(&Style {
        width,
        names,
        live: &live,
    })
}
