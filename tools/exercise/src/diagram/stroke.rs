//! A course over time as lines and boxes.
//!
//! Owns the form of a single course. Must not know what it means.

use crate::scenario::Course;
use svg::node::element::{Group, Line, Path, Rectangle, Text, path::Data};
use unoclp_core::Millis;

/// From one course to the next.
pub(super) const ROW: f32 = 24.0;

/// Where a time stands on the page.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    /// The place of the beginning.
    pub left: f32,
    /// From there to the end.
    pub width: f32,
    /// The beginning.
    pub from: Millis,
    /// The end, 1 ms or more after it.
    pub until: Millis,
}

impl Scale {
    /// The place of a time.
    pub fn x(self, at: Millis) -> f32 {
        let at = at.min(self.until).saturating_sub(self.from);
        let span = self.until.saturating_sub(self.from).max(1);
        self.left + self.width * (at as f32 / span as f32)
    }
}

/// A course in a row from `y` on, up to a time: a bit as a line, a number as boxes that it stands in.
pub fn stroke(
    course: &Course,
    is_bit: bool,
    scale: Scale,
    y: f32,
    end: Millis,
    ink: &str,
) -> Group {
    let ends = course.iter().skip(1).map(|&(at, _)| at).chain([end]);
    let parts = course.iter().zip(ends).filter(|((from, _), to)| from <= to);
    let parts = parts.filter_map(|(&(from, value), to)| Some((scale.x(from), scale.x(to), value?)));
    let group = Group::new();
    match is_bit {
        true => group.add(bits(parts, y, ink)),
        false => parts.fold(group, |group, part| group.add(number(part, y, ink))),
    }
}

/// A bit from one place to another, one after the other; between them may be gaps.
fn bits(parts: impl Iterator<Item = (f32, f32, i32)>, y: f32, ink: &str) -> Path {
    let (low, high) = (y + ROW - 5.0, y + 5.0);
    let mut data = Data::new();
    let mut before = None;
    for (from, to, value) in parts {
        let height = if value == 0 { low } else { high };
        data = match before == Some(from) {
            true => data.line_to((from, height)),
            false => data.move_to((from, height)),
        };
        data = data.line_to((to, height));
        before = Some(to);
    }
    Path::new()
        .set("d", data)
        .set("fill", "none")
        .set("stroke", ink)
        .set("stroke-width", 1.8)
}

/// A number from one place to another, written out where there is room.
fn number((from, to, value): (f32, f32, i32), y: f32, ink: &str) -> Group {
    let text = value.to_string();
    let width = (to - from).max(1.0);
    let outline = Rectangle::new()
        .set("x", from)
        .set("y", y + 4.0)
        .set("width", width)
        .set("height", ROW - 8.0)
        .set("fill", "none")
        .set("stroke", ink);
    let group = Group::new().add(outline);
    match width > 8.0 * text.len() as f32 + 4.0 {
        true => group.add(
            label(from + 4.0, y + ROW - 8.0, &text, ink)
                .set("font-size", 12)
                .set("stroke", "none"),
        ),
        false => group,
    }
}

/// A straight line.
pub fn line(x1: f32, y1: f32, x2: f32, y2: f32, ink: &str) -> Line {
    Line::new()
        .set("x1", x1)
        .set("y1", y1)
        .set("x2", x2)
        .set("y2", y2)
        .set("stroke", ink)
}

/// A text that begins here.
pub fn label(x: f32, y: f32, text: &str, ink: &str) -> Text {
    Text::new(text).set("x", x).set("y", y).set("fill", ink)
}
