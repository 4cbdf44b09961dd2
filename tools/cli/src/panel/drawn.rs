//! A running program as a person looks at it: its charts, its ladder diagram, or the text that it comes from.

use super::ladder::Rungs;
use super::listing::{Listing, Marked};
use super::slow::Among;
use crate::messages;
use ratatui::text::Line;
use unoclp_exercise::live::{Charts, Flow};
use unoclp_point::Address;
use unoclp_workspace::Ready;

/// The ways to look at a program.
pub struct Drawn {
    rungs: Rungs,
    listing: Listing,
    charts: Charts,
    view: View,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum View {
    Chart,
    Text,
    Ladder,
}

impl Drawn {
    /// Of this program. A chart is shown as one first, what was written as a text as that.
    pub fn new(program: &Ready) -> Drawn {
        let charts = Charts::new(program);
        Drawn {
            rungs: Rungs::new(program),
            listing: Listing::new(program),
            view: match program.is_text() {
                _ if charts.any() => View::Chart,
                true => View::Text,
                false => View::Ladder,
            },
            charts,
        }
    }

    /// Shows the next of them.
    pub fn turn(&mut self) {
        self.view = self.next();
    }

    fn next(&self) -> View {
        match self.view {
            View::Text => View::Ladder,
            View::Ladder if self.charts.any() => View::Chart,
            View::Ladder | View::Chart => View::Text,
        }
    }

    /// The line that is shown first, counted from 0: of a text the first that does something.
    pub fn home(&self) -> usize {
        match self.view {
            View::Text => self.listing.first(),
            View::Ladder | View::Chart => 0,
        }
    }

    /// What is shown, and which steps are active, where `read` gives what is at a point.
    pub fn title(&self, read: impl Fn(Address) -> Option<i32>) -> String {
        let what = match self.view {
            View::Text => messages::text(),
            View::Ladder => messages::rungs(),
            View::Chart => messages::chart(),
        };
        match self.charts.any() {
            true => format!("{what}: {}", self.charts.line(read)),
            false => what,
        }
    }

    /// What would be shown by [`Drawn::turn`], for the line of keys.
    pub fn other(&self) -> String {
        match self.next() {
            View::Ladder => "ladder".to_owned(),
            View::Text => messages::to_text(),
            View::Chart => messages::to_chart(),
        }
    }

    /// What a person points to in slow motion; none in a chart.
    pub fn among(&self) -> Option<Among> {
        match self.view {
            View::Text => Some(Among::Lines),
            View::Ladder => Some(Among::Rungs),
            View::Chart => None,
        }
    }

    /// What is shown as lines of text, of this width where that is enough, with what slow motion marks; and the line, counted
    /// from 0, that a person points to.
    pub fn lines(
        &self,
        flow: &Flow,
        slow: &Marked,
        width: usize,
        read: impl Fn(Address) -> Option<i32>,
    ) -> (Vec<Line<'static>>, Option<usize>) {
        match self.view {
            View::Text => {
                let row = slow.cursor.and_then(|step| self.listing.row(step));
                (self.listing.lines(flow, slow), row)
            }
            View::Ladder => self.rungs.lines(flow, slow, width),
            View::Chart => {
                let lines = self.charts.pictures(read).into_iter();
                (lines.map(Line::raw).collect(), None)
            }
        }
    }
}
