//! How a ladder is drawn: in how many columns, with which names, for what.

use crate::Names;

/// The narrowest drawing: the longest box between the rails, with room to go on after it.
pub const NARROWEST: usize = 56;

/// The narrowest on a screen, where what is wider can be scrolled: four contacts and a coil.
const NARROWEST_SCREEN: usize = 44;

/// How a ladder is drawn.
pub struct Style<'s> {
    /// The columns that a drawing may take, rails included; at least [`NARROWEST`].
    pub width: usize,
    /// What points are called.
    pub names: &'s Names,
    /// What it is drawn for.
    pub medium: Medium<'s>,
}

/// What a ladder is drawn for.
#[derive(Clone, Copy)]
pub enum Medium<'s> {
    /// As text. It says what the box of a step shows in place of its usual text, if not that.
    Text(&'s dyn Fn(usize) -> Option<String>),
    /// As a picture, whose timers and counters have pins.
    Paper,
    /// As a picture that takes all of its columns, and has room for what timers and counters have come to.
    Screen,
}

impl Medium<'_> {
    /// As text, whose boxes are as always.
    pub const PLAIN: Medium<'static> = Medium::Text(&|_| None);
}

impl Style<'_> {
    /// The columns that a drawing may take.
    pub(crate) fn limit(&self) -> usize {
        self.width.max(match self.medium {
            Medium::Screen => NARROWEST_SCREEN,
            Medium::Text(_) | Medium::Paper => NARROWEST,
        })
    }

    /// The columns between the rails of a drawing whose rungs take so many: even a small program has room between its
    /// contacts and coils.
    pub(crate) fn between_rails(&self, widths: impl Iterator<Item = usize>) -> usize {
        let least = match self.medium {
            Medium::Screen => self.limit(),
            Medium::Text(_) | Medium::Paper => NARROWEST,
        };
        widths.max().unwrap_or(0).max(least - 2)
    }
}
