//! Reading scenario files.
//!
//! The file's words are first taken as they stand, each with its place in the file; what they say
//! is checked after that, so that every error names a line.

use super::program::bytes;
use super::{Cell, Goal, LONGEST, LoadError, Place, ProgramFile, Refusal, Scenario, Setting};
use super::{Step, Stop, Timeline, Unreadable, Wrong};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::io::{self, ErrorKind};
use std::num::NonZeroU32;
use std::ops::{Range, RangeInclusive};
use std::path::{Path, PathBuf};
use toml::Spanned;
use unoclp_core::isa::ANALOGUE;
use unoclp_core::{Cause, Millis, Point};
use unoclp_source::{BOARD, Source, Written};

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

    /// Reads the text of a scenario, which goes by this name, to run it with this program.
    ///
    /// # Errors
    /// What is wrong with it, and where.
    pub fn of_text(name: &str, source: &str, program: ProgramFile) -> Result<Scenario, LoadError> {
        let result = keys(source).and_then(|keys| scenario(name, keys, program));
        result.map_err(|slip| slip.in_file(name.to_owned(), source))
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
    make: impl FnOnce(&str, FileKeys, &Path) -> Result<T, Slip>,
) -> Result<T, LoadError> {
    let name = path.display().to_string();
    let folder = path.parent().unwrap_or(Path::new(""));
    let (source, result) = match text(path) {
        Ok(source) => {
            let result = keys(&source).and_then(|keys| make(&name, keys, folder));
            (source, result)
        }
        Err(why) => (String::new(), Err(slip(None, Wrong::Unreadable(why)))),
    };
    result.map_err(|slip| slip.in_file(name, &source))
}

/// The text of a scenario file.
fn text(path: &Path) -> Result<String, Unreadable> {
    let text = String::from_utf8(bytes(path)?);
    Ok(text.map_err(|error| io::Error::new(ErrorKind::InvalidData, error))?)
}

/// What is wrong, and the bytes of the file that say it.
struct Slip {
    place: Option<Range<usize>>,
    wrong: Wrong,
}

impl Slip {
    fn in_file(self, file: String, source: &str) -> LoadError {
        LoadError {
            file,
            line: self.place.map(|place| line_of(source, place.start)),
            wrong: self.wrong,
        }
    }
}

