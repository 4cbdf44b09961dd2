//! The text of a running program, each line with what the last scan has made of it: `  14 ● LD  start`.

use super::ON;
use ratatui::style::Style;
use ratatui::text::Line;
use std::collections::BTreeSet;
use unoclp_exercise::live::{Flow, Lines, Mark};
use unoclp_program::Source;

/// Lines of a text that slow motion marks, from 1.
#[derive(Clone, Debug, Default)]
pub struct Marked {
    /// The one that comes next.
    pub next: Option<usize>,
    /// Those with a breakpoint.
    pub breaks: BTreeSet<usize>,
}

/// The lines of a text, with the steps that tell how each stands.
pub struct Listing(Lines);

impl Listing {
    /// The lines of the text of this program.
    pub fn new(program: &Source) -> Listing {
        Listing(Lines::new(program))
    }

    /// The first line that does something, counted from 0.
    pub fn first(&self) -> usize {
        self.0.first()
    }

    /// The lines as they stand, those that work on a number with that number; else `●` where the line has power, what it tests
    /// holds, or the bit that it stores is 1; `○` where not; neither where the scan has not come there.
    /// The line that comes next is marked, and those with a breakpoint.
    pub fn lines(&self, flow: &Flow, slow: &Marked) -> Vec<Line<'static>> {
        let line = |((number, text), mark): ((usize, &str), Mark)| {
            let number = match slow {
                Marked { next, .. } if *next == Some(number) => format!("{number:>3}▶"),
                Marked { breaks, .. } if breaks.contains(&number) => format!("{number:>3}■"),
                _ => format!("{number:>4}"),
            };
            let (lamp, style) = match mark {
                Mark::Power(Some(true)) => ('●', ON),
                Mark::Power(Some(false)) => ('○', Style::new()),
                Mark::Power(None) => (' ', Style::new()),
                Mark::Value(Some(value)) => {
                    return Line::raw(format!("{number}   {text}  = {value}"));
                }
                Mark::Value(None) => return Line::raw(format!("{number}   {text}")),
            };
            Line::styled(format!("{number} {lamp} {text}"), style)
        };
        let texts = (1..).zip(self.0.texts());
        texts.zip(self.0.marks(flow)).map(line).collect()
    }
}
