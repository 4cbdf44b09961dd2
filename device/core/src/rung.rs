//! Whether a rung is balanced (NC-8, NC-22).
//!
//! Owns open branches, stored branch points and pushed values while a program loads; knows nothing of bytes.

use crate::isa::DEEPEST;
use crate::{Cause, Image, Point};

/// The rung that is being loaded.
pub(crate) struct Rung {
    /// The low halves of the lines of the open branches, as many as `depth` says. The high half is that of
    /// the rung's end: no rung goes over 65,536 lines, or its lines are told so much too high.
    open: [u16; DEEPEST as usize],
    depth: u8,
    /// How many values are pushed.
    pushed: u8,
    /// The branch points that this rung has stored.
    stored: Image,
}

impl Rung {
    pub(crate) const fn new() -> Rung {
        Rung {
            open: [0; DEEPEST as usize],
            depth: 0,
            pushed: 0,
            stored: Image(0),
        }
    }

    /// `40`, `6540` or `8840` on this line.
    pub(crate) fn open(&mut self, line: u32) -> Result<(), Cause> {
        let place = self.open.get_mut(usize::from(self.depth));
        // Counted also where it is too deep, so that its 41 is not one too many.
        self.depth = self.depth.wrapping_add(1);
        *place.ok_or(Cause::NestedTooDeep)? = line as u16;
        Ok(())
    }

    /// `41`.
    pub(crate) fn close(&mut self) -> Result<(), Cause> {
        self.depth = self.depth.checked_sub(1).ok_or(Cause::CloseWithoutOpen)?;
        Ok(())
    }

    /// Whether a branch is open or a value pushed.
    pub(crate) fn is_open(&self) -> bool {
        self.depth | self.pushed > 0
    }

    /// A value is pushed.
    pub(crate) fn push(&mut self) -> Result<(), Cause> {
        // Counted also where it is too deep, so that what takes it does not take one too many.
        self.pushed = self.pushed.wrapping_add(1);
        if self.pushed > DEEPEST {
            Err(Cause::PushedTooDeep)
        } else {
            Ok(())
        }
    }

    /// The value that was pushed last is taken.
    pub(crate) fn pop(&mut self) -> Result<(), Cause> {
        self.pushed = self.pushed.checked_sub(1).ok_or(Cause::NothingPushed)?;
        Ok(())
    }

    /// `4041XX` that stores.
    pub(crate) fn store(&mut self, point: Point) {
        self.stored.set(point, true);
    }

    /// `4041XX` that recalls.
    pub(crate) fn recall(&self, point: Point) -> Result<(), Cause> {
        if self.stored.get(point) {
            Ok(())
        } else {
            Err(Cause::RecallBeforeStore)
        }
    }

    /// The end of the rung.
    pub(crate) fn end(&mut self) -> Result<(), Cause> {
        self.stored = Image(0);
        let pushed = core::mem::take(&mut self.pushed);
        let depth = usize::from(core::mem::take(&mut self.depth));
        match self.open.get(depth.wrapping_sub(1)) {
            None if pushed > 0 => Err(Cause::ValueLeftPushed),
            None => Ok(()),
            Some(&line) => {
                // The rung has no more use for the place: it is kept for `left_open`.
                self.open[0] = line;
                Err(Cause::BranchLeftOpen)
            }
        }
    }

    /// The low half of the line of the innermost branch that the last faulty rung has left open.
    pub(crate) fn left_open(&self) -> u16 {
        self.open[0]
    }
}
