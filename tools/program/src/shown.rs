//! What a person is shown of texts that others wrote.
//!
//! Owns which characters may act on what shows them.

use std::path::Path;

/// A path as it is shown. A file may be called anything: what would begin a line, command a terminal or turn its words
/// round is written as Rust writes it, `\n`, `\u{1b}`.
pub fn shown(path: &Path) -> String {
    harmless(&path.display().to_string())
}

/// A text on one line, in which nothing acts on a terminal; see [`shown`].
pub fn harmless(text: &str) -> String {
    escaped(text, acts)
}

/// The same of a text whose lines and tabs stay.
pub fn harmless_lines(text: &str) -> String {
    escaped(text, |letter| {
        acts(letter) && !matches!(letter, '\n' | '\t')
    })
}

fn escaped(text: &str, acts: impl Fn(char) -> bool) -> String {
    let mut made = String::with_capacity(text.len());
    for letter in text.chars() {
        match acts(letter) {
            true => made.extend(letter.escape_default()),
            false => made.push(letter),
        }
    }
    made
}

/// Control characters, ends of lines, and marks that turn the direction of what follows (Unicode, UAX #9).
fn acts(letter: char) -> bool {
    letter.is_control()
        || matches!(letter, '\u{200E}' | '\u{200F}' | '\u{061C}' | '\u{2028}'..='\u{202E}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_in_a_name_acts() {
        for (name, is) in [
            ("Ligação – 1º.st", "Ligação – 1º.st"),
            ("a\nb.st", "a\\nb.st"),
            ("\u{1b}[2Ja\t.st", "\\u{1b}[2Ja\\t.st"),
            ("\u{202e}ts.exe", "\\u{202e}ts.exe"),
            ("a\u{85}b\u{2028}", "a\\u{85}b\\u{2028}"),
        ] {
            assert_eq!(shown(Path::new(name)), is);
        }
        assert_eq!(harmless_lines("a\tb\n\u{1b}c\r\n"), "a\tb\n\\u{1b}c\\r\n");
    }
}
