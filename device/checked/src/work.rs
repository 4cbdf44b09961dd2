//! How often this thread has done what takes long, so that a test can tell that nothing is done twice.
//!
//! Owns the counts. Must not know why anything is done.

use std::cell::Cell;

/// How often each was done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// A text was compiled.
    pub compiles: u64,
    /// A program went through the loader.
    pub passes: u64,
    /// A ladder document was made codes.
    pub emissions: u64,
    /// A ladder was laid out.
    pub drawings: u64,
    /// A rung of one was laid out.
    pub rungs: u64,
}

thread_local! {
    static DONE: Cell<Work> = const { Cell::new(Work { compiles: 0, passes: 0, emissions: 0, drawings: 0, rungs: 0 }) };
}

impl Work {
    /// What this thread has done since it began.
    pub fn done() -> Work {
        DONE.get()
    }

    /// What it has done since then.
    pub fn since(before: Work) -> Work {
        let now = Work::done();
        Work {
            compiles: now.compiles - before.compiles,
            passes: now.passes - before.passes,
            emissions: now.emissions - before.emissions,
            drawings: now.drawings - before.drawings,
            rungs: now.rungs - before.rungs,
        }
    }

    /// Notes that something is done.
    pub fn note(note: impl FnOnce(&mut Work)) {
        let mut work = DONE.get();
        note(&mut work);
        DONE.set(work);
    }
}
