//! Reading scenario files.
//!
//! The file's words are first taken as they stand, each with its place in the file; what they say
//! is checked after that, so that every error names a line.

use super::{Cell, Goal, Place, ProgramFile, Refusal, Scenario, Setting, Step, Stop, Timeline};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::num::NonZeroU32;
use std::ops::{Range, RangeInclusive};
use std::path::{Path, PathBuf};
use std::{fmt, fs};
use toml::Spanned;
use unoclp_core::isa::{ANALOGUE, MARKERS, REGISTERS};
use unoclp_core::{Cause, Millis, Point};
use unoclp_source::{BOARD, Source, Written};

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
    /// Reads a scenario file, and the program file that it names; one in Instruction List is compiled.
    pub fn load(path: &Path) -> Result<Scenario, LoadError> {
        with_keys(path, |name, keys, folder| {
            let program = named_program(name, &keys, folder)?;
            scenario(name, keys, program)
        })
    }

    /// Reads a scenario file to run it with this program, whichever it names, or none.
    pub fn load_for(path: &Path, program: ProgramFile) -> Result<Scenario, LoadError> {
        with_keys(path, |name, keys, _| scenario(name, keys, program))
    }

    /// The program file that a scenario file names, if it names one.
    pub fn program_of(path: &Path) -> Result<Option<PathBuf>, LoadError> {
        with_keys(path, |_, keys, folder| {
            Ok(keys.program.map(|name| folder.join(name.get_ref())))
        })
    }
}

/// Reads the keys of a scenario file; `make` makes something of them, its name and its folder.
fn with_keys<T>(
    path: &Path,
    make: impl FnOnce(&str, FileKeys, &Path) -> Result<T, Wrong>,
) -> Result<T, LoadError> {
    let name = path.display().to_string();
    let folder = path.parent().unwrap_or(Path::new(""));
    let (source, result) = match fs::read_to_string(path) {
        Ok(source) => {
            let result = keys(&source).and_then(|keys| make(&name, keys, folder));
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
    text: Option<Spanned<TextKey>>,
    start_ms: Option<Spanned<Millis>>,
    scan_ms: Option<Spanned<Millis>>,
    until: Option<Spanned<Millis>>,
    fault: Option<Spanned<FaultKeys>>,
    stops: Option<Spanned<StopKeys>>,
    #[serde(default)]
    step: Vec<Spanned<StepKeys>>,
}

/// The value of `text`: all of it, or one part after the other.
#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "`text` must be a text, or a list of texts and repeated texts"
)]
enum TextKey {
    Whole(String),
    Parts(Vec<TextPart>),
}

/// A part of a text: as it stands, or `{ repeat = 3, text = "…" }`.
#[derive(Deserialize)]
#[serde(untagged)]
enum TextPart {
    Once(String),
    Repeated(Repeated),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Repeated {
    repeat: usize,
    text: String,
}

/// The keys of `fault`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FaultKeys {
    number: u8,
    line: Option<u32>,
}

/// The keys of `stops`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StopKeys {
    at: Millis,
    number: u8,
    line: Option<u32>,
}

/// The keys of a `[[step]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StepKeys {
    at: Spanned<Millis>,
    #[serde(default)]
    restart: bool,
    #[serde(default)]
    set: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
    #[serde(default)]
    expect: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
}

fn keys(source: &str) -> Result<FileKeys, Wrong> {
    toml::from_str(source).map_err(|error| {
        let message = error.message();
        let hint = if message.starts_with("unknown field `until`")
            || message.starts_with("unknown field `fault`")
            || message.starts_with("unknown field `stops`")
        {
            "; keys of the whole file stand above the first [[step]]"
        } else {
            ""
        };
        wrong(error.span(), format!("{message}{hint}"))
    })
}

/// The program that a scenario file of this name gives.
fn named_program(name: &str, keys: &FileKeys, folder: &Path) -> Result<ProgramFile, Wrong> {
    match (&keys.program, &keys.text) {
        (Some(path), None) => program_file(path, keys, folder),
        (None, Some(text)) => Ok(ProgramFile {
            name: format!("the text in {name}"),
            bytes: program_text(text)?,
        }),
        (Some(_), Some(text)) => {
            let what = "`program` and `text` both give a program; keep one of them";
            Err(wrong(Some(text.span()), what))
        }
        (None, None) => {
            let what = "it names no program; give a file: `sim FILE --scenario S.toml`";
            Err(wrong(None, what))
        }
    }
}

