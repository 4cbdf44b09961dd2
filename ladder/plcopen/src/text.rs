//! A text that is made of pieces of a file, and the place of each of them in the file.

use crate::found::span;
use roxmltree::Node;
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use unoclp_checked::SourceMap;
use unoclp_lang::{Diagnostic, Lines, Span, Trace};

/// A text, and where its pieces are in the XML.
#[derive(Default)]
pub(crate) struct Text {
    pub text: String,
    /// The first byte of each piece, the first byte of what it came from, and whether both go on alike.
    pieces: Vec<(u32, Span, bool)>,
}

impl Text {
    /// The text of a body; where the file has it as it is, its bytes keep their places.
    pub(crate) fn body(&mut self, xml: &str, body: Node<'_, '_>) {
        for node in body.descendants().filter(Node::is_text) {
            let written = node.text().unwrap_or_default();
            let range = node.range();
            let raw = xml.get(range.clone()).unwrap_or_default();
            let own = raw.find(written).filter(|_| !written.is_empty());
            match own {
                Some(at) => {
                    let start = (range.start + at) as u32;
                    let end = start + written.len() as u32;
                    self.pieces
                        .push((self.text.len() as u32, Span { start, end }, true));
                    self.text.push_str(written);
                }
                None => self.piece(written, span(node)),
            }
        }
    }

    pub(crate) fn piece(&mut self, text: &str, from: Span) {
        self.pieces.push((self.text.len() as u32, from, false));
        self.text.push_str(text);
    }

    /// What stands in this part of the file, without its tags and comments. All keeps its place but the characters that
    /// XML has to spell, `&lt;`.
    pub(crate) fn copy(&mut self, xml: &str, range: Range<usize>) {
        let mut at = range.start;
        while let Some(rest) = xml.get(at..range.end).filter(|rest| !rest.is_empty()) {
            let after = |end: &str| rest.find(end).map_or(rest.len(), |at| at + end.len());
            if let Some(plain) = rest.strip_prefix(CDATA) {
                let length = plain.find("]]>").unwrap_or(plain.len());
                self.alike(xml, at + CDATA.len()..at + CDATA.len() + length);
                at += after("]]>");
            } else if rest.starts_with("<!--") {
                at += after("-->");
            } else if rest.starts_with('<') {
                at += after(">");
            } else if rest.starts_with('&') {
                let length = after(";");
                let span = Span {
                    start: at as u32,
                    end: (at + length) as u32,
                };
                self.piece(entity(&rest[..length]).unwrap_or(" "), span);
                at += length;
            } else {
                let length = rest.find(['<', '&']).unwrap_or(rest.len());
                self.alike(xml, at..at + length);
                at += length;
            }
        }
    }

    fn alike(&mut self, xml: &str, range: Range<usize>) {
        let span = Span {
            start: range.start as u32,
            end: range.end as u32,
        };
        self.pieces.push((self.text.len() as u32, span, true));
        self.text.push_str(xml.get(range).unwrap_or_default());
    }

    /// Spaces in the place of these parts of what begins there. All keeps its place.
    pub(crate) fn blank(&mut self, from: usize, parts: &[Range<usize>]) {
        for part in parts {
            let range = from + part.start..from + part.end;
            let own = self.text.get(range.clone()).unwrap_or_default();
            let blank: String = own
                .bytes()
                .map(|byte| if byte == b'\n' { '\n' } else { ' ' })
                .collect();
            if blank.len() == range.len() {
                self.text.replace_range(range, &blank);
            }
        }
    }

    /// What stands in the file as it does here: where there, and its first byte here.
    pub(crate) fn copied(&self) -> Vec<(Span, u32)> {
        let copied = self.pieces.iter().filter(|(_, _, is_alike)| *is_alike);
        copied.map(|(first, from, _)| (*from, *first)).collect()
    }

    /// A text after this one.
    pub(crate) fn add(&mut self, other: Text) {
        let before = self.text.len() as u32;
        let pieces = other.pieces.into_iter();
        self.pieces
            .extend(pieces.map(|(first, from, alike)| (before + first, from, alike)));
        self.text.push_str(&other.text);
    }

