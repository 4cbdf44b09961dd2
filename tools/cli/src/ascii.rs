//! Replacements for characters where the locale has no UTF-8.

use std::env;
use unoclp_program::harmless_lines;

/// Whether the locale has no UTF-8. Windows has it always.
pub fn is_ascii() -> bool {
    let value = |name: &str| env::var(name).ok().filter(|value| !value.is_empty());
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"].into_iter().find_map(value);
    let locale = locale.unwrap_or_default().to_lowercase();
    cfg!(unix) && !(locale.contains("utf-8") || locale.contains("utf8"))
}

/// A picture as text, for those who read it by this locale: in ASCII where that has nothing else. Words of a program
/// are in it, in which nothing acts on a terminal.
pub fn picture(text: &str) -> String {
    let text = harmless_lines(text);
    match is_ascii() && !text.is_ascii() {
        true => text.chars().map(in_ascii).collect(),
        false => text,
    }
}

fn in_ascii(character: char) -> char {
    match character.is_ascii() {
        true => character,
        false => nearest(character),
    }
}

/// What comes nearest to a character.
pub(crate) fn nearest(character: char) -> char {
    match character {
        '●' | '•' => '*',
        '○' | '°' | 'º' => 'o',
        '█' => '#',
        '░' | '·' | '…' => '.',
        '─' | '–' => '-',
        '━' => '=',
        '│' | '┃' => '|',
        '├' | '┝' | '┣' | '┠' => '|',
        '┤' | '┥' | '┫' | '┨' => '|',
        '\u{2500}'..='\u{257F}' => '+',
        '↑' => '^',
        '↓' => 'v',
        '→' | '≥' => '>',
        '≤' => '<',
        '×' => 'x',
        'µ' | 'μ' => 'u',
        'á' | 'à' | 'â' | 'ã' => 'a',
        'é' | 'ê' => 'e',
        'í' => 'i',
        'ó' | 'ô' | 'õ' => 'o',
        'ú' | 'ü' => 'u',
        'ç' => 'c',
        'Á' | 'À' | 'Â' | 'Ã' => 'A',
        'É' | 'Ê' => 'E',
        'Í' => 'I',
        'Ó' | 'Ô' | 'Õ' => 'O',
        'Ú' => 'U',
        'Ç' => 'C',
        _ => '?',
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_keeps_its_shape() {
        let drawing = "├──┤ I1 ├──┬──( Q1 )──→a │ 214 µs €";
        let drawn: String = drawing.chars().map(in_ascii).collect();
        assert_eq!(drawn, "|--| I1 |--+--( Q1 )-->a | 214 us ?");
    }
}
