//! A drawing as a listing: each rung with its number, its lines in the file, and what it is about.

use crate::{Drawing, Names, Source};
use std::fmt::Write;

/// The listing of a drawing, for text.
pub fn listing(drawing: &Drawing<'_>, source: &Source, names: &Names) -> String {
    let mut text = String::new();
    for (index, picture) in drawing.rungs.iter().enumerate() {
        let heading = heading(drawing, source, names, index);
        for line in &heading.lines {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{line}");
        }
        let _ = write!(text, "{picture}");
        if index + 1 < drawing.rungs.len() {
            text.push('\n');
        }
    }
    text
}

/// What stands above a rung.
pub(crate) struct Heading {
    /// `Rung 3, lines 27 to 31: Turning, or running out`, further lines of the comment, then labels.
    pub(crate) lines: Vec<String>,
}

pub(crate) fn heading(
    drawing: &Drawing<'_>,
    source: &Source,
    names: &Names,
    index: usize,
) -> Heading {
    let rung = &drawing.ladder().rungs[index];
    let mut first = format!("Rung {}", index + 1);
    match source.lines(rung.first, rung.steps) {
        Some((from, to)) if from == to => first += &format!(", line {from}"),
        Some((from, to)) => first += &format!(", lines {from} to {to}"),
        None => {}
    }
    let mut about = source.about(rung.first);
    if let Some(about) = about.next() {
        first += ": ";
        first += about;
    }
    let mut lines = vec![first];
    lines.extend(about.map(str::to_owned));
    lines.extend(rung.labels.iter().map(|&label| {
        let point = crate::Address::Label(label);
        match names.get(&point) {
            Some(name) => format!("{point}: {name}"),
            None => format!("{point}:"),
        }
    }));
    Heading { lines }
}
