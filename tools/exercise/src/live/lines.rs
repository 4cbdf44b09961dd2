//! The lines of a text of a running program, each with what a scan has made of it.

use super::stepped::Stepped;
use super::traced::Traced;
use super::{Flow, Mark};
use unoclp_program::Source;

/// The lines of a text, with what tells how each stands.
pub struct Lines {
    texts: Vec<String>,
    tellers: Tellers,
}

/// How a line is told.
enum Tellers {
    /// By what its statements test and store.
    Traced(Traced),
    /// By the steps that it has become.
    Stepped(Stepped),
}

impl Lines {
    /// The lines of the text of this program.
    pub fn new(program: &Source) -> Lines {
        let shown = |line: &str| {
            let line = line.replace('\t', "    ");
            line.chars().filter(|c| !c.is_control()).collect()
        };
        Lines {
            texts: program.text.lines().map(shown).collect(),
            tellers: match program.traces.is_empty() {
                true => Tellers::Stepped(Stepped::new(program)),
                false => Tellers::Traced(Traced::new(program)),
            },
        }
    }

    /// The first line of which there is something to tell, counted from 0.
    pub fn first(&self) -> usize {
        match &self.tellers {
            Tellers::Traced(traced) => traced.first(),
            Tellers::Stepped(stepped) => stepped.first(),
        }
    }

    /// The texts of the lines, without what cannot be printed.
    pub fn texts(&self) -> impl Iterator<Item = &str> {
        self.texts.iter().map(String::as_str)
    }

    /// What each line has come to.
    pub fn marks(&self, flow: &Flow) -> Vec<Mark> {
        let mark = |line| match &self.tellers {
            Tellers::Traced(traced) => traced.mark(line, flow),
            Tellers::Stepped(stepped) => stepped.mark(line, flow),
        };
        (1..=self.texts.len()).map(mark).collect()
    }
}
