//! Where the steps of a program stand in the text that it comes from, and what that text calls its points.

use crate::Written;
use unoclp_core::{Instruction, isa::Opcode};
use unoclp_ladder::{Address, Ladder, Names, Place, Source};
use unoclp_lang::{CodeLine, Dialect};

impl Written {
    /// Where these steps stand in the text, and its comments.
    pub fn source<'c>(&self, steps: impl Iterator<Item = Instruction<'c>>) -> Source {
        let Some(compiled) = &self.compiled else {
            return Source::new(&self.bytes, steps);
        };
        let comments = Comments::of(&self.text);
        let mut source = Source {
            title: comments.title(),
            places: Vec::new(),
        };
        let mut told = 0;
        let mut rung = 0;
        for (step, line) in with_lines(steps, &compiled.lines) {
            let line = line.source.unwrap_or_default() as usize;
            let mut place = Place {
                first: line,
                last: line,
                comments: Vec::new(),
            };
            if step.opcode == Opcode::NewRung || source.places.is_empty() {
                rung = source.places.len();
                place.comments = comments.above(told, line);
                told = told.max(line);
            } else if let Some(begin) = source.places.get_mut(rung) {
                // What is compiled may stand in another order than the text; a rung has all its lines.
                begin.first = begin.first.min(line);
                place.last = begin.last.max(line);
                begin.last = place.last;
            }
            source.places.push(place);
        }
        source
    }

    /// The line of the text that each of these steps stands in, from 1.
    pub fn places<'c>(&self, steps: impl Iterator<Item = Instruction<'c>>) -> Vec<usize> {
        match &self.compiled {
            None => {
                let places = Source::new(&self.bytes, steps).places.into_iter();
                places.map(|place| place.first).collect()
            }
            Some(compiled) => with_lines(steps, &compiled.lines)
                .map(|(_, line)| line.source.unwrap_or_default() as usize)
                .collect(),
        }
    }

    /// What the text calls the points of this ladder, which is that of its steps.
    pub fn names<'c>(
        &self,
        ladder: &Ladder,
        steps: impl Iterator<Item = Instruction<'c>>,
    ) -> Names {
        let mut names = Names::new();
        let Some(compiled) = &self.compiled else {
            return names;
        };
        let lines: Vec<&CodeLine> = with_lines(steps, &compiled.lines)
            .map(|(_, line)| line)
            .collect();
        for element in &ladder.elements {
            let Some(point) = element.point else { continue };
            let last = element.steps.last().and_then(|&step| lines.get(step));
            let name = last.and_then(|line| name(&line.symbol, point, compiled.dialect));
            if let Some(name) = name {
                names.entry(point).or_insert_with(|| name.to_owned());
            }
        }
        names
    }
}

/// Each step with the line of its code; those of its operands are passed over.
fn with_lines<'c, 'l>(
    steps: impl Iterator<Item = Instruction<'c>>,
    lines: &'l [CodeLine],
) -> impl Iterator<Item = (Instruction<'c>, &'l CodeLine)> {
    // The first is program start.
    let mut lines = lines.iter().skip(1);
    steps.filter_map(move |step| {
        let line = lines.next()?;
        for _ in 1..step.codes().count() {
            lines.next();
        }
        Some((step, line))
    })
}

/// The name of a point in the words that its code comes from: `start`; of a block `CAL pause (…)`. None where
/// it is an address.
fn name(words: &str, point: Address, dialect: Dialect) -> Option<&str> {
    let part_of_name = |c: char| c.is_alphanumeric() || matches!(c, '_' | '%' | '.' | '#');
    let mut words = words
        .split(|c| !part_of_name(c))
        .filter(|word| !word.is_empty());
    let first = words.next()?;
    let name = match (point, words.next()) {
        (Address::Timer(_) | Address::Counter(_), Some(second)) => second,
        (_, None) => first,
        _ => return None,
    };
    let begins = name.starts_with(|c: char| c.is_alphabetic() || c == '_');
    (begins && !name.contains(['.', '#']) && !dialect.is_address(name)).then_some(name)
}

/// The comments of a text that stand on lines of their own.
struct Comments {
    /// By line: whether it holds more than comments, and the words of these.
    lines: Vec<(bool, String)>,
}

impl Comments {
    fn of(text: &str) -> Comments {
        let mut inside = false;
        let line = |line: &str| {
            let (mut rest, mut words, mut code) = (line, String::new(), String::new());
            while !rest.is_empty() {
                let ends: &[&str] = if inside {
                    &["*)", "* )"]
                } else {
                    &["(*", "//"]
                };
                let found = ends.iter().filter_map(|end| Some((rest.find(end)?, *end)));
                let next = found.min();
                let (before, end, behind) = match next {
                    Some((at, end)) => (&rest[..at], end, &rest[at + end.len()..]),
                    None => (rest, "", ""),
                };
                if inside { &mut words } else { &mut code }.push_str(before);
                if end == "//" {
                    words.push_str(behind);
                    break;
                }
                inside ^= !end.is_empty();
                rest = behind;
            }
            (!code.trim().is_empty(), words.trim().to_owned())
        };
        Comments {
            lines: text.lines().map(line).collect(),
        }
    }

    /// Those before all else.
    fn title(&self) -> Vec<String> {
        let lines = self.lines.iter().take_while(|(code, _)| !code);
        lines.filter_map(|(_, words)| some(words)).collect()
    }

    /// Those right above this line, behind that one and behind the title.
    fn above(&self, behind: usize, line: usize) -> Vec<String> {
        let before = self.lines.get(..line.saturating_sub(1)).unwrap_or_default();
        let Some(first) = before.iter().rposition(|(code, _)| *code) else {
            return Vec::new();
        };
        let between = before.get(behind.max(first + 1)..).unwrap_or_default();
        between
            .iter()
            .filter_map(|(_, words)| some(words))
            .collect()
    }
}

fn some(words: &str) -> Option<String> {
    (!words.is_empty()).then(|| words.to_owned())
}
