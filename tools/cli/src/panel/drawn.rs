//! A running program as a person looks at it: its ladder diagram, or the text that it comes from.

use super::ladder::Rungs;
use super::listing::Listing;
use crate::messages;
use ratatui::text::Line;
use unoclp_exercise::live::Flow;
use unoclp_program::Source;

/// Both ways to look at a program.
pub struct Drawn {
    rungs: Rungs,
    listing: Listing,
    as_text: bool,
}

impl Drawn {
    /// Of this program. What was written as Instruction List is shown so first.
    pub fn new(program: &Source) -> Drawn {
        Drawn {
            rungs: Rungs::new(program),
            listing: Listing::new(program),
            as_text: program.is_text(),
        }
    }

    /// Shows the other of the two.
    pub fn turn(&mut self) {
        self.as_text = !self.as_text;
    }

    /// The line that is shown first, counted from 0: of a text the first that does something.
    pub fn home(&self) -> usize {
        if self.as_text {
            self.listing.first()
        } else {
            0
        }
    }

    /// What is shown.
    pub fn title(&self) -> String {
        match self.as_text {
            true => messages::text(),
            false => messages::rungs(),
        }
    }

    /// What would be shown by [`Drawn::turn`], for the line of keys.
    pub fn other(&self) -> String {
        match self.as_text {
            true => "ladder".to_owned(),
            false => messages::to_text(),
        }
    }

    /// What is shown as lines of text, of this width where that is enough.
    pub fn lines(&self, flow: &Flow, width: usize) -> Vec<Line<'static>> {
        match self.as_text {
            true => self.listing.lines(flow),
            false => self.rungs.lines(flow, width),
        }
    }
}
