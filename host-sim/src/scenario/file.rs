//! Reading scenario files.
//!
//! The file's words are first taken as they stand, each with its place in the file; what they say
//! is checked after that, so that every error names a line.

use super::{Goal, ProgramFile, Refusal, Scenario, Step, Timeline};
use crate::BOARD;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::num::NonZeroU32;
use std::ops::Range;
use std::path::Path;
use std::{fmt, fs};
use toml::Spanned;
use unoclp_core::{Cause, Millis, Point};

/// Why a scenario could not be read: the file, the line where there is one, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadError {
    file: String,
    line: Option<usize>,
    what: String,
}

impl fmt::Display for LoadError {
    /// `motor.toml:7: there is no point Q9; the board has Q1 to Q4`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.file)?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        write!(f, ": {}", self.what)
    }
}

impl std::error::Error for LoadError {}

impl Scenario {
    /// Reads a scenario file, and the program file that it names.
    pub fn load(path: &Path) -> Result<Scenario, LoadError> {
        let name = path.display().to_string();
        let folder = path.parent().unwrap_or(Path::new(""));
        let (source, result) = match fs::read_to_string(path) {
            Ok(source) => {
                let result = read(&name, &source, folder);
                (source, result)
            }
            Err(error) => (String::new(), Err(wrong(None, unreadable(&error)))),
        };
        result.map_err(|Wrong { place, what }| LoadError {
            file: name,
            line: place.map(|place| line_of(&source, place.start)),
            what,
        })
    }
}

/// What is wrong, and the bytes of the file that say it.
struct Wrong {
    place: Option<Range<usize>>,
    what: String,
}

fn wrong(place: Option<Range<usize>>, what: impl Into<String>) -> Wrong {
    let what = what.into();
    Wrong { place, what }
}

fn unreadable(error: &std::io::Error) -> String {
    format!("the file cannot be read: {error}")
}

/// The line of a byte of the file, counted from 1.
fn line_of(source: &str, byte: usize) -> usize {
    let before = source.bytes().take(byte);
    before.filter(|&byte| byte == b'\n').count() + 1
}

/// The keys of a scenario file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FileKeys {
    about: String,
    program: Option<Spanned<String>>,
    text: Option<Spanned<String>>,
    start_ms: Option<Spanned<Millis>>,
    scan_ms: Option<Spanned<Millis>>,
    until: Option<Spanned<Millis>>,
    fault: Option<Spanned<FaultKeys>>,
    #[serde(default)]
    step: Vec<Spanned<StepKeys>>,
}

/// The keys of `fault`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FaultKeys {
    number: u8,
    line: Option<u32>,
}

/// The keys of a `[[step]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StepKeys {
    at: Spanned<Millis>,
    #[serde(default)]
    set: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
    #[serde(default)]
    expect: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
}

fn read(name: &str, source: &str, folder: &Path) -> Result<Scenario, Wrong> {
    let keys: FileKeys = toml::from_str(source).map_err(|error| {
        let message = error.message();
        let hint = if message.starts_with("unknown field `until`")
            || message.starts_with("unknown field `fault`")
        {
            "; keys of the whole file stand above the first [[step]]"
        } else {
            ""
        };
        wrong(error.span(), format!("{message}{hint}"))
    })?;
    let program = match (&keys.program, &keys.text) {
        (Some(path), None) => program_file(path, folder)?,
        (None, Some(text)) => ProgramFile {
            name: format!("the text in {name}"),
            bytes: text.get_ref().clone().into_bytes(),
        },
        (Some(_), Some(text)) => {
            let what = "`program` and `text` both give a program; keep one of them";
            return Err(wrong(Some(text.span()), what));
        }
        (None, None) => {
            let what = "no program; name its file with `program`, or write it as `text`";
            return Err(wrong(None, what));
        }
    };
    let goal = match &keys.fault {
        Some(fault) => Goal::Refusal(refusal(fault, &keys)?),
        None => Goal::Run(timeline(&keys)?),
    };
    Ok(Scenario {
        name: name.to_owned(),
        about: keys.about,
        program,
        goal,
    })
}

fn program_file(path: &Spanned<String>, folder: &Path) -> Result<ProgramFile, Wrong> {
    let file = folder.join(path.get_ref());
    let name = file.display().to_string();
    match fs::read(&file) {
        Ok(bytes) => Ok(ProgramFile { name, bytes }),
        Err(error) => Err(wrong(
            Some(path.span()),
            format!("the program {name} cannot be read: {error}"),
        )),
    }
}