fn scenario(name: &str, keys: FileKeys, program: ProgramFile) -> Result<Scenario, Wrong> {
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

/// The longest text that a scenario may describe by its parts, in bytes.
const LONGEST_TEXT: usize = 1 << 20;

/// The bytes of a text, with its repeated parts written out.
fn program_text(key: &Spanned<TextKey>) -> Result<Vec<u8>, Wrong> {
    let parts = match key.get_ref() {
        TextKey::Whole(text) => return Ok(text.clone().into_bytes()),
        TextKey::Parts(parts) => parts,
    };
    let mut bytes = Vec::new();
    for part in parts {
        let (times, text) = match part {
            TextPart::Once(text) => (1, text),
            TextPart::Repeated(Repeated { repeat, text }) => (*repeat, text),
        };
        let length = text.len().checked_mul(times);
        let room = LONGEST_TEXT - bytes.len();
        if length.is_none_or(|length| length > room) {
            let what = format!("`text` comes to more than {LONGEST_TEXT} bytes");
            return Err(wrong(Some(key.span()), what));
        }
        bytes.extend(text.as_bytes().repeat(times));
    }
    Ok(bytes)
}

fn program_file(
    path: &Spanned<String>,
    keys: &FileKeys,
    folder: &Path,
) -> Result<ProgramFile, Wrong> {
    let file = folder.join(path.get_ref());
    let name = file.display().to_string();
    let said = |what: String| wrong(Some(path.span()), format!("the program {name} {what}"));
    let bytes = fs::read(&file).map_err(|error| said(format!("cannot be read: {error}")))?;
    let written = Written::new(name.clone(), bytes);
    // A file that must be refused is numeric code, whatever it looks like.
    if !written.is_il || keys.fault.is_some() {
        let Written { name, bytes, .. } = written;
        return Ok(ProgramFile { name, bytes });
    }
    match written.check(None) {
        Ok(Source { name, code, .. }) => Ok(ProgramFile { name, bytes: code }),
        Err(_) => Err(said("has errors; `unoclp check` shows them".to_owned())),
    }
}

fn refusal(fault: &Spanned<FaultKeys>, keys: &FileKeys) -> Result<Refusal, Wrong> {
    let &FaultKeys { number, line } = fault.get_ref();
    if !keys.step.is_empty() || keys.until.is_some() || keys.stops.is_some() {
        let what = "a program with a `fault` never runs; remove `fault`, or the steps and `until`";
        return Err(wrong(Some(fault.span()), what));
    }
    known_fault(number, line, fault.span())
}

/// A fault that there is, with a line that there can be.
fn known_fault(number: u8, line: Option<u32>, place: Range<usize>) -> Result<Refusal, Wrong> {
    if !Cause::ALL.iter().any(|cause| cause.number() == number) {
        let what = format!("there is no fault {number}; docs/numeric-code.md lists them");
        return Err(wrong(Some(place), what));
    }
    if line == Some(0) {
        let what = "lines count from 1; leave `line` out where the fault has none";
        return Err(wrong(Some(place), what));
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
    let stop = match &keys.stops {
        Some(stop) => Some(self::stop(stop, keys, last, period)?),
        None => None,
    };
    let last = last.max(stop.map(|stop| stop.at));
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
        stop,
    })
}

/// The fault that a run ends in.
fn stop(
    stop: &Spanned<StopKeys>,
    keys: &FileKeys,
    last: Option<Millis>,
    period: NonZeroU32,
) -> Result<Stop, Wrong> {
    let &StopKeys { at, number, line } = stop.get_ref();
    if keys.until.is_some() || last > Some(at) {
        let what = "a run ends where it `stops`; remove `until` and later steps";
        return Err(wrong(Some(stop.span()), what));
    }
    if at % period != 0 {
        return Err(wrong(Some(stop.span()), no_scan(at, period)));
    }
    let refusal = known_fault(number, line, stop.span())?;
    Ok(Stop { at, refusal })
}

