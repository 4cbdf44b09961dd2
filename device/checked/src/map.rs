//! Where the steps of a program stand in its text, and what the text says of them.
//!
//! Owns lines, columns, units, comments and names, as the compiler that read the text has found them. Must not
//! know a language, nor read a text: a line is a number here.

use std::ops::RangeInclusive;
use std::sync::Arc;

/// Where the steps of a program stand in its text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SourceMap {
    /// The comments before all code, line by line.
    pub title: Vec<String>,
    /// A place for each step, in the order of the program.
    pub steps: Vec<Place>,
}

/// Where a step stands. Lines and columns count from 1; a column is a character.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The function or function block that it stands in; none in the program itself.
    pub unit: Option<Arc<str>>,
    /// The line of its first character.
    pub line: usize,
    /// The column of its first character.
    pub column: usize,
    /// The line of its last operand.
    pub last: usize,
    /// The comments on lines of their own between the code before and this one.
    pub comments: Vec<String>,
    /// What the text calls its point; none where it gives the point's address.
    pub name: Option<String>,
    /// The lines of numeric code that it has become, which the faults of a running program name.
    pub codes: RangeInclusive<u32>,
}

impl SourceMap {
    /// The line and column of each step.
    pub fn at(&self) -> impl Iterator<Item = (usize, usize)> {
        self.steps.iter().map(|place| (place.line, place.column))
    }

    /// What the rung that begins with this step is about: the comments before it, or after its first code.
    pub fn about(&self, first: usize) -> impl Iterator<Item = &str> {
        let places = self.steps.iter().skip(first).take(2);
        let comments = places.map(|place| &place.comments);
        let some = comments.into_iter().find(|comments| !comments.is_empty());
        some.into_iter().flatten().map(String::as_str)
    }

    /// The lines that `steps` steps from `first` on stand in, the least and the greatest: what is compiled may
    /// stand in another order than the text. Of steps from several units, those of the first of these.
    pub fn lines(&self, first: usize, steps: usize) -> Option<(usize, usize)> {
        let units = self.units(first, steps);
        units.first().map(|(_, lines)| *lines)
    }

    /// The functions and function blocks that `steps` steps from `first` on stand in, in the order of the steps, and the
    /// least and the greatest line in each; none is the program itself.
    pub fn units(&self, first: usize, steps: usize) -> Vec<(Option<&str>, (usize, usize))> {
        let places = self.steps.get(first..first + steps).unwrap_or_default();
        // What begins a rung may stand in the unit in which the one before has ended.
        let places = match places {
            [begins, own @ ..] if own.first().is_some_and(|own| own.unit != begins.unit) => own,
            all => all,
        };
        let mut units: Vec<(Option<&str>, (usize, usize))> = Vec::new();
        for place in places {
            let unit = place.unit.as_deref();
            match units.iter_mut().find(|(of, _)| *of == unit) {
                Some((_, (least, last))) => {
                    *least = (*least).min(place.line);
                    *last = (*last).max(place.last);
                }
                None => units.push((unit, (place.line, place.last))),
            }
        }
        units
    }

    /// The step that has become this line of numeric code.
    pub fn of_code(&self, line: u32) -> Option<&Place> {
        let index = self
            .steps
            .partition_point(|place| *place.codes.end() < line);
        self.steps
            .get(index)
            .filter(|place| place.codes.contains(&line))
    }
}
