//! Which language a file is written in: by its name, or by its first words.
//!
//! Owns that one question, for every command. Must not know what the languages mean: `unoclp-lang` does. It takes a
//! time in proportion to the file.

use crate::decode;
use crate::first::{ST, first_words, is_list};
use crate::written_in::WrittenIn;
use std::path::Path;

/// Why a file holds no program in any language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoProgram {
    /// It holds nothing.
    Empty,
    /// It holds no text.
    Binary,
    /// Its words are those of none of the languages.
    Other,
}

impl WrittenIn {
    /// The language of a file: by its name, or because its first words are those of a language.
    ///
    /// # Errors
    /// Why it is no program in any.
    pub fn of(path: &Path, file: &[u8]) -> Result<WrittenIn, NoProgram> {
        let wide = file.starts_with(b"\xFF\xFE") || file.starts_with(b"\xFE\xFF");
        if file.contains(&0) && !wide {
            return Err(NoProgram::Binary);
        }
        let named = WrittenIn::of_name(path);
        if let Some(language) = named.filter(|language| *language != ST) {
            return Ok(language);
        }
        let text = decode(file);
        if named.is_some() {
            // Some editors give the texts of all languages the same name.
            let language = if is_list(&text) { WrittenIn::Il } else { ST };
            return Ok(language);
        }
        if text.trim().is_empty() {
            return Err(NoProgram::Empty);
        }
        if unoclp_plcopen::is_project(&text) {
            return Ok(WrittenIn::Xml);
        }
        if is_numbers(&text) {
            return Ok(WrittenIn::Numeric);
        }
        first_words(&text).ok_or(NoProgram::Other)
    }
}

/// Whether a file holds numeric code, right or wrong: its first code is program start, and more of its lines are numbers
/// than words.
pub fn is_numeric(file: &[u8]) -> bool {
    let text = decode(file);
    let mut codes = text.lines().map(code);
    codes.find(|code| !code.is_empty()) == Some("0") && is_numbers(&text)
}

/// Whether at least as many lines are numbers as have words, comments of numeric code left out; all may be comments.
fn is_numbers(text: &str) -> bool {
    let (mut words, mut numbers, mut others) = (0, 0, 0);
    for line in text.lines().map(code) {
        let is_number = line.parse::<i64>().is_ok();
        numbers += usize::from(is_number);
        words += usize::from(line.contains(char::is_alphabetic));
        others += usize::from(!is_number && !line.is_empty());
    }
    // A text that begins with `//` has no word before a `/` for some lines; one of nothing else may be either.
    numbers >= words && (numbers > 0 || others == 0)
}

/// What stands before the comment of numeric code.
fn code(line: &str) -> &str {
    line.split('/').next().unwrap_or_default().trim()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(path: &str, text: &[u8]) -> Result<&'static str, NoProgram> {
        WrittenIn::of(Path::new(path), text).map(WrittenIn::name)
    }

    #[test]
    fn a_name_tells_the_language_whatever_the_words() {
        for (path, language) in [
            ("a.st", "st"),
            ("A.SCL", "scl"),
            ("b.iscl", "iscl"),
            ("a.lce", "lce"),
            ("A.IL", "il"),
            ("plc.xml", "xml"),
        ] {
            assert_eq!(name(path, b"0\n827301\n"), Ok(language), "{path}");
        }
        assert_eq!(name("a.numeric", b"LD I1\n"), Ok("il"));
    }

    #[test]
    fn a_list_may_have_the_name_of_structured_text() {
        let list = b"PROGRAM p\nVAR a, b : BOOL; END_VAR\n(* x := 1; *)\n  LD a (* x *)\n  ST b\nEND_PROGRAM\n";
        assert_eq!(name("plc.st", list), Ok("il"));
        assert_eq!(name("plc.scl", list), Ok("scl"));
        for text in [
            "",
            "R",
            "PROGRAM p\nVAR s : BOOL; END_VAR\nS\nEND_PROGRAM\n",
            "VAR a : BOOL; END_VAR\nLD a;\nST a;\n",
            "VAR a, b : BOOL; END_VAR\na := b;\nLD b\nST a\n",
        ] {
            assert_eq!(name("plc.st", text.as_bytes()), Ok("st"), "{text}");
        }
    }

    #[test]
    fn numeric_code_is_told_from_texts() {
        for text in [
            &b"0\n827301 / button\n877901 / lamp\n"[..],
            b"/ all\n/ comments\n",
            // A letter in place of a digit is a fault of numeric code, and so is UTF-16 (NC-3).
            b"O\n827301\n877901\n",
            b"\xFF\xFE0\0\n\0",
        ] {
            assert_eq!(name("a.txt", text), Ok("numeric"), "{text:?}");
        }
        assert_eq!(name("a.txt", b"// lamp\n0 LD I1\n1 ST Q1\n"), Ok("il"));
        let project =
            b"<?xml version='1.0'?>\n<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"/>";
        assert_eq!(name("a.txt", project), Ok("xml"));
        assert_eq!(name("a.txt", b"\xFF\xFEL\0D\0 \0I\x001\0"), Ok("il"));
    }

    #[test]
    fn what_is_no_program_is_told_by_what_it_is() {
        for (path, text, why) in [
            ("a.txt", &b""[..], NoProgram::Empty),
            ("a.txt", b" \r\n\t\n", NoProgram::Empty),
            ("a.txt", b"\xEF\xBB\xBF", NoProgram::Empty),
            ("a.img", b"\x89PNG\0\0", NoProgram::Binary),
            ("a.st", b"x := 1;\0", NoProgram::Binary),
            ("a.md", b"# Read me\n\nA lamp is on.\n", NoProgram::Other),
            ("a.csv", b"1;2\n3;4\n", NoProgram::Other),
        ] {
            assert_eq!(name(path, text), Err(why), "{text:?}");
        }
    }

    #[test]
    fn numeric_code_begins_with_program_start() {
        assert!(is_numeric(b"/ lamp\r\n\r\n 0 / start\r\n827301\r\n877901"));
        assert!(is_numeric(b"0\n8273O1\n877901\n"), "with a fault");
        for other in [
            "",
            "/ notes\n",
            "1\n2\n",
            "0\nLD I1\nST Q1\n",
            "about = \"\"\n",
            "# Read me\n",
        ] {
            assert!(!is_numeric(other.as_bytes()), "{other}");
        }
    }
}