fn slip(place: Option<Range<usize>>, wrong: Wrong) -> Slip {
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

fn keys(source: &str) -> Result<FileKeys, Slip> {
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

/// The program that a scenario file of this name gives.
fn named_program(name: &str, keys: &FileKeys, folder: &Path) -> Result<ProgramFile, Slip> {
    match (&keys.program, &keys.text) {
        (Some(path), None) => program_file(path, keys, folder),
        (None, Some(text)) => Ok(ProgramFile {
            name: format!("{name} (text)"),
            bytes: program_text(text)?,
        }),
        (Some(_), Some(text)) => Err(slip(Some(text.span()), Wrong::TwoPrograms)),
        (None, None) => Err(slip(None, Wrong::NoProgram)),
    }
}

fn scenario(name: &str, keys: FileKeys, program: ProgramFile) -> Result<Scenario, Slip> {
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

/// The bytes of a text, with its repeated parts written out.
fn program_text(key: &Spanned<TextKey>) -> Result<Vec<u8>, Slip> {
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
        let most = LONGEST as usize;
        if length.is_none_or(|length| length > most - bytes.len()) {
            return Err(slip(Some(key.span()), Wrong::LongText { most: LONGEST }));
        }
        bytes.extend(text.as_bytes().repeat(times));
    }
    Ok(bytes)
}

fn program_file(
    path: &Spanned<String>,
    keys: &FileKeys,
    folder: &Path,
) -> Result<ProgramFile, Slip> {
    let file = folder.join(path.get_ref());
    let name = file.display().to_string();
    let bytes = bytes(&file).map_err(|why| {
        let name = name.clone();
        slip(Some(path.span()), Wrong::Program { name, why })
    })?;
    let written = Written::new(name.clone(), bytes);
    // A file that must be refused is numeric code, whatever it looks like.
    if !written.is_text() || keys.fault.is_some() {
        let Written { name, bytes, .. } = written;
        return Ok(ProgramFile { name, bytes });
    }
    match written.check(None) {
        Ok(Source { name, code, .. }) => Ok(ProgramFile { name, bytes: code }),
        Err(_) => Err(slip(Some(path.span()), Wrong::FaultyProgram { name })),
    }
}

fn refusal(fault: &Spanned<FaultKeys>, keys: &FileKeys) -> Result<Refusal, Slip> {
    let &FaultKeys { number, line } = fault.get_ref();
    if !keys.step.is_empty() || keys.until.is_some() || keys.stops.is_some() {
        return Err(slip(Some(fault.span()), Wrong::FaultAndSteps));
    }
    known_fault(number, line, fault.span())
}

/// A fault that there is, with a line that there can be.
fn known_fault(number: u8, line: Option<u32>, place: Range<usize>) -> Result<Refusal, Slip> {
    if !Cause::ALL.iter().any(|cause| cause.number() == number) {
        return Err(slip(Some(place), Wrong::NoFault { number }));
    }
    if line == Some(0) {
        return Err(slip(Some(place), Wrong::LineZero));
    }
    Ok(Refusal { number, line })
}

fn timeline(keys: &FileKeys) -> Result<Timeline, Slip> {
    let period = match &keys.scan_ms {
        None => NonZeroU32::MIN,
        Some(ms) => {
            NonZeroU32::new(*ms.get_ref()).ok_or_else(|| slip(Some(ms.span()), Wrong::NoPeriod))?
        }
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
            return Err(slip(Some(until.span()), Wrong::EndsEarly { last }));
        }
        (Some(until), _) => *until.get_ref(),
        (None, Some(last)) => last,
        (None, None) => return Err(slip(None, Wrong::NothingHappens)),
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
) -> Result<Stop, Slip> {
    let &StopKeys { at, number, line } = stop.get_ref();
    if keys.until.is_some() || last > Some(at) {
        return Err(slip(Some(stop.span()), Wrong::GoesOn));
    }
    if at % period != 0 {
        return Err(slip(Some(stop.span()), no_scan(at, period)));
    }
    let refusal = known_fault(number, line, stop.span())?;
    Ok(Stop { at, refusal })
}

fn no_scan(at: Millis, period: NonZeroU32) -> Wrong {
    let period = period.get();
    Wrong::NoScan { at, period }
}

fn steps(keys: &[Spanned<StepKeys>], period: NonZeroU32) -> Result<Vec<Step>, Slip> {
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
            let last = last.at;
            return Err(slip(place, Wrong::Order { at, last }));
        }
        if at % period != 0 {
            return Err(slip(place, no_scan(at, period)));
        }
        let set = set.iter().map(setting).collect::<Result<_, Slip>>()?;
        let expect = expect
            .iter()
            .map(expectation)
            .collect::<Result<_, Slip>>()?;
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
fn setting(pair: Pair<'_>) -> Result<Setting, Slip> {
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
            let name = name.clone();
            Err(slip(Some(pair.0.span()), Wrong::NotSet { name }))
        }
    }
}

/// What is expected: `Q1 = 1`, `M2 = 0`, `D3 = -5`, `P4 = 128`, each also `"any"`.
fn expectation(pair: Pair<'_>) -> Result<(Place, Option<i32>), Slip> {
    let name = pair.0.get_ref();
    let Some(place) = Place::of_name(name) else {
        let name = name.clone();
        return Err(slip(Some(pair.0.span()), Wrong::NotExpected { name }));
    };
    if pair.1.get_ref().as_str() == Some("any") {
        return Ok((place, None));
    }
    let range = match place {
        _ if place.is_bit() => 0..=1,
        Place::Pwm(_) => 0..=255,
        _ => i32::MIN..=i32::MAX,
    };
    let number = number(pair, range).map_err(|mut slip| {
        if let Wrong::Value { or_any, .. } = &mut slip.wrong {
            *or_any = true;
        }
        slip
    })?;
    Ok((place, Some(number)))
}

/// A number of this range.
fn number((name, value): Pair<'_>, range: RangeInclusive<i32>) -> Result<i32, Slip> {
    let number = value.get_ref().as_integer();
    let number = number.and_then(|number| i32::try_from(number).ok());
    number
        .filter(|number| range.contains(number))
        .ok_or_else(|| {
            let (from, to) = range.into_inner();
            let wrong = Wrong::Value {
                name: name.get_ref().clone(),
                from,
                to,
                or_any: false,
            };
            slip(Some(value.span()), wrong)
        })
}
