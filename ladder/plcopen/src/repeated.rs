//! Bodies in Structured Text that say again what their unit is: `PROGRAM Main VAR … END_VAR … END_PROGRAM`.
//!
//! Owns what of such a text is no statement. Must not know what a statement is.

use std::ops::Range;

/// What begins a unit, and what ends it.
const UNITS: [(&str, &str); 3] = [
    ("PROGRAM", "END_PROGRAM"),
    ("FUNCTION_BLOCK", "END_FUNCTION_BLOCK"),
    ("FUNCTION", "END_FUNCTION"),
];

/// The parts of a body that repeat the head and the end of its unit; its variables too where the unit `declares` them. None
/// where the body is statements alone.
pub(crate) fn repeated(body: &str, declares: bool) -> Vec<Range<usize>> {
    let words = words(body);
    let is = |at: usize, word: &str| {
        let own: Option<&Range<usize>> = words.get(at);
        own.is_some_and(|own| body[own.clone()].eq_ignore_ascii_case(word))
    };
    let unit = UNITS.iter().find(|(begin, _)| is(0, begin));
    let Some((_, end)) = unit.filter(|(_, end)| is(words.len().wrapping_sub(1), end)) else {
        return Vec::new();
    };
    // The name; of a function its type too, as far as that line goes.
    let (Some(head), Some(name)) = (words.first(), words.get(1)) else {
        return Vec::new();
    };
    let rest = &body[name.end..];
    let line = name.end + rest.find('\n').unwrap_or(rest.len());
    let begun = words
        .iter()
        .skip(2)
        .find(|word| is_section(&body[(*word).clone()]));
    let is_typed = rest.trim_start().starts_with(':');
    let mut until = if is_typed { line } else { name.end };
    until = until.min(begun.map_or(until, |word| word.start));
    let mut parts = vec![head.start..until];
    let mut at = words
        .iter()
        .position(|word| word.start >= until)
        .unwrap_or(words.len());
    while declares
        && words
            .get(at)
            .is_some_and(|word| is_section(&body[word.clone()]))
    {
        let Some(close) = (at..words.len()).find(|at| is(*at, "END_VAR")) else {
            break;
        };
        parts.push(words[at].start..words[close].end);
        at = close + 1;
    }
    parts.extend(words.last().map(|last| last.start..last.start + end.len()));
    parts
}

fn is_section(word: &str) -> bool {
    word.get(..3)
        .is_some_and(|begin| begin.eq_ignore_ascii_case("VAR"))
        && matches!(word.as_bytes().get(3), None | Some(b'_'))
}

/// The words of a text outside of its comments.
fn words(body: &str) -> Vec<Range<usize>> {
    let mut words = Vec::new();
    let mut rest = 0..body.len();
    while let Some(text) = body.get(rest.clone()).filter(|text| !text.is_empty()) {
        let is_part = |c: char| c.is_alphanumeric() || c == '_';
        let skipped = match text {
            _ if text.starts_with("(*") => text.find("*)").map_or(text.len(), |end| end + 2),
            _ if text.starts_with("//") => text.find('\n').unwrap_or(text.len()),
            _ if text.starts_with(is_part) => {
                let length = text.find(|c| !is_part(c)).unwrap_or(text.len());
                words.push(rest.start..rest.start + length);
                length
            }
            _ => text.chars().next().map_or(1, char::len_utf8),
        };
        rest.start += skipped;
    }
    words
}