    /// Takes away the names of lists of variables before names of theirs: `GVL.start`. All keeps its place.
    pub(crate) fn unqualified(&mut self, lists: &HashMap<String, HashSet<String>>) {
        if lists.is_empty() {
            return;
        }
        let is_name = |c: char| c.is_alphanumeric() || c == '_';
        let last = |text: &str| text.len() - text.trim_end_matches(is_name).len();
        let mut plain = String::with_capacity(self.text.len());
        let mut parts = self.text.split_inclusive('.').peekable();
        while let Some(part) = parts.next() {
            let before = part.trim_end_matches('.');
            let (other, name) = before.split_at(before.len() - last(before));
            let is_part = other.is_empty() && plain.ends_with('.');
            let own = lists.get(&name.to_uppercase()).filter(|_| !is_part);
            let behind = parts.peek().copied().unwrap_or_default();
            let end = behind.find(|c| !is_name(c)).unwrap_or(behind.len());
            match own.is_some_and(|own| own.contains(&behind[..end].to_uppercase())) {
                true => plain.extend([other, &" ".repeat(part.len() - other.len())]),
                false => plain.push_str(part),
            }
        }
        self.text = plain;
    }

    /// Where a byte of the text is in the XML.
    pub(crate) fn place(&self, byte: u32) -> (u32, bool, Span) {
        let behind = self.pieces.partition_point(|(first, ..)| *first <= byte);
        let piece = behind.checked_sub(1).and_then(|at| self.pieces.get(at));
        match piece {
            Some((first, from, true)) => ((from.start + byte - first).min(from.end), true, *from),
            Some((_, from, false)) => (from.start, false, *from),
            None => (0, false, Span::default()),
        }
    }

    /// A diagnostic of the text as one of the XML.
    pub(crate) fn moved(&self, diagnostic: &Diagnostic) -> Diagnostic {
        diagnostic.at(self.span(diagnostic.span))
    }

    /// Where a part of the text stands in the XML.
    pub(crate) fn span(&self, own: Span) -> Span {
        let (start, is_alike, from) = self.place(own.start);
        match is_alike {
            true => Span {
                start,
                end: (start + own.end - own.start).min(from.end),
            },
            false => from,
        }
    }

    /// What of the XML has become this part of the text, piece by piece.
    pub(crate) fn spans(&self, own: Range<usize>) -> Vec<Span> {
        let begun = |byte: usize| {
            let byte = byte as u32;
            self.pieces.partition_point(|(first, ..)| *first <= byte)
        };
        let from = begun(own.start).saturating_sub(1);
        let to = begun(own.end.saturating_sub(1)).max(from);
        let pieces = self.pieces.get(from..to).unwrap_or_default();
        let spans = pieces.iter().map(|(first, from, is_alike)| {
            let before = (own.start as u32).saturating_sub(*first);
            let after = (own.end as u32).saturating_sub(*first);
            match is_alike {
                true => Span {
                    start: (from.start + before).min(from.end),
                    end: (from.start + after).min(from.end),
                },
                false => *from,
            }
        });
        spans.filter(|span| span.start < span.end).collect()
    }

    /// What the lines of the text show, as lines of the XML.
    pub(crate) fn traced(&self, xml: &str, mut traces: Vec<Trace>) -> Vec<Trace> {
        let (own, other) = (Lines::new(&self.text), Lines::new(xml));
        for trace in &mut traces {
            let (at, ..) = self.place(own.byte(&self.text, trace.line, trace.column));
            let (line, column) = other.place(xml, at);
            (trace.line, trace.column) = (line as usize, column as usize);
        }
        traces
    }

    /// The map of the text as one of the XML.
    pub(crate) fn placed(&self, xml: &str, mut map: SourceMap) -> SourceMap {
        let (own, other) = (Lines::new(&self.text), Lines::new(xml));
        for place in &mut map.steps {
            let (at, ..) = self.place(own.byte(&self.text, place.line, place.column));
            let (last, ..) = self.place(own.byte(&self.text, place.last, 1));
            let (line, column) = other.place(xml, at);
            let last = other.line(last).max(line);
            (place.line, place.column, place.last) =
                (line as usize, column as usize, last as usize);
        }
        map
    }
}

const CDATA: &str = "<![CDATA[";

/// What the form spells, where a program may say it: no name has any.
fn entity(spelled: &str) -> Option<&'static str> {
    Some(match spelled {
        "&lt;" => "<",
        "&gt;" => ">",
        "&amp;" => "&",
        "&quot;" => "\"",
        "&apos;" => "'",
        "&#10;" | "&#xA;" | "&#xa;" => "\n",
        _ => return None,
    })
}
