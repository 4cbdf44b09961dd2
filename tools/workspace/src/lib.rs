//! Texts in versions, and what is known of each: found once, shared by all who ask.
//!
//! - [`Workspace`]: which text each version is
//! - [`Analysis`]: what is known of one; [`Ready`]: the same of one that is a program
//! - [`Compilers`]: what a text is opened with
//!
//! Owns versions, and that nothing of one is found twice. Must not know files, screens, nor what is shown of an analysis.

#![forbid(unsafe_code)]

mod analysis;
mod compilers;

pub use analysis::{Analysis, Ready};
pub use compilers::{All, Compilers};

use std::collections::VecDeque;
use std::rc::Rc;
use unoclp_core::Board;
use unoclp_draw::edit::{Emitted, Mistake};
use unoclp_program::Written;
use unoclp_program::drawn::{self, WriteAs};

/// A text that a [`Workspace`] knows: another text, name or board is another version.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Version(pub u32);

/// The texts that were asked for last, each with what is known of it.
pub struct Workspace {
    compilers: Rc<dyn Compilers>,
    /// The one that was asked for last is last.
    open: VecDeque<(Version, Rc<Analysis>)>,
    last: u32,
}

/// Texts that are kept: the one that is written, its drawing's, that of the board, and what they were before.
const MOST: usize = 8;

impl Workspace {
    /// One without a text, which opens texts so.
    pub fn new(compilers: Rc<dyn Compilers>) -> Workspace {
        Workspace {
            compilers,
            open: VecDeque::new(),
            last: 0,
        }
    }

    /// The version of a text: the one that it has, or a new one.
    pub fn set_text(&mut self, written: Written) -> Version {
        match self.place(&written) {
            Some(at) => self.touch(at).0,
            None => self.add(Rc::new(Analysis::new(written, self.compilers.clone()))),
        }
    }

    /// What is known of a text, which becomes a version, or is one.
    pub fn open(&mut self, written: Written) -> Rc<Analysis> {
        match self.place(&written) {
            Some(at) => self.touch(at).1,
            None => {
                let analysis = Rc::new(Analysis::new(written, self.compilers.clone()));
                self.add(analysis.clone());
                analysis
            }
        }
    }

    /// The version of the text of a drawing, which comes to its codes.
    ///
    /// # Errors
    /// All that is wrong in the drawing, where it is no program.
    pub fn set_drawing(
        &mut self,
        emitted: &Emitted<'_>,
        name: &str,
        form: WriteAs,
        board: Board,
    ) -> Result<Version, Vec<Mistake>> {
        let written = |text: &str| Written::new(name.to_owned(), text.into(), board);
        let text = drawn::text_of(emitted, form, board, |text| {
            let version = self.set_text(written(text));
            let analysis = self.analysis(version);
            let source = analysis.as_ref().and_then(|analysis| analysis.source());
            source.is_some_and(|source| drawn::says(source, emitted))
        })?;
        Ok(self.set_text(written(&text)))
    }

    /// What is known of a version; none where so many were set since that it is forgotten.
    pub fn analysis(&mut self, version: Version) -> Option<Rc<Analysis>> {
        let at = self.open.iter().position(|(own, _)| *own == version)?;
        Some(self.touch(at).1)
    }

    /// What is known of a text, which becomes no version by that.
    pub fn look(&self, written: Written) -> Rc<Analysis> {
        match self.place(&written) {
            Some(at) => self.open[at].1.clone(),
            None => Rc::new(Analysis::new(written, self.compilers.clone())),
        }
    }

    fn place(&self, written: &Written) -> Option<usize> {
        let is = |(_, own): &(Version, Rc<Analysis>)| own.written() == written;
        self.open.iter().position(is)
    }

    fn touch(&mut self, at: usize) -> (Version, Rc<Analysis>) {
        if let Some(open) = self.open.remove(at) {
            self.open.push_back(open);
        }
        // `at` was the place of one.
        let (version, analysis) = &self.open[self.open.len() - 1];
        (*version, analysis.clone())
    }

    fn add(&mut self, analysis: Rc<Analysis>) -> Version {
        if self.open.len() >= MOST {
            self.open.pop_front();
        }
        self.last = self.last.wrapping_add(1);
        let version = Version(self.last);
        self.open.push_back((version, analysis));
        version
    }
}

impl Default for Workspace {
    /// One with all compilers.
    fn default() -> Workspace {
        Workspace::new(Rc::new(All::default()))
    }
}
