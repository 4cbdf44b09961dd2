//! What a line of Instruction List looks like, right or wrong.

use unoclp_lang::is_operator;

/// Whether most lines are instructions of Instruction List.
pub(super) fn is_instructions(code: &str) -> bool {
    let (mut instructions, mut others, mut open) = (0_usize, 0_usize, 0_i64);
    for line in code.lines().map(str::trim) {
        let within = open > 0;
        let of = |sign: char| line.matches(sign).count() as i64;
        open = (open + of('(') - of(')')).max(0);
        let is_heading = ["NETWORK", "TITLE"].iter().any(|word| {
            let head = line.get(..word.len()).unwrap_or_default();
            head.eq_ignore_ascii_case(word)
        });
        if within || is_heading || !line.contains(char::is_alphabetic) {
            continue;
        }
        match is_instruction(line) {
            true => instructions += 1,
            false => others += 1,
        }
    }
    instructions > others
}

/// `LD I1`, `again: AND( x`, `5 OUT T0 K50`, `CAL t (IN := x)`: an operator with what it works on, if anything. A word
/// that is no operator may be one misspelt, before a point of the board.
pub(super) fn is_instruction(line: &str) -> bool {
    let line = line.trim_start_matches(|c: char| c.is_ascii_digit() || c.is_whitespace());
    let line = match line.split_once(':') {
        Some((label, rest)) if !rest.starts_with('=') && !label.contains(char::is_whitespace) => {
            rest
        }
        _ => line,
    };
    let line = line.trim().trim_end_matches(';');
    if let Some(point) = line.strip_prefix('=') {
        return is_point(&point.replace(' ', ""));
    }
    let end = line.find(|c: char| !c.is_alphanumeric() && c != '_');
    let (word, rest) = line.split_at(end.unwrap_or(line.len()));
    let rest = rest.trim();
    if word.is_empty() || rest.starts_with([':', '=', '.', '[']) {
        return false;
    }
    if is_operator(&word.to_uppercase()) {
        let takes = |operand: &str| {
            let more = operand.split_whitespace().skip(1);
            more.clone().count() < 3
                && more
                    .clone()
                    .all(|part| part.contains(|c: char| c.is_ascii_digit()))
        };
        // Of a call, what is called.
        if let Some((called, _)) = rest.split_once('(') {
            return called
                .chars()
                .all(|c| c.is_alphanumeric() || matches!(c, '_' | ' '))
                && called.split_whitespace().count() < 2;
        }
        return rest.split(',').all(takes);
    }
    is_point(rest)
}

/// `I1`, `%QX0.1`, `X0`
fn is_point(word: &str) -> bool {
    let word = word.strip_prefix('%').unwrap_or(word);
    let letters = word.bytes().take_while(u8::is_ascii_alphabetic).count();
    let number = &word[letters..];
    (1..=2).contains(&letters)
        && number.starts_with(|c: char| c.is_ascii_digit())
        && number
            .bytes()
            .all(|byte| byte.is_ascii_digit() || byte == b'.')
}
