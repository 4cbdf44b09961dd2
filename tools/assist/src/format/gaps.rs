//! What stands between two words: blanks, or a comment that stays as it is.

use super::line::Line;
use crate::reader::Word;
use unoclp_lang::Colour;

/// Whether a comment that begins in this gap goes on after it.
pub(super) fn is_open(gap: &str) -> bool {
    let mut rest = gap;
    loop {
        let block = rest.find("(*").map(|at| (at, "*)"));
        let slashed = rest.find("/*").map(|at| (at, "*/"));
        let braces = rest.find('{').map(|at| (at, "}"));
        let line = rest.find("//").map(|at| (at, "\n"));
        let first = [block, slashed, braces, line].into_iter().flatten().min();
        let Some((at, end)) = first else { return false };
        let after = &rest[at + 1..];
        match after.find(end) {
            Some(closed) => rest = &after[closed + end.len()..],
            None => return end != "\n",
        }
    }
}

/// A line without what stands before its first word, its words with blanks between them as `between` says of those up to
/// a gap, the next one, and the gap; what is not blank stays.
pub(super) fn joined<'t>(
    line: &Line<'_, 't>,
    between: impl Fn(&[Word<'t>], Word<'t>, &str) -> usize,
) -> String {
    let Some(first) = line.words.first() else {
        return line.text.trim().to_owned();
    };
    let place = |byte: u32| byte as usize - line.start;
    let mut all = line.text[..place(first.span.start)].trim_start().to_owned();
    for (at, word) in line.words.iter().enumerate() {
        all.push_str(word.text);
        let end = place(word.span.end);
        match line.words.get(at + 1) {
            Some(next) => {
                let gap = line
                    .text
                    .get(end..place(next.span.start))
                    .unwrap_or_default();
                match gap.trim().is_empty() {
                    true => all.extend(std::iter::repeat_n(
                        ' ',
                        between(&line.words[..=at], *next, gap),
                    )),
                    false => all.push_str(gap),
                }
            }
            None => all.push_str(line.text.get(end..).unwrap_or_default().trim_end()),
        }
    }
    all
}

/// Whether a sign has two operands: blanks stand on both of its sides.
pub(super) fn is_operator(sign: &str) -> bool {
    matches!(
        sign,
        ":=" | "=>"
            | "="
            | "<>"
            | "<"
            | "<="
            | ">"
            | ">="
            | "+"
            | "-"
            | "*"
            | "/"
            | "**"
            | "&"
            | "|"
            | "^"
    )
}

/// Whether a sign after this word has one operand.
pub(super) fn begins_operand(before: Word<'_>) -> bool {
    let is_keyword = before.colour == Some(Colour::Word);
    is_keyword && !matches!(before.text, "TRUE" | "FALSE")
        || is_operator(before.text)
        || matches!(before.text, "(" | "[" | "," | ":" | ".." | "!" | ";" | "{")
}
