//! The seal of a program file: a comment in its last line, with the length and the checksum of all before it.
//!
//! ```text
//! 0         / program start [unoclp: length and check sum in the last line]
//! …
//! / unoclp: 4711 bytes, check sum 1A2B
//! ```
//!
//! The first line says that there is a last one, so that a file is known whose end is missing. Owns both forms. Must not
//! know files, nor what is done with one whose seal does not hold. To a board both are comments.

use crate::{Lang, words};
use unoclp_core::Crc16;

/// In the first line.
const PROMISE: &str = "[unoclp: length and check sum in the last line]";
/// Begins the last line.
const SEAL: &str = "/ unoclp: ";
/// The first line of what `compile` wrote before there were seals.
const EARLIER: &str = "0         / program start";

/// What the seal of a program file says of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seal {
    /// It never had one.
    None,
    /// The file is as it was written.
    Holds,
    /// The file has been changed since.
    Changed,
    /// The end of the file is missing, and the seal with it.
    Cut,
}

impl Seal {
    /// That of this file. The ends of its lines may have become others.
    pub fn of(file: &[u8]) -> Seal {
        let (body, seal) = split(file);
        match seal {
            Some(seal) if seal == sum(body) => Seal::Holds,
            Some(_) => Seal::Changed,
            None if lines(file).any(|line| line.starts_with(SEAL.as_bytes())) => Seal::Changed,
            None if is_promised(file) => Seal::Cut,
            None => Seal::None,
        }
    }

    /// What is said of a file whose seal does not hold, and what to do; none where all is well.
    pub fn told(self, lang: Lang) -> Option<[String; 2]> {
        match self {
            Seal::None | Seal::Holds => None,
            Seal::Changed => Some([words::seal_changed(lang), words::seal_changed_help(lang)]),
            Seal::Cut => Some([words::seal_cut(lang), words::seal_cut_help(lang)]),
        }
    }
}

/// The same program file with a seal. A seal that it has already is made again.
pub fn sealed(file: &[u8]) -> Vec<u8> {
    let body = split(file).0;
    let mut made = Vec::with_capacity(body.len() + 128);
    let end = body.iter().position(|&byte| byte == b'\n');
    let (first, rest) = body.split_at(end.unwrap_or(body.len()));
    let (first, cr) = match first.strip_suffix(b"\r") {
        Some(first) => (first, "\r"),
        None => (first, ""),
    };
    made.extend_from_slice(first);
    if !is_promised(body) {
        // What stands after a / is a comment already.
        let comment = if first.contains(&b'/') { " " } else { " / " };
        made.extend_from_slice(comment.as_bytes());
        made.extend_from_slice(PROMISE.as_bytes());
    }
    made.extend_from_slice(cr.as_bytes());
    made.extend_from_slice(rest);
    if !made.ends_with(b"\n") {
        made.extend_from_slice(format!("{cr}\n").as_bytes());
    }
    let seal = sum(&made);
    made.extend_from_slice(format!("{SEAL}{seal}{cr}\n").as_bytes());
    made
}

/// Whether this begins a program file that a tool has written, whatever became of it since.
pub fn is_ours(file: &[u8]) -> bool {
    is_promised(file) || first_line(file) == EARLIER.as_bytes()
}

fn lines(file: &[u8]) -> impl DoubleEndedIterator<Item = &[u8]> {
    file.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii)
}

fn first_line(file: &[u8]) -> &[u8] {
    lines(file).next().unwrap_or_default()
}

fn is_promised(file: &[u8]) -> bool {
    first_line(file).ends_with(PROMISE.as_bytes())
}

/// What stands before the seal, and what the seal says; all of a file whose last line is none.
fn split(file: &[u8]) -> (&[u8], Option<&str>) {
    let trimmed = file.trim_ascii_end();
    let start = trimmed.iter().rposition(|&byte| byte == b'\n');
    let (body, last) = trimmed.split_at(start.map_or(0, |at| at + 1));
    let said = std::str::from_utf8(last).ok();
    match said.and_then(|last| last.strip_prefix(SEAL)) {
        Some(said) => (body, Some(said)),
        None => (file, None),
    }
}

/// `4711 bytes, check sum 1A2B`: of all but CR, which mail and editors put in and take out.
fn sum(body: &[u8]) -> String {
    let (mut crc, mut bytes) = (Crc16::default(), 0_u64);
    for &byte in body.iter().filter(|&&byte| byte != b'\r') {
        crc.push(byte);
        bytes += 1;
    }
    format!("{bytes} bytes, check sum {:04X}", crc.value())
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAMP: &[u8] = b"0         / program start\n827301    / RI 01\n877901    / WO 01\n";

    #[test]
    fn a_seal_holds_until_the_file_changes() {
        for file in [
            LAMP,
            b"0\n827301\n877901",
            b"/ lamp\r\n0\r\n827301\r\n877901\r\n",
            b"0",
            b"",
        ] {
            let made = sealed(file);
            assert_eq!(Seal::of(file), Seal::None);
            assert_eq!(Seal::of(&made), Seal::Holds, "{}", made.escape_ascii());
            assert!(is_ours(&made));
            assert_eq!(sealed(&made), made, "once");
            // Other ends of lines, and blank lines after it.
            let unix: Vec<u8> = made.iter().copied().filter(|&byte| byte != b'\r').collect();
            let dos = String::from_utf8(unix.clone())
                .unwrap()
                .replace('\n', "\r\n")
                + "\r\n";
            assert_eq!(
                [Seal::of(&unix), Seal::of(dos.as_bytes())],
                [Seal::Holds; 2]
            );
        }
        let made = String::from_utf8(sealed(LAMP)).unwrap();
        assert_eq!(
            made.lines().count(),
            LAMP.split(|&byte| byte == b'\n').count()
        );
        for changed in [
            made.replace("827301", "827302"),
            made.clone() + "877902\n",
            made.replace("877901    / WO 01\n", ""),
        ] {
            assert_eq!(Seal::of(changed.as_bytes()), Seal::Changed, "{changed}");
        }
    }

    /// A full disk may end a file anywhere.
    #[test]
    fn a_file_without_its_end_is_known_wherever_it_was_cut() {
        let made = sealed(LAMP);
        let first = made.iter().position(|&byte| byte == b'\n').unwrap();
        for end in first..made.len() - 1 {
            let cut = &made[..end];
            assert!(
                !matches!(Seal::of(cut), Seal::None | Seal::Holds),
                "{}",
                cut.escape_ascii()
            );
        }
    }

    #[test]
    fn what_others_wrote_is_not_ours() {
        for other in [
            "",
            "0\n827301\n877901\n",
            "12/03: called the electrician\n",
            "0 is the first line\n",
        ] {
            assert!(!is_ours(other.as_bytes()), "{other}");
        }
        assert!(is_ours(LAMP), "as compile wrote it");
    }
}
