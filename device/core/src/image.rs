//! Points and the images that hold one bit for each.

use crate::ImageBits;

/// A point that exists: an input or output of the board, or a branch point of a rung.
///
/// Holds the index 0–98; people and programs count from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point(u8);

impl Point {
    /// The most points of one kind that a board may have: a code names them by two digits.
    pub const MOST: u8 = 99;

    /// The point with this number, counted from 1, where there are `count` of them.
    pub const fn new(number: u8, count: u8) -> Option<Point> {
        if number >= 1 && number <= count && number <= Self::MOST {
            Some(Point(number - 1))
        } else {
            None
        }
    }

    /// The index, 0–98.
    pub const fn index(self) -> u8 {
        self.0
    }

    /// The number as programs write it, 1–99.
    pub const fn number(self) -> u8 {
        self.0 + 1
    }
}

/// The state of as many points as a board may have, at one moment: bit 0 is point 01. The firmware's is of 16.
///
/// The program sees only images (NC-5): the input image is read before it runs, the output image
/// is written to the pins after it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Image(pub ImageBits);

impl Image {
    /// The state of a point.
    pub const fn get(self, point: Point) -> bool {
        self.0 & Self::mask(point) != 0
    }

    /// Sets a point to a state.
    pub const fn set(&mut self, point: Point, state: bool) {
        if state {
            self.0 |= Self::mask(point);
        } else {
            self.0 &= !Self::mask(point);
        }
    }

    const fn mask(point: Point) -> ImageBits {
        1 << (point.0 & (ImageBits::BITS as u8 - 1))
    }
}
