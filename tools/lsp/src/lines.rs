//! Places of a text as the protocol counts them: lines from 0, and units of UTF-16 in a line.

use lsp_types::{Position, Range};
use unoclp_lang::{Lines, Span};

/// A text with its lines.
pub(crate) struct Places {
    text: String,
    lines: Lines,
}

impl Places {
    /// Of this text.
    pub fn new(text: String) -> Places {
        Places {
            lines: Lines::new(&text),
            text,
        }
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The byte at a place; one that a line does not have is its end.
    pub fn byte(&self, place: Position) -> u32 {
        let count = self.text.split('\n').count() as u32;
        if place.line >= count {
            return self.text.len() as u32;
        }
        let start = self.lines.start(place.line + 1);
        let rest = self.text.get(start as usize..).unwrap_or_default();
        let line = rest.split('\n').next().unwrap_or_default();
        let mut units = 0;
        for (at, character) in line.char_indices() {
            if units >= place.character {
                return start + at as u32;
            }
            units += character.len_utf16() as u32;
        }
        start + line.len() as u32
    }

    /// The place of a byte.
    pub fn position(&self, byte: u32) -> Position {
        let line = self.lines.line(byte);
        let start = self.lines.start(line);
        let before = self.text.get(start as usize..byte as usize);
        let units = before.unwrap_or_default().encode_utf16().count();
        Position::new(line.saturating_sub(1), units as u32)
    }

    /// The places of a span.
    pub fn range(&self, span: Span) -> Range {
        Range::new(self.position(span.start), self.position(span.end))
    }

    /// The span between two places.
    pub fn span(&self, range: Range) -> Span {
        let start = self.byte(range.start);
        Span {
            start,
            end: self.byte(range.end).max(start),
        }
    }
}