fn refusal(fault: &Spanned<FaultKeys>, keys: &FileKeys) -> Result<Refusal, Wrong> {
    let &FaultKeys { number, line } = fault.get_ref();
    if !keys.step.is_empty() || keys.until.is_some() {
        let what = "a program with a `fault` never runs; remove `fault`, or the steps and `until`";
        return Err(wrong(Some(fault.span()), what));
    }
    if !Cause::ALL.iter().any(|cause| cause.number() == number) {
        let what = format!("there is no fault {number}; docs/numeric-code.md lists them");
        return Err(wrong(Some(fault.span()), what));
    }
    if line == Some(0) {
        let what = "lines count from 1; leave `line` out where the fault has none";
        return Err(wrong(Some(fault.span()), what));
    }
    Ok(Refusal { number, line })
}

fn timeline(keys: &FileKeys) -> Result<Timeline, Wrong> {
    let period = match &keys.scan_ms {
        None => NonZeroU32::MIN,
        Some(ms) => NonZeroU32::new(*ms.get_ref())
            .ok_or_else(|| wrong(Some(ms.span()), "`scan_ms` must be 1 or more"))?,
    };
    let steps = steps(&keys.step, period)?;
    let last = steps.last().map(|step| step.at);
    let until = match (&keys.until, last) {
        (Some(until), Some(last)) if *until.get_ref() < last => {
            let what = format!("`until` comes before the last step, at {last} ms");
            return Err(wrong(Some(until.span()), what));
        }
        (Some(until), _) => *until.get_ref(),
        (None, Some(last)) => last,
        (None, None) => {
            let what = "nothing happens; write a [[step]], or the `fault` that is expected";
            return Err(wrong(None, what));
        }
    };
    Ok(Timeline {
        start: keys.start_ms.as_ref().map_or(0, |ms| *ms.get_ref()),
        period,
        steps,
        until,
    })
}

fn steps(keys: &[Spanned<StepKeys>], period: NonZeroU32) -> Result<Vec<Step>, Wrong> {
    let mut steps: Vec<Step> = Vec::new();
    for step in keys {
        let StepKeys { at, set, expect } = step.get_ref();
        let (place, at) = (Some(at.span()), *at.get_ref());
        if let Some(last) = steps.last().filter(|last| last.at >= at) {
            let what = format!(
                "the step at {at} ms does not come after the one at {} ms; put steps in rising order",
                last.at
            );
            return Err(wrong(place, what));
        }
        if at % period != 0 {
            let what = format!("no scan runs at {at} ms; scans run every {period} ms (`scan_ms`)");
            return Err(wrong(place, what));
        }
        let set = states(set, 'I', "an input", BOARD.inputs, binary)?;
        let expect = states(expect, 'Q', "an output", BOARD.outputs, binary_or_any)?;
        steps.push(Step { at, set, expect });
    }
    Ok(steps)
}

/// Reads `{ I1 = 1, … }`: points of one kind and their states.
fn states<T>(
    keys: &BTreeMap<Spanned<String>, Spanned<toml::Value>>,
    letter: char,
    kind: &str,
    count: u8,
    state: impl Fn(&toml::Value) -> Result<T, &'static str>,
) -> Result<Vec<(Point, T)>, Wrong> {
    let mut states = Vec::new();
    for (name, value) in keys {
        let named = |number: &u8| name.get_ref() == &format!("{letter}{number}");
        let point = (1..=count).find(named).and_then(|n| Point::new(n, count));
        let point = point.ok_or_else(|| {
            let what = format!(
                "{} is not {kind} of the board; it has {letter}1 to {letter}{count}",
                name.get_ref()
            );
            wrong(Some(name.span()), what)
        })?;
        let state = state(value.get_ref()).map_err(|valid| {
            let what = format!("{} must be {valid}", name.get_ref());
            wrong(Some(value.span()), what)
        })?;
        states.push((point, state));
    }
    Ok(states)
}

fn binary(value: &toml::Value) -> Result<bool, &'static str> {
    match value.as_integer() {
        Some(0) => Ok(false),
        Some(1) => Ok(true),
        _ => Err("0 or 1"),
    }
}

fn binary_or_any(value: &toml::Value) -> Result<Option<bool>, &'static str> {
    match value.as_str() {
        Some("any") => Ok(None),
        _ => binary(value).map(Some).map_err(|_| "0, 1 or \"any\""),
    }
}
