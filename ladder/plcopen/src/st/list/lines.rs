//! The instructions of a body in Instruction List, and where they stand in it.

use super::operators::binary;
use unoclp_lang::Span;

/// An instruction, a label, or `)`.
pub(super) struct Line<'t> {
    /// The operator, or the label.
    pub word: &'t str,
    pub at: Span,
    pub is_label: bool,
    /// A parenthesis follows the operator, and instructions up to `)`.
    pub opens: bool,
    pub operands: Vec<(&'t str, Span)>,
    /// What stands between the parentheses of a call.
    pub given: Option<(&'t str, Span)>,
}

/// A text in which blanks stand for its comments.
pub(super) fn without_comments(text: &str) -> String {
    let mut said = String::with_capacity(text.len());
    let mut rest = text;
    let ends = [("(*", "*)"), ("/*", "*/"), ("//", "\n")];
    while let Some((at, end)) = ends
        .iter()
        .filter_map(|(begin, end)| Some((rest.find(begin)?, *end)))
        .min()
    {
        let (before, comment) = rest.split_at(at);
        let inner = comment.get(2..).unwrap_or_default();
        let length = match (inner.find(end), end) {
            (Some(length), "\n") => 2 + length,
            (Some(length), _) => 4 + length,
            (None, _) => comment.len(),
        };
        let (comment, behind) = comment.split_at(length);
        said.push_str(before);
        said.extend(comment.bytes().map(|b| if b == b'\n' { '\n' } else { ' ' }));
        rest = behind;
    }
    said.push_str(rest);
    said
}

/// The instructions of a text without comments.
pub(super) fn lines(text: &str) -> Vec<Line<'_>> {
    let mut reader = Reader { text, at: 0 };
    std::iter::from_fn(|| reader.line()).collect()
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
}

impl<'t> Reader<'t> {
    fn rest(&self) -> &'t str {
        self.text.get(self.at..).unwrap_or_default()
    }

    /// Goes on over what this is true of, and gives it.
    fn over(&mut self, is: impl Fn(char) -> bool) -> &'t str {
        let rest = self.rest();
        let word = &rest[..rest.find(|c| !is(c)).unwrap_or(rest.len())];
        self.at += word.len();
        word
    }

    /// A piece of the text from here on, without blanks around it.
    fn piece(&self, piece: &'t str) -> (&'t str, Span) {
        let start = self.at + piece.len() - piece.trim_start().len();
        let piece = piece.trim();
        let span = Span {
            start: start as u32,
            end: (start + piece.len()) as u32,
        };
        (piece, span)
    }

    fn line(&mut self) -> Option<Line<'t>> {
        self.over(|c| c.is_whitespace() || c == ';');
        let rest = self.rest();
        let first = rest.chars().next()?;
        let is_name = |c: char| c.is_alphanumeric() || matches!(c, '_' | '&');
        let length = match is_name(first) {
            true => rest.find(|c| !is_name(c)).unwrap_or(rest.len()),
            false => first.len_utf8(),
        };
        let (word, at) = self.piece(&rest[..length]);
        self.at += length;
        let mut line = Line {
            word,
            at,
            is_label: false,
            opens: false,
            operands: Vec::new(),
            given: None,
        };
        if word == ")" {
            return Some(line);
        }
        let is_blank = |c: char| c.is_whitespace() && c != '\n';
        self.over(is_blank);
        if self.rest().starts_with(':') {
            self.at += 1;
            line.is_label = true;
            return Some(line);
        }
        let upper = word.to_uppercase();
        if matches!(&*upper, "CAL" | "CALC" | "CALCN") {
            let block = self.over(|c| !matches!(c, '(' | '\n'));
            self.at -= block.len();
            line.operands.extend(self.named(block));
            self.at += block.len();
            line.given = self.parentheses();
            return Some(line);
        }
        if self.rest().starts_with('(') {
            if binary(&upper).is_none() {
                line.given = self.parentheses();
                return Some(line);
            }
            line.opens = true;
            self.at += 1;
        }
        self.operands(&mut line);
        Some(line)
    }

    fn named(&self, piece: &'t str) -> Option<(&'t str, Span)> {
        let named = self.piece(piece);
        (!named.0.is_empty()).then_some(named)
    }

    /// What stands between parentheses, which begin here.
    fn parentheses(&mut self) -> Option<(&'t str, Span)> {
        let inner = self.rest().strip_prefix('(')?;
        let end = closing(inner).unwrap_or(inner.len());
        self.at += 1;
        let given = self.piece(&inner[..end]);
        self.at += (end + 1).min(inner.len());
        Some(given)
    }

    /// Operands up to the end of the line, or to the `)` of a parenthesis before it.
    fn operands(&mut self, line: &mut Line<'t>) {
        let rest = self.rest();
        let rest = &rest[..rest.find('\n').unwrap_or(rest.len())];
        let end = closing(rest).unwrap_or(rest.len());
        let mut deep = 0_u32;
        let split = rest[..end].split(move |c| {
            match c {
                '(' | '[' => deep += 1,
                ')' | ']' => deep = deep.saturating_sub(1),
                _ => {}
            }
            c == ',' && deep == 0
        });
        for operand in split {
            line.operands.extend(self.named(operand));
            self.at += operand.len() + 1;
        }
        self.at = (self.at - 1).min(self.text.len());
    }
}

/// The `)` that belongs to no `(` of a text.
fn closing(text: &str) -> Option<usize> {
    let mut deep = 0_u32;
    for (at, c) in text.char_indices() {
        match c {
            '(' => deep += 1,
            ')' if deep == 0 => return Some(at),
            ')' => deep -= 1,
            _ => {}
        }
    }
    None
}
