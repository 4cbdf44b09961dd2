//! The words of a scenario file as they stand, each with its place in the file.
//!
//! Owns the names of the keys. Must not know which values are right: what reads them does.

use super::{Both, Equivalent, LoadError, Wrong};
use crate::find::Hidden;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::ops::Range;
use toml::Spanned;
use unoclp_core::{Board, Millis};

/// What is wrong, and the bytes of the file that say it.
pub(super) struct Slip {
    place: Option<Range<usize>>,
    pub(super) wrong: Wrong,
}

impl Slip {
    /// The same, in this place if it has none of its own.
    pub(super) fn or_in(self, place: Range<usize>) -> Slip {
        Slip {
            place: self.place.or(Some(place)),
            ..self
        }
    }

    pub(super) fn in_file(self, file: String, source: &str) -> LoadError {
        LoadError {
            file,
            line: self.place.map(|place| line_of(source, place.start)),
            wrong: self.wrong,
        }
    }
}

pub(super) fn slip(place: Option<Range<usize>>, wrong: Wrong) -> Slip {
    Slip { place, wrong }
}

/// The line of a byte of the file, counted from 1.
fn line_of(source: &str, byte: usize) -> usize {
    let before = source.bytes().take(byte);
    before.filter(|&byte| byte == b'\n').count() + 1
}

/// The keys of a scenario file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FileKeys {
    pub(super) about: Option<String>,
    pub(super) title: Option<Both>,
    pub(super) board: Option<Spanned<String>>,
    pub(super) task: Option<Both>,
    #[serde(default)]
    pub(super) hints: Vec<Both>,
    #[serde(default)]
    pub(super) names: BTreeMap<Spanned<String>, Both>,
    #[serde(default)]
    pub(super) normally_closed: Vec<Spanned<String>>,
    #[serde(default)]
    pub(super) equivalent: Vec<Equivalent>,
    pub(super) program: Option<Spanned<String>>,
    pub(super) plant: Option<Spanned<String>>,
    pub(super) seeds: Option<Spanned<Vec<u32>>>,
    pub(super) text: Option<Spanned<TextKey>>,
    pub(super) given: Option<Spanned<String>>,
    pub(super) answer_in: Option<Spanned<String>>,
    pub(super) find: Option<Spanned<Hidden>>,
    pub(super) start_ms: Option<Spanned<Millis>>,
    pub(super) scan_ms: Option<Spanned<Millis>>,
    pub(super) within_ms: Option<Spanned<Millis>>,
    pub(super) until: Option<Spanned<Millis>>,
    pub(super) fault: Option<Spanned<FaultKeys>>,
    pub(super) stops: Option<Spanned<StopKeys>>,
    #[serde(default)]
    pub(super) step: Vec<Spanned<StepKeys>>,
    #[serde(default)]
    pub(super) case: Vec<Spanned<CaseKeys>>,
}

impl FileKeys {
    /// The board that the file names, or else this one.
    pub(super) fn board(&self, usual: Board) -> Result<Board, Slip> {
        let Some(name) = &self.board else {
            return Ok(usual);
        };
        Board::named(name.get_ref()).ok_or_else(|| {
            let wrong = Wrong::NoBoard {
                name: name.get_ref().clone(),
            };
            slip(Some(name.span()), wrong)
        })
    }
}

/// The keys of a `[[case]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CaseKeys {
    pub(super) title: Both,
    #[serde(default)]
    pub(super) hidden: bool,
    pub(super) until: Option<Spanned<Millis>>,
    #[serde(default)]
    pub(super) step: Vec<Spanned<StepKeys>>,
}

/// The value of `text`: all of it, or one part after the other.
#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "write `text` as a string, or as a list of strings and { repeat = 3, text = \"…\" }"
)]
pub(super) enum TextKey {
    Whole(String),
    Parts(Vec<TextPart>),
}

/// A part of a text: as it stands, or `{ repeat = 3, text = "…" }`.
#[derive(Deserialize)]
#[serde(untagged)]
pub(super) enum TextPart {
    Once(String),
    Repeated(Repeated),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Repeated {
    pub(super) repeat: usize,
    pub(super) text: String,
}

/// The keys of `fault`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FaultKeys {
    pub(super) number: u8,
    pub(super) line: Option<u32>,
}

/// The keys of `stops`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StopKeys {
    pub(super) at: Millis,
    pub(super) number: u8,
    pub(super) line: Option<u32>,
}

/// The keys of a `[[step]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StepKeys {
    pub(super) at: Spanned<Millis>,
    #[serde(default)]
    pub(super) restart: bool,
    #[serde(default)]
    pub(super) set: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
    #[serde(default)]
    pub(super) expect: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
}

pub(super) fn keys(source: &str) -> Result<FileKeys, Slip> {
    toml::from_str(source).map_err(|error| {
        let told = error.message().to_owned();
        let of_the_file = ["until", "fault", "stops"].into_iter();
        let key = of_the_file
            .map(str::to_owned)
            .find(|key| told.starts_with(&format!("unknown field `{key}`")));
        let wrong = match key {
            Some(key) => Wrong::KeyInStep { told, key },
            None => Wrong::Toml { told },
        };
        slip(error.span(), wrong)
    })
}
