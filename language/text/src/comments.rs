//! The comments of a text that are on lines of their own, for a program that shows what it compiles to.
//!
//! Owns which line says what; must not know where a comment begins or ends: the lexer says so.

use crate::diagnostics::{Lines, Span};
use std::collections::HashMap;

/// The lines of a text, as far as they hold comments or more.
pub struct Comments(Vec<Line>);

#[derive(Clone, Default)]
struct Line {
    /// Whether it holds more than comments.
    code: bool,
    /// What its comments say.
    words: String,
}

impl Comments {
    /// Of a text with its comments in these places.
    pub fn new(text: &str, places: &Lines, spans: &[Span]) -> Comments {
        let mut lines = vec![Line::default(); text.lines().count() + 1];
        let mut put = |start: usize, text: &str, with: fn(&mut Line, &str)| {
            let first = places.line(start as u32) as usize - 1;
            let lines = lines.iter_mut().skip(first);
            lines
                .zip(text.split('\n'))
                .for_each(|(line, part)| with(line, part));
        };
        let mut behind = 0;
        let end = text.len()..text.len();
        for span in spans.iter().map(|span| span.range()).chain([end]) {
            let between = text.get(behind..span.start).unwrap_or_default();
            put(behind, between, |line, part| {
                line.code |= !part.trim().is_empty();
            });
            let comment = text.get(span.clone()).unwrap_or_default();
            put(span.start, words(comment), |line, part| {
                line.words.push_str(part);
            });
            behind = span.end;
        }
        Comments(lines)
    }

    /// Those before all else.
    pub fn title(&self) -> Vec<String> {
        let lines = self.0.iter().take_while(|line| !line.code);
        lines.filter_map(|line| some(&line.words)).collect()
    }

    /// Those right above this line, after the title. Each is given once only.
    pub fn take_above(&mut self, line: usize) -> Vec<String> {
        let before = self.0.get_mut(..line.saturating_sub(1)).unwrap_or_default();
        let Some(code) = before.iter().rposition(|line| line.code) else {
            return Vec::new();
        };
        let between = before.get_mut(code + 1..).unwrap_or_default().iter_mut();
        between
            .filter_map(|line| some(&std::mem::take(&mut line.words)))
            .collect()
    }
}

/// Where the comments of a text in a typed language are: `(* *)`, `/* */`, `//`, none of them in a literal of its line.
pub fn of_any(text: &str) -> Vec<Span> {
    let bytes = text.as_bytes();
    let nested = nested(bytes);
    let mut spans = Vec::new();
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        let rest = &bytes[at..];
        let find = |end: &[u8]| {
            let behind = rest.windows(end.len()).skip(2);
            let found = behind.zip(2..).find(|(window, _)| *window == end);
            found.map_or(bytes.len(), |(_, length)| at + length + end.len())
        };
        let line_end = || at + rest.iter().position(|&b| b == b'\n').unwrap_or(rest.len());
        let end = match (byte, rest.get(1)) {
            (b'(', Some(b'*')) => nested.get(&at).copied().unwrap_or_else(|| find(b"*)")),
            (b'/', Some(b'*')) => find(b"*/"),
            (b'/', Some(b'/')) => line_end(),
            (b'\'' | b'"', _) => {
                let own = rest.iter().take(line_end() - at).skip(1);
                at += own
                    .zip(2..)
                    .find(|(b, _)| **b == byte)
                    .map_or(1, |(_, length)| length);
                continue;
            }
            _ => {
                at += 1;
                continue;
            }
        };
        spans.push(Span {
            start: at as u32,
            end: end as u32,
        });
        at = end;
    }
    spans
}

/// Where comments that hold whole comments begin and end. A `(*` within a comment that has no end of its own
/// is a part of what the comment says.
pub fn nested(bytes: &[u8]) -> HashMap<usize, usize> {
    let mut ends = HashMap::new();
    // Those that are open, and whether they hold another.
    let mut open: Vec<(usize, bool)> = Vec::new();
    let mut at = 0;
    while let Some(pair) = bytes.get(at..at + 2) {
        match pair {
            b"(*" => open.push((at, false)),
            b"*)" => {
                if let Some((start, true)) = open.pop() {
                    ends.insert(start, at + 2);
                }
                open.iter_mut()
                    .rev()
                    .take(1)
                    .for_each(|outer| outer.1 = true);
            }
            _ => {
                at += 1;
                continue;
            }
        }
        at += 2;
    }
    ends
}

/// What a comment says, without what begins and ends it.
pub fn words(comment: &str) -> &str {
    if let Some(words) = comment.strip_prefix("//").or(comment.strip_prefix(';')) {
        return words;
    }
    let words = comment.strip_prefix("(*").or(comment.strip_prefix("/*"));
    let words = words.unwrap_or(comment);
    let words = words
        .strip_suffix([')', '/'])
        .unwrap_or(words)
        .trim_end_matches([' ', '\t']);
    words.strip_suffix('*').unwrap_or(words)
}

fn some(words: &str) -> Option<String> {
    let words = words.trim();
    (!words.is_empty()).then(|| words.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_of_typed_languages_are_found() {
        let text = "a (* b (* c *) *) d // e 'f\n'g (* h' /* i\n */ \"//\" 'j // k\nl (* m";
        let found: Vec<&str> = of_any(text)
            .iter()
            .filter_map(|span| text.get(span.range()))
            .collect();
        assert_eq!(
            found,
            ["(* b (* c *) *)", "// e 'f", "/* i\n */", "// k", "(* m"]
        );
        assert_eq!([words("/* i */"), words("(* i *)")], [" i "; 2]);
    }
}
