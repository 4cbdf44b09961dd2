//! Which typed language a text is written in: by its file's name, or by its first words.
//!
//! Owns that one question. Must not know what the languages mean: `unoclp-lang` does.

use std::path::Path;

/// A language, by the name that `--language` has for it.
pub type LanguageName = &'static str;

/// The language of a file or a text: `st`, `scl`, `iscl`, `lce`, `il`, or `numeric`.
pub fn guess(path: Option<&Path>, text: &str) -> LanguageName {
    let end = path
        .and_then(Path::extension)
        .map(|end| end.to_ascii_lowercase());
    match end.as_ref().and_then(|end| end.to_str()) {
        Some("st") => return "st",
        Some("scl") => return "scl",
        Some("iscl") => return "iscl",
        Some("lce") => return "lce",
        Some("il") => return "il",
        _ => {}
    }
    match first_word(text).to_uppercase().as_str() {
        "BLOCO" | "BLOCK" => return "iscl",
        "CLP" | "PLC" => return "lce",
        "ORGANIZATION_BLOCK" => return "scl",
        _ => {}
    }
    if crate::is_numeric(text.as_bytes()) {
        return "numeric";
    }
    if text.lines().any(is_typed_store) {
        return "lce";
    }
    let structured = text.contains(":=") && text.contains(';') || has_word(text, "END_PROGRAM");
    match structured {
        true if has_local_names(text) => "scl",
        true => "st",
        false if text.lines().any(is_instruction) => "il",
        false => "st",
    }
}

/// The first word behind comments and blanks.
fn first_word(text: &str) -> &str {
    let mut rest = text.trim_start_matches('\u{FEFF}').trim_start();
    loop {
        let behind = if rest.starts_with("//") {
            rest.split_once('\n').map(|(_, behind)| behind)
        } else if rest.starts_with("(*") {
            rest.split_once("*)").map(|(_, behind)| behind)
        } else {
            break;
        };
        rest = behind.unwrap_or_default().trim_start();
    }
    let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
    &rest[..end.unwrap_or(rest.len())]
}

fn has_word(text: &str, word: &str) -> bool {
    text.lines()
        .any(|line| line.trim().trim_end_matches(';').eq_ignore_ascii_case(word))
}

/// Whether names begin with `#`, as SCL writes those of a block.
fn has_local_names(text: &str) -> bool {
    let bytes = text.as_bytes();
    let is_letter = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_alphabetic);
    let is_word = |at: Option<usize>| {
        at.and_then(|at| bytes.get(at))
            .is_some_and(|byte| byte.is_ascii_alphanumeric() || *byte == b'_')
    };
    text.match_indices('#')
        .any(|(at, _)| is_letter(at + 1) && !is_word(at.checked_sub(1)))
}

/// `V0 R:= 1.5`, as LCE alone writes it.
fn is_typed_store(line: &str) -> bool {
    let mut parts = line.split(":=");
    let before = parts.next().unwrap_or_default();
    let letter = before.chars().next_back();
    let name = match letter {
        Some('R' | 'D' | 'W' | 'B') => before.get(..before.len() - 1).unwrap_or_default(),
        _ => return false,
    };
    let last = name.split([' ', '\t', ';']).rfind(|word| !word.is_empty());
    let number = last.and_then(|word| word.strip_prefix('V'));
    let typed = name.ends_with([' ', '\t'])
        && number.is_some_and(|n| !n.is_empty() && n.bytes().all(|byte| byte.is_ascii_digit()));
    typed && parts.next().is_some()
}

/// `LD I1`
fn is_instruction(line: &str) -> bool {
    let operators = [
        "LD", "LDN", "LDI", "ST", "STN", "OUT", "A", "AN", "O", "ON", "CAL", "JMP",
    ];
    let mut words = line.split_whitespace();
    let first = words.next().unwrap_or_default().to_uppercase();
    operators.contains(&first.as_str()) && words.next().is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_language_is_told_by_name_or_by_words() {
        for (path, text, language) in [
            (Some("a.st"), "", "st"),
            (Some("A.SCL"), "", "scl"),
            (Some("a.txt"), "(* x *) bloco INT x; END_BLOCK", "iscl"),
            (None, "BLOCO\n", "iscl"),
            (Some("b.iscl"), "x := 1", "iscl"),
            (Some("a.lce"), "x := 1;", "lce"),
            (None, "plc gate end", "lce"),
            (None, "V0 R:= 100000.125;\nV1 := V0;", "lce"),
            (None, "VAR R : INT; END_VAR R:= 1;", "st"),
            (None, "// first\nclp teste\nfim", "lce"),
            (None, "PROGRAM main\nEND_PROGRAM", "st"),
            (None, "VAR x : INT; END_VAR x := 1;", "st"),
            (None, "#x := 1;", "scl"),
            (None, "x := INT#5;", "st"),
            (None, "LD I1\nST Q1", "il"),
            (None, "0\n827301\n877901\n", "numeric"),
            (None, "", "st"),
        ] {
            assert_eq!(guess(path.map(Path::new), text), language, "{text}");
        }
    }
}
