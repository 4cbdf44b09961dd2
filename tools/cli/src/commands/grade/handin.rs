//! What a student has handed in: the file that *Hand in* of the page writes.
//!
//! Owns what such a file says. Must not know whether that is so: the program is compiled and run again, and what the file
//! says of its verdicts counts for nothing.

use crate::messages;
use serde_json::Value;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use unoclp_program::shown;

/// How the name of such a file ends.
pub const END: &str = ".unoclp.json";
/// What `form` says in it.
const FORM: &str = "unoclp-hand-in-1";
/// The longest one that is read, bytes: a program of the longest text and its drawing have room in it.
const LONGEST: u64 = 4 << 20;
/// A name is cut after so many characters.
const LONGEST_NAME: usize = 100;

/// A file that was handed in, as it says itself.
#[derive(Debug, PartialEq, Eq)]
pub struct HandIn {
    /// Who.
    pub student: Student,
    /// The exercise, as the page calls it.
    pub exercise: String,
    /// The program's name.
    pub name: String,
    /// Its text; where a fault is to be found, the parts and faults that were named.
    pub text: String,
}

/// Who has handed something in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Student {
    /// As they write it.
    pub name: String,
    /// The number or the address that their school knows them by; empty where they gave none.
    pub number: String,
    /// How long the exercise was open, minutes.
    pub minutes: Option<u64>,
    /// Whether the file says that the program passed.
    pub says_passed: bool,
}

/// Whether a file is called like one that was handed in.
pub fn is_hand_in(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.to_lowercase().ends_with(END)
}

impl HandIn {
    /// Reads one, or says why it is none, and what to do.
    pub fn read(path: &Path) -> Result<HandIn, String> {
        let cannot = |why: io::Error| messages::cannot_read(shown(path), messages::io(&why));
        let mut file = File::open(path).map_err(cannot)?;
        let length = file.metadata().map_err(cannot)?.len();
        if length > LONGEST {
            return Err(messages::hand_in_too_long(shown(path), length, LONGEST));
        }
        let mut bytes = Vec::new();
        let mut most = (&mut file).take(LONGEST);
        most.read_to_end(&mut bytes).map_err(cannot)?;
        HandIn::of(&shown(path), &bytes)
    }

    /// That of these bytes, in a file of this name.
    fn of(file: &str, bytes: &[u8]) -> Result<HandIn, String> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let all: Value = serde_json::from_slice(bytes)
            .map_err(|why| messages::hand_in_no_json(file, why.line(), why.column()))?;
        let text = |place: &str| {
            let found = all.pointer(place).and_then(Value::as_str);
            found.ok_or_else(|| messages::hand_in_lacks(file, key(place)))
        };
        let form = text("/form")?;
        if form != FORM {
            return Err(messages::hand_in_other_form(file, form, FORM));
        }
        let name = text("/student/name")?.trim();
        if name.is_empty() {
            return Err(messages::hand_in_lacks(file, key("/student/name")));
        }
        let program = text("/program/text")?;
        let answer = all.pointer("/answer").and_then(Value::as_str);
        Ok(HandIn {
            student: Student {
                name: short(name),
                number: short(text("/student/number").unwrap_or_default().trim()),
                minutes: all.pointer("/minutes").and_then(Value::as_u64),
                says_passed: all.pointer("/verdicts/passed") == Some(&Value::Bool(true)),
            },
            exercise: short(text("/exercise/name")?),
            name: short(text("/program/name")?),
            text: answer.unwrap_or(program).to_owned(),
        })
    }
}

/// `/student/name` as a person says it.
fn key(place: &str) -> String {
    place.trim_start_matches('/').replace('/', ".")
}

fn short(text: &str) -> String {
    text.chars().take(LONGEST_NAME).collect()
}
