//! Instruction List: labels, operators, operands and comments in columns.

use super::gaps::joined;
use super::line::Line;
use crate::reader::Word;
use unoclp_lang::Colour;

/// Where operands begin in most texts.
const OPERAND: usize = 5;

/// Where they begin in most lines of this one.
fn operand(lines: &[Line<'_, '_>]) -> usize {
    let mut columns = [0; 10];
    for line in lines {
        let [operator, operand, ..] = line.words else {
            continue;
        };
        let is_operator = operator.colour == Some(Colour::Word);
        let column = (operand.span.start - operator.span.start) as usize;
        if is_operator && !matches!(operand.text, "(" | ":") && column > operator.text.len() {
            columns[column.min(9)] += 1;
        }
    }
    // Of two that are as many the greater one.
    let most = columns.iter().enumerate().max_by_key(|(_, count)| **count);
    most.map_or(OPERAND, |(column, count)| match count {
        0 => OPERAND,
        _ => column.max(3),
    })
}

/// The lines of a text, placed; a paragraph has its own column for comments.
pub(super) fn formed(lines: &[Line<'_, '_>], step: usize) -> Vec<String> {
    let mut declares = false;
    let column = operand(lines);
    let placed = |line| placed(line, &mut declares, step, column);
    let mut all: Vec<Placed> = lines.iter().map(placed).collect();
    let mut from = 0;
    while from < all.len() {
        let blank = all[from..]
            .iter()
            .position(|line| line.code.is_empty() && line.comment.is_empty());
        let to = blank.map_or(all.len(), |blank| from + blank);
        align(&mut all[from..to]);
        from = to + 1;
    }
    all.into_iter()
        .map(|line| line.code + &line.comment)
        .collect()
}

/// A line of instructions.
struct Placed {
    code: String,
    /// The comment after it; of a line that has nothing else the code is empty.
    comment: String,
    /// The column at which the comment stood.
    column: usize,
    /// Whether its comment stands with those of the paragraph.
    is_aligned: bool,
}

/// A line that stays as it is.
fn kept(text: &str) -> Placed {
    Placed {
        code: text.to_owned(),
        comment: String::new(),
        column: 0,
        is_aligned: false,
    }
}

fn placed(line: &Line<'_, '_>, declares: &mut bool, step: usize, column: usize) -> Placed {
    let own = line.text.trim();
    if line.is_within {
        return kept(line.text);
    }
    let Some(first) = line.words.first() else {
        let begins = if *declares && !own.is_empty() {
            step
        } else {
            0
        };
        return kept(&format!("{:begins$}{own}", ""));
    };
    let upper = first.text.to_ascii_uppercase();
    let is_word = first.colour == Some(Colour::Word);
    let is_section = is_word && (upper == "VAR" || upper.starts_with("VAR_"));
    let ends = is_word && upper == "END_VAR";
    let was = *declares;
    let is_whole = line
        .words
        .iter()
        .any(|word| word.text.eq_ignore_ascii_case("END_VAR"));
    *declares = (was || is_section) && !is_whole;
    if was || is_section {
        let begins = if was && !ends { step } else { 0 };
        let text = joined(line, |_, next, gap| match next.text {
            ";" | "," => 0,
            _ => gap.len(),
        });
        return kept(&format!("{:begins$}{text}", ""));
    }
    instruction(line, column)
}

fn instruction(line: &Line<'_, '_>, operand: usize) -> Placed {
    let words = line.words;
    let end = words
        .last()
        .map_or(0, |last| last.span.end as usize - line.start);
    let behind = line.text.get(end..).unwrap_or_default();
    let before = &line.text[..words[0].span.start as usize - line.start];
    // A comment before or between the words: nothing is moved.
    let gaps = words.windows(2).any(|pair| {
        let gap = pair[0].span.end as usize - line.start..pair[1].span.start as usize - line.start;
        !line.text.get(gap).unwrap_or_default().trim().is_empty()
    });
    if gaps || !before.trim().is_empty() {
        return kept(line.text.trim_end());
    }
    let (label, rest) = match words {
        [name, colon, rest @ ..] if colon.text == ":" && name.is_name() => {
            (format!("{}:", name.text), rest)
        }
        words => (String::new(), words),
    };
    let mut code = label;
    if let [operator, operands @ ..] = rest {
        let begins = code.len();
        if begins > 0 {
            code.push(' ');
        }
        code.push_str(operator.text);
        let mut last = *operator;
        // `AND(` and `AND(N` are operators as a whole.
        let is_at = match operands {
            [open, n, _, ..]
                if open.text == "(" && n.text == "N" && n.span.start == open.span.end =>
            {
                2
            }
            [open, ..] if open.text == "(" => 1,
            _ => 0,
        };
        for (at, word) in operands.iter().enumerate() {
            let gap = line
                .text
                .get(last.span.end as usize - line.start..word.span.start as usize - line.start);
            let blanks = blanks(last, *word, gap.unwrap_or_default());
            let is_first = at == is_at;
            let column = if begins == 0 && is_first { operand } else { 0 };
            let blanks = match is_first && word.text != ")" {
                true => column.saturating_sub(code.len()).max(1),
                false => blanks,
            };
            code.extend(std::iter::repeat_n(' ', blanks));
            code.push_str(word.text);
            last = *word;
        }
    }
    let column = line.text.chars().count() - behind.trim_start().chars().count();
    Placed {
        is_aligned: !behind.trim().is_empty(),
        comment: behind.trim().to_owned(),
        code,
        column,
    }
}

fn blanks(word: Word<'_>, next: Word<'_>, gap: &str) -> usize {
    match (word.text, next.text) {
        (_, "," | ";" | ")" | "]" | ".") | ("(" | "[" | ".", _) | (_, "[") => 0,
        (_, "(") => gap.len().min(1),
        (",", _) => 1,
        _ => gap.len().min(1),
    }
}

/// Puts the comments of a paragraph into one column: that of the first, or behind the longest line.
fn align(lines: &mut [Placed]) {
    let commented = || lines.iter().filter(|line| line.is_aligned);
    let Some(first) = commented().next() else {
        return;
    };
    let longest = commented().map(|line| line.code.chars().count()).max();
    let column = first.column.max(longest.unwrap_or(0) + 1);
    for line in lines.iter_mut().filter(|line| line.is_aligned) {
        let blanks = column - line.code.chars().count();
        line.code.extend(std::iter::repeat_n(' ', blanks));
    }
}
