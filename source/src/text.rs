//! From the bytes of a file to text.

use std::path::Path;

/// How the names of texts end.
const ENDS: [&str; 5] = ["il", "st", "scl", "iscl", "lce"];

/// Whether a file holds a text that is compiled: by its name, `.il`, `.st`, `.scl`, `.iscl`, `.lce`, or because more of its lines have
/// words than have numbers alone, comments of the numeric code left out.
pub fn is_text(path: &Path, file: &[u8]) -> bool {
    if path
        .extension()
        .is_some_and(|end| ENDS.iter().any(|known| end.eq_ignore_ascii_case(known)))
    {
        return true;
    }
    // UTF-16 is a fault of its own in numeric code (NC-3).
    if file.contains(&0) {
        return false;
    }
    let (mut words, mut numbers) = (0, 0);
    for line in decode(file).lines() {
        let line = line.split('/').next().unwrap_or_default().trim();
        words += usize::from(line.contains(char::is_alphabetic));
        numbers += usize::from(line.parse::<i64>().is_ok());
    }
    words > numbers
}

/// Whether a file holds numeric code, right or wrong: its first code is program start, and more of its lines are numbers
/// than words.
pub fn is_numeric(file: &[u8]) -> bool {
    let text = decode(file);
    let mut codes = text
        .lines()
        .map(|line| line.split('/').next().unwrap_or_default().trim());
    codes.find(|code| !code.is_empty()) == Some("0") && !is_text(Path::new(""), file)
}

/// The text of a file, without its byte-order mark: UTF-8; UTF-16, where the mark says so; else Latin-1.
pub fn decode(file: &[u8]) -> String {
    let wide = |unit: fn([u8; 2]) -> u16, bytes: &[u8]| {
        let units: Vec<u16> = bytes.as_chunks().0.iter().map(|&pair| unit(pair)).collect();
        String::from_utf16_lossy(&units)
    };
    match file {
        [0xFF, 0xFE, text @ ..] => wide(u16::from_le_bytes, text),
        [0xFE, 0xFF, text @ ..] => wide(u16::from_be_bytes, text),
        [0xEF, 0xBB, 0xBF, text @ ..] | text => match std::str::from_utf8(text) {
            Ok(text) => text.to_owned(),
            Err(_) => text.iter().copied().map(char::from).collect(),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_language_of_a_file_is_found() {
        let il = |name: &str, text: &str| is_text(Path::new(name), text.as_bytes());
        assert!(il("a.il", "0\n827301\n"));
        assert!(il("A.IL", ""));
        assert!(il("a.txt", "(* lamp *)\nLD I1\nST Q1\n"));
        assert!(il("a.txt", "// lamp\n0 LD I1\n1 ST Q1\n"));
        assert!(!il("a.txt", "0\n827301 / button\n877901 / lamp\n"));
        assert!(!il("a.txt", "/ all\n/ comments\n"));
        // A letter in place of a digit is a fault of numeric code.
        assert!(!il("a.txt", "O\n827301\n877901\n"));
        assert!(!il("a.txt", ""));
        assert!(!is_text(Path::new("a.txt"), b"\xFF\xFE0\0\n\0"));
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

    #[test]
    fn any_usual_encoding_is_read() {
        assert_eq!(decode("Início".as_bytes()), "Início");
        assert_eq!(decode(b"\xEF\xBB\xBFIn\xC3\xADcio"), "Início");
        assert_eq!(decode(b"In\xEDcio"), "Início");
        assert_eq!(decode(b"\xFF\xFEL\0D\0"), "LD");
        assert_eq!(decode(b"\xFE\xFF\0L\0D"), "LD");
    }
}
