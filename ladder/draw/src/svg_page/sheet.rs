//! A rung for a screen on which it is edited: as for one that shows it live, and where everything is.
//!
//! Beside what `screen` names, a symbol and a rung have a `data-id`. What changes with the rungs before it is left to who puts
//! it in its place.

use super::GAP;
use super::area::Area;
use super::blocks::Diagram;
use super::screen::{self, Strip, TOP};
use crate::drawing::Laid;
use crate::{Ladder, Look, Rung, Style};

/// A rung, and where everything on it is, from its upper left corner.
#[derive(Clone, Debug)]
pub(crate) struct OnSheet {
    /// A group of SVG.
    pub(crate) svg: String,
    /// All of it.
    pub(crate) area: Area,
    /// Its elements, by their place among all of the ladder, in the order in which they are drawn.
    pub(crate) elements: Vec<(usize, Area)>,
}

/// A rung that is laid out, and not yet drawn.
pub(crate) enum Shape<'l> {
    Ladder(Laid),
    Blocks(Diagram<'l>),
}

impl<'l> Shape<'l> {
    pub(crate) fn new(ladder: &'l Ladder, rung: &Rung, look: Look, style: &Style<'_>) -> Shape<'l> {
        match look {
            Look::Ladder => Shape::Ladder(Laid::new(ladder, rung, style)),
            Look::Blocks => Shape::Blocks(Diagram::new(ladder, rung, style)),
        }
    }

    /// The columns that it takes between the rails.
    pub(crate) fn columns(&self) -> usize {
        match self {
            Shape::Ladder(laid) => laid.width,
            Shape::Blocks(diagram) => diagram.columns(),
        }
    }
}

/// What is known of a rung that is edited.
pub(crate) struct Labels<'l> {
    /// What the elements of the ladder are known by.
    pub(crate) elements: &'l dyn Fn(usize) -> u32,
    /// What the rung is known by.
    pub(crate) rung: u32,
    /// What stands above it, line by line.
    pub(crate) heading: &'l [String],
}

impl OnSheet {
    /// A rung in so many columns between the rails.
    pub(crate) fn new(
        ladder: &Ladder,
        rung: &Rung,
        shape: Shape<'_>,
        between: usize,
        labels: &Labels<'_>,
    ) -> OnSheet {
        let columns = between + 2;
        let (heading, ids) = (labels.heading, Some(labels.elements));
        let strip = match shape {
            Shape::Ladder(laid) => {
                let picture = laid.picture(rung, between);
                Strip::new((ladder, rung, columns), heading, &picture, ids)
            }
            Shape::Blocks(diagram) => Strip::of_blocks((ladder, rung), heading, &diagram, ids),
        };
        OnSheet {
            svg: strip.group.set("data-id", labels.rung).written(),
            area: Area {
                x: 0.0,
                y: 0.0,
                width: screen::size(columns, 0.0).0,
                height: strip.height,
            },
            elements: strip.areas,
        }
    }
}

/// The upper edges of rungs of these heights, and the size of the sheet on which they stand, in so many columns between the
/// rails.
pub(crate) fn tops(heights: impl Iterator<Item = f32>, between: usize) -> (Vec<f32>, (f32, f32)) {
    let mut next = TOP;
    let tops = heights.map(|height| {
        let top = next;
        next += height + GAP;
        top
    });
    let tops: Vec<f32> = tops.collect();
    let end = if tops.is_empty() { next } else { next - GAP };
    (tops, screen::size(between + 2, end))
}
