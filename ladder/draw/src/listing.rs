//! A drawing as a listing: each rung with its number, its lines in the file, and what it is about.

use crate::words::picture;
use crate::{Drawing, Ladder, Names, blocks};
use unicode_width::UnicodeWidthStr;
use unoclp_checked::SourceMap;
use unoclp_point::Address;

/// What a rung is called: by its number, from 1, and its first and last line, if it has lines.
pub type Title<'t> = &'t dyn Fn(usize, Option<(usize, usize)>) -> String;

/// The listing of a drawing, for text: what the program is about, then its rungs under their titles.
pub fn listing(drawing: &Drawing<'_>, map: &SourceMap, names: &Names, title: Title<'_>) -> String {
    let rungs = drawing.rungs.iter().map(ToString::to_string);
    listed(drawing.headed(), map, names, title, rungs)
}

/// The same as block diagrams; titles take so many columns.
pub fn listing_of_blocks(
    ladder: &Ladder,
    columns: usize,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
) -> String {
    let rungs = ladder.rungs.iter().map(|rung| {
        let lines = blocks::picture(ladder, rung, names).into_iter();
        lines.map(|line| line + "\n").collect()
    });
    listed((ladder, columns), map, names, title, rungs)
}

fn listed(
    (ladder, limit): (&Ladder, usize),
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    rungs: impl ExactSizeIterator<Item = String>,
) -> String {
    let mut text = String::new();
    for line in &map.title {
        // A line that fits stays as it is: it may be part of a table.
        let lines = match line.width() <= limit {
            true => vec![line.clone()],
            false => wrapped(line, limit),
        };
        for line in lines {
            text += &format!("{line}\n");
        }
    }
    if !map.title.is_empty() {
        text.push('\n');
    }
    let count = rungs.len();
    for (index, picture) in rungs.enumerate() {
        for line in heading((ladder, limit), map, names, title, index) {
            text += &format!("{line}\n");
        }
        text += &picture;
        if index + 1 < count {
            text.push('\n');
        }
    }
    text
}

/// What stands above a rung: `Rung 3, lines 27 to 31 (Motor): Turning, or coasting`, with the unit that it comes from,
/// and the lines in others, `(Motor 9-12)`, as many lines as that takes; then its labels.
pub(crate) fn heading(
    (ladder, limit): (&Ladder, usize),
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    index: usize,
) -> Vec<String> {
    let rung = &ladder.rungs[index];
    let mut first = title(index + 1, map.lines(rung.first, rung.steps));
    let units = map.units(rung.first, rung.steps);
    let unit = |(at, (unit, (from, to))): (usize, &(Option<&str>, (usize, usize)))| {
        let unit = unit.as_ref()?;
        Some(match (at, from == to) {
            (0, _) => (*unit).to_owned(),
            (_, true) => format!("{unit} {from}"),
            (..) => format!("{unit} {from}-{to}"),
        })
    };
    let units: Vec<String> = units.iter().enumerate().filter_map(unit).collect();
    if !units.is_empty() {
        first += &format!(" ({})", units.join(", "));
    }
    let about: Vec<&str> = map.about(rung.first).collect();
    if !about.is_empty() {
        first += ": ";
        first += &about.join(" ");
    }
    let mut lines = wrapped(&first, limit);
    lines.extend(rung.part.map(|part| format!("{}:", picture(part))));
    lines.extend(rung.labels.iter().map(|&label| {
        let point = Address::Label(label);
        match names.get(&point) {
            Some(name) => format!("{point}: {name}"),
            None => format!("{point}:"),
        }
    }));
    lines
}

/// The words of a text in lines of so many columns; a longer word is a line of its own.
pub(crate) fn wrapped(text: &str, columns: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    for word in text.split_whitespace() {
        if !line.is_empty() && line.width() + 1 + word.width() > columns {
            lines.push(std::mem::take(&mut line));
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    lines.push(line);
    lines
}