fn no_scan(at: Millis, period: NonZeroU32) -> String {
    format!("no scan runs at {at} ms; scans run every {period} ms (`scan_ms`)")
}

fn steps(keys: &[Spanned<StepKeys>], period: NonZeroU32) -> Result<Vec<Step>, Wrong> {
    let mut steps: Vec<Step> = Vec::new();
    for step in keys {
        let StepKeys {
            at,
            restart,
            set,
            expect,
        } = step.get_ref();
        let (place, at) = (Some(at.span()), *at.get_ref());
        if let Some(last) = steps.last().filter(|last| last.at >= at) {
            let what = format!(
                "the step at {at} ms does not come after the one at {} ms; put steps in rising order",
                last.at
            );
            return Err(wrong(place, what));
        }
        if at % period != 0 {
            return Err(wrong(place, no_scan(at, period)));
        }
        let set = set.iter().map(setting).collect::<Result<_, Wrong>>()?;
        let expect = expect
            .iter()
            .map(expectation)
            .collect::<Result<_, Wrong>>()?;
        steps.push(Step {
            at,
            restart: *restart,
            set,
            expect,
        });
    }
    Ok(steps)
}

/// A name, and the value that it is to have: `I1 = 1`.
type Pair<'k> = (&'k Spanned<String>, &'k Spanned<toml::Value>);

/// What is set: `I1 = 1`, `A0 = 512`, `M2 = 1`, `D3 = -5`.
fn setting(pair: Pair<'_>) -> Result<Setting, Wrong> {
    let name = pair.0.get_ref();
    let input = (1..=BOARD.inputs).find(|number| *name == format!("I{number}"));
    if let Some(point) = input.and_then(|number| Point::new(number, BOARD.inputs)) {
        return Ok(Setting::Input(point, number(pair, 0..=1)? == 1));
    }
    if let Some(input) = (0..ANALOGUE).find(|number| *name == format!("A{number}")) {
        return Ok(Setting::Analogue(input, number(pair, 0..=1023)? as u16));
    }
    match Place::of_name(name) {
        Some(Place::Cell(cell @ Cell::Marker(_))) => Ok(Setting::Cell(cell, number(pair, 0..=1)?)),
        Some(Place::Cell(cell)) => Ok(Setting::Cell(cell, number(pair, i32::MIN..=i32::MAX)?)),
        _ => {
            let what = format!(
                "{name} cannot be set; what can is I1 to I{}, A0 to A{}, M1 to M{MARKERS} and \
                 D1 to D{REGISTERS}",
                BOARD.inputs,
                ANALOGUE - 1
            );
            Err(wrong(Some(pair.0.span()), what))
        }
    }
}

/// What is expected: `Q1 = 1`, `M2 = 0`, `D3 = -5`, `P4 = 128`, each also `"any"`.
fn expectation(pair: Pair<'_>) -> Result<(Place, Option<i32>), Wrong> {
    let name = pair.0.get_ref();
    let Some(place) = Place::of_name(name) else {
        let what = format!(
            "{name} cannot be expected; what can is Q1 to Q{}, M1 to M{MARKERS}, D1 to \
             D{REGISTERS}, P1 and P4",
            BOARD.outputs
        );
        return Err(wrong(Some(pair.0.span()), what));
    };
    if pair.1.get_ref().as_str() == Some("any") {
        return Ok((place, None));
    }
    let range = match place {
        _ if place.is_bit() => 0..=1,
        Place::Pwm(_) => 0..=255,
        _ => i32::MIN..=i32::MAX,
    };
    let number = number(pair, range).map_err(|mut wrong| {
        wrong.what += ", or \"any\"";
        wrong
    })?;
    Ok((place, Some(number)))
}

/// A number of this range.
fn number((name, value): Pair<'_>, range: RangeInclusive<i32>) -> Result<i32, Wrong> {
    let number = value.get_ref().as_integer();
    let number = number.and_then(|number| i32::try_from(number).ok());
    number
        .filter(|number| range.contains(number))
        .ok_or_else(|| {
            let (from, to) = range.into_inner();
            let valid = match (from, to) {
                (0, 1) => "0 or 1".to_owned(),
                _ => format!("a number from {from} to {to}"),
            };
            wrong(
                Some(value.span()),
                format!("{} must be {valid}", name.get_ref()),
            )
        })
}
