//! Where the steps of a program stand in its file, and the comments there.

use unoclp_core::Instruction;

/// The lines of a program file, as far as a listing shows them.
#[derive(Clone, Debug, Default)]
pub struct Source {
    /// The comments before program start, line by line.
    pub title: Vec<String>,
    /// Where each step stands.
    pub places: Vec<Place>,
}

/// Where a step stands in its file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// The line of its code, from 1.
    pub first: usize,
    /// The line of its last operand.
    pub last: usize,
    /// The comments on lines of their own between the code before and this one.
    pub comments: Vec<String>,
}

impl Source {
    /// Finds the steps of a checked program in its file.
    pub fn new<'c>(file: &[u8], steps: impl Iterator<Item = Instruction<'c>>) -> Source {
        let mut codes = codes(file).into_iter();
        let title = codes.next().unwrap_or_default().comments;
        let places = steps.map(|step| {
            let mut place = codes.next().unwrap_or_default();
            for _ in 1..step.codes().count() {
                place.last = codes.next().map_or(place.last, |operand| operand.last);
            }
            place
        });
        let places = places.collect();
        Source { title, places }
    }

    /// What the rung that begins with this step is about: the comments before it, or behind its first code.
    pub fn about(&self, first: usize) -> impl Iterator<Item = &str> {
        let places = self.places.iter().skip(first).take(2);
        let comments = places.map(|place| &place.comments);
        let some = comments.into_iter().find(|comments| !comments.is_empty());
        some.into_iter().flatten().map(String::as_str)
    }

    /// The lines of so many steps, first and last.
    pub fn lines(&self, first: usize, steps: usize) -> Option<(usize, usize)> {
        let last = self.places.get((first + steps).checked_sub(1)?)?;
        Some((self.places.get(first)?.first, last.last))
    }
}

/// The lines that hold a code (NC-3), program start among them.
fn codes(file: &[u8]) -> Vec<Place> {
    let text = String::from_utf8_lossy(file);
    let text = text.strip_prefix('\u{FEFF}').unwrap_or(&text);
    let mut codes = Vec::new();
    let mut comments = Vec::new();
    for (line, text) in (1..).zip(text.split('\n')) {
        let (code, comment) = text.split_once('/').unwrap_or((text, ""));
        if code.trim().is_empty() {
            let comment = comment.trim_start_matches('/').trim_end();
            // Rules made of dashes and the like say nothing.
            if comment.is_empty() || comment.chars().any(char::is_alphanumeric) {
                let comment = comment.strip_prefix(' ').unwrap_or(comment);
                comments.push(comment.to_owned());
            }
        } else {
            codes.push(Place {
                first: line,
                last: line,
                comments: paragraphs(std::mem::take(&mut comments)),
            });
        }
    }
    codes
}

/// The lines without the empty ones at the ends and those that follow another.
fn paragraphs(mut lines: Vec<String>) -> Vec<String> {
    lines.dedup_by(|line, before| line.is_empty() && before.is_empty());
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    if lines.first().is_some_and(String::is_empty) {
        lines.remove(0);
    }
    lines
}
