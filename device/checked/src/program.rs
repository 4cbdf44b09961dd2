//! A checked program together with the memory that it stands in.
//!
//! Owns that memory, and the one way into it: [`Loader`]. Must not know where a file comes from, nor what is
//! done with its program.

use crate::Work;
use self_cell::{MutBorrow, self_cell};
use std::fmt;
use unoclp_core::{Board, Fault, Loader, Program};

self_cell!(
    struct Owned {
        owner: MutBorrow<Vec<u8>>,
        #[covariant]
        dependent: Program,
    }
);

/// A [`Program`] that owns its memory, in which a [`Plc`](unoclp_core::Plc) can run it.
pub struct Checked(Owned);

impl Checked {
    /// The program of a file for this board. `feed` pushes the bytes of the file, and may see each fault as it
    /// comes; what it leaves out of [`Loader::end`] is done here.
    ///
    /// # Errors
    /// The first fault of the file.
    pub fn new(board: Board, feed: impl FnOnce(&mut Loader<'_>)) -> Result<Checked, Fault> {
        Work::note(|work| work.passes += 1);
        let memory = MutBorrow::new(vec![0; board.plc_bytes()]);
        let owned = Owned::try_new(memory, |memory| {
            let mut loader = Loader::new(memory.borrow_mut(), board);
            feed(&mut loader);
            loader.finish()
        });
        owned.map(Checked)
    }

    /// The program of a file in numeric code for this board, for what shows neither its text nor all of its faults.
    ///
    /// # Errors
    /// The first fault of the file.
    pub fn read(file: &[u8], board: Board) -> Result<Checked, Fault> {
        Checked::new(board, |loader| {
            // The loader itself keeps the fault.
            let _ = file.iter().try_for_each(|&byte| loader.push(byte));
        })
    }

    /// The same program in memory of its own, to run it there while this one is looked at: its stored form is read again.
    ///
    /// # Errors
    /// None that the program did not have before.
    pub fn copy(&self) -> Result<Checked, Fault> {
        let program = self.program();
        Checked::new(program.board(), |loader| {
            let _ = loader.restore(&mut program.stored().iter().copied());
        })
    }

    /// The program, to look at.
    pub fn program(&self) -> &Program<'_> {
        self.0.borrow_dependent()
    }

    /// The program and its memory, to run it there.
    pub fn lend(&mut self) -> Program<'_> {
        self.0.with_dependent_mut(|_, program| program.lend())
    }
}

impl fmt::Debug for Checked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.program().fmt(f)
    }
}
