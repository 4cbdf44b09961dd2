//! The text of a running program, each line with what the last scan has made of it: `  14 ● LD  start`.

use super::ON;
use ratatui::style::{Modifier, Style};
use ratatui::text::{Line, Span};
use std::collections::BTreeSet;
use unoclp_exercise::live::{Flow, Lines, Mark};
use unoclp_program::Source;

/// What slow motion marks: steps of the program.
#[derive(Clone, Debug, Default)]
pub struct Marked {
    /// The one that comes next.
    pub next: Option<usize>,
    /// Those with a breakpoint.
    pub breaks: BTreeSet<usize>,
    /// The one that a person points to.
    pub cursor: Option<usize>,
}

impl Marked {
    /// The number of a line or a rung as it is, or with its mark, where this says which steps are of it: `  4▶`.
    pub fn number(&self, number: &str, holds: impl Fn(usize) -> bool) -> Span<'static> {
        let marked = |mark| format!("{:>3}{mark}", number.trim());
        let number = match self {
            Marked { next, .. } if next.is_some_and(&holds) => marked('▶'),
            Marked { breaks, .. } if breaks.iter().any(|step| holds(*step)) => marked('■'),
            _ => number.to_owned(),
        };
        match self.cursor.is_some_and(holds) {
            true => Span::styled(number, Style::new().add_modifier(Modifier::REVERSED)),
            false => Span::raw(number),
        }
    }
}

/// The lines of a text, with the steps that tell how each stands.
pub struct Listing {
    lines: Lines,
    /// The line of each step, from 1.
    of: Vec<usize>,
}

impl Listing {
    /// The lines of the text of this program.
    pub fn new(program: &Source) -> Listing {
        Listing {
            lines: Lines::new(program),
            of: program.map.steps.iter().map(|place| place.line).collect(),
        }
    }

    /// The first line that does something, counted from 0.
    pub fn first(&self) -> usize {
        self.lines.first()
    }

    /// The line that a step comes from, counted from 0.
    pub fn row(&self, step: usize) -> Option<usize> {
        self.of.get(step)?.checked_sub(1)
    }

    /// The lines as they stand, those that work on a number with that number; else `●` where the line has power, what it tests
    /// holds, or the bit that it stores is 1; `○` where not; neither where the scan has not come there.
    /// The line that comes next is marked, those with a breakpoint, and that of the cursor.
    pub fn lines(&self, flow: &Flow, slow: &Marked) -> Vec<Line<'static>> {
        let line = |((number, text), mark): ((usize, &str), Mark)| {
            let is_of = |step: usize| self.of.get(step) == Some(&number);
            let margin = slow.number(&format!("{number:>4}"), is_of);
            let (lamp, style) = match mark {
                Mark::Power(Some(true)) => ('●', ON),
                Mark::Power(Some(false)) => ('○', Style::new()),
                Mark::Power(None) => (' ', Style::new()),
                Mark::Value(Some(value)) => {
                    return Line::from(vec![margin, Span::raw(format!("   {text}  = {value}"))]);
                }
                Mark::Value(None) => {
                    return Line::from(vec![margin, Span::raw(format!("   {text}"))]);
                }
            };
            Line::from(vec![margin, Span::raw(format!(" {lamp} {text}"))]).style(style)
        };
        let texts = (1..).zip(self.lines.texts());
        texts.zip(self.lines.marks(flow)).map(line).collect()
    }
}
