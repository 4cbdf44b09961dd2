//! A text as a person has written it, and what there is to show of it.
//!
//! Owns what a page is told of a program as a whole. Must not know how it is drawn or run.

use crate::answer::answer;
use crate::tell::{Problem, colours, problems, warnings};
use crate::words::{self, Both, No, both};
use std::collections::BTreeMap;
use std::rc::Rc;
use unoclp_client::diagnostics::Kept;
use unoclp_core::{Board, Delay};
use unoclp_lang::typed::Width;
use unoclp_point::Address;
use unoclp_program::used::Used;
use unoclp_program::{Holding, Lang, Language, Seal, Source, Written, WrittenIn, lacks, not_sent};
use unoclp_workspace::{Analysis, Version, Workspace};

/// The longest text that is looked at, bytes.
pub const LONGEST: usize = 1 << 20;

answer! {
    /// What there is to say of a text.
    pub struct Checked as "Checked" {
        /// `il`, `st`, `scl`, `iscl`, `lce`, `numeric`; empty for a text in none of them.
        language: &'static str => "LanguageName",
        problems: Vec<Problem>,
        /// How many more there are.
        more: usize,
        /// The coloured parts of the text, each by three numbers: units of UTF-16 since the end of the one before, its own
        /// units, and what it is (`tell::colours`).
        colours: Vec<u32>,
        /// None where the text has errors.
        program: Option<Made>,
        /// Whether no instruction stands in it yet: one can draw the first.
        blank: bool,
    }
}

answer! {
    /// What has become of a text.
    pub struct Made as "Made" {
        /// What stands in PROGRAM.TXT.
        code: String,
        /// What the text calls its points.
        symbols: BTreeMap<String, String>,
        /// For each step: the line of the text, from 1, and the first and last line of PROGRAM.TXT.
        map: Vec<[u32; 3]>,
        size: Size,
        uses: Uses,
        /// How a board keeps it.
        kept: Stored,
        /// Why it is sent to no board; none where it is written for one.
        unsent: Option<Both>,
        /// The boards that hold it.
        held_by: Vec<&'static str>,
        /// What the first board lacks for it; none where one holds it.
        lacking: Option<Both>,
    }
}

answer! {
    /// How much of the board it takes: bytes.
    struct Size as "Size" {
        stored: usize,
        /// How many there are.
        all: u16,
    }
}

answer! {
    /// The numbers that it names.
    #[derive(Clone)]
    pub struct Uses as "Uses" {
        inputs: Vec<u8>,
        analogue: Vec<u8>,
        outputs: Vec<u8>,
        pwm: Vec<u8>,
        markers: Vec<u8>,
        registers: Vec<u8>,
        reals: Vec<u8>,
        counters: Vec<u8>,
        /// What each timer does, from T 01 on: `TON`, `TOF`, `TP` …
        timers: Vec<&'static str>,
    }
}

answer! {
    /// How a board keeps a program.
    #[derive(Clone, Copy, Default, PartialEq, Eq)]
    pub struct Stored as "Stored" {
        version: u8,
        bytes: u16,
        sum: u16,
    }
}

impl From<Kept> for Stored {
    fn from(kept: Kept) -> Stored {
        Stored {
            version: kept.version,
            bytes: kept.bytes,
            sum: kept.sum,
        }
    }
}

/// The registers that hold a variable of a text which is REAL by its declaration: a program that only moves it does not tell.
fn declared(source: &Source) -> impl Iterator<Item = u8> {
    let held = source
        .variables
        .iter()
        .flat_map(|variable| match variable.holding {
            Holding::One(held) => [Some(held), None],
            Holding::Either { set, clear, .. } => [set, clear],
            Holding::Constant(..) => [None; 2],
        });
    held.flatten().filter_map(|held| match held {
        (Address::Register(number), base) if base.width() == Width::Single => Some(number),
        _ => None,
    })
}

impl Uses {
    /// What this program uses.
    pub fn of(source: &Source) -> Uses {
        let Used {
            inputs,
            analogue,
            outputs,
            pwm,
            markers,
            registers,
            reals,
            counters,
        } = &source.size.used;
        let timers = source.program().steps();
        let list = |set: &std::collections::BTreeSet<u8>| set.iter().copied().collect();
        Uses {
            inputs: list(inputs),
            analogue: list(analogue),
            outputs: list(outputs),
            pwm: list(pwm),
            markers: list(markers),
            registers: list(registers),
            reals: list(&reals.iter().copied().chain(declared(source)).collect()),
            counters: list(counters),
            timers: timers
                .filter_map(|step| Delay::of(step.opcode).map(Delay::letters))
                .collect(),
        }
    }
}

/// A text of a page, for this board.
///
/// # Errors
/// Where it is too long.
pub fn written(name: String, text: String, board: Board) -> Result<Written, Both> {
    match text.len() > LONGEST {
        true => Err(both(|lang| words::too_long(lang, LONGEST))),
        false => Ok(Written::new(name, text.into_bytes(), board)),
    }
}

/// What is known of this version.
///
/// # Errors
/// That it is no longer known.
pub fn known(version: Version, workspace: &mut Workspace) -> Result<Rc<Analysis>, Both> {
    let analysis = workspace.analysis(version);
    analysis.ok_or_else(|| both(|lang| words::no_version(lang, version.0)))
}

/// The program of a text.
///
/// # Errors
/// That there is none.
pub fn source(analysis: &Analysis) -> Result<&Source, No> {
    match analysis.check() {
        None => Err(No::More),
        Some(Ok(source)) => Ok(source),
        Some(Err(_)) => Err(both(words::faulty).into()),
    }
}

/// Says what there is to say of a text.
///
/// # Errors
/// That it takes the module that has everything.
pub fn check(analysis: &Analysis) -> Result<Checked, No> {
    let written = analysis.written();
    let text = written.text();
    let (language, (problems, more), program) = match analysis.check() {
        None => return Err(No::More),
        Some(Ok(source)) => {
            // What is cut off is no program that anybody has written.
            let whole = source.seal() != Seal::Cut;
            let made = whole.then(|| made(source, analysis));
            (language(&source.language), warnings(source), made)
        }
        Some(Err(refused)) => {
            let language = written.language.map_or("", WrittenIn::name);
            (language, problems(&text, refused), None)
        }
    };
    Ok(Checked {
        language,
        problems,
        more,
        colours: colours(&text, analysis.colours()),
        program,
        blank: analysis.is_blank(),
    })
}

fn language(language: &Language) -> &'static str {
    match language {
        Language::Numeric => "numeric",
        Language::Il { .. } => "il",
        Language::Typed { language, .. } => language.name(),
        Language::Xml { .. } => "xml",
    }
}

/// The boards that hold a program: its own, or each that does, where it is written for none.
fn held_by(source: &Source) -> Vec<&'static str> {
    if source.board().has_firmware() {
        return vec![source.board().name];
    }
    let boards = Board::ALL.into_iter().filter(Board::has_firmware);
    let boards = boards.filter(|board| lacks(source, *board, Lang::En).is_none());
    boards.map(|board| board.name).collect()
}

/// The program of a text that has one.
fn made(source: &Source, analysis: &Analysis) -> Made {
    let places = source.map.steps.iter();
    let map = places.map(|place| [place.line as u32, *place.codes.start(), *place.codes.end()]);
    let held_by = held_by(source);
    let first = Board::ALL.into_iter().find(Board::has_firmware);
    let lacking = |board| both(|lang| lacks(source, board, lang).unwrap_or_default());
    Made {
        lacking: first.filter(|_| held_by.is_empty()).map(lacking),
        held_by,
        symbols: analysis.symbols().cloned().unwrap_or_default(),
        map: map.collect(),
        size: Size {
            stored: source.size.stored_bytes,
            all: source.board().stored_bytes,
        },
        uses: Uses::of(source),
        kept: Kept::of(source.program()).into(),
        unsent: not_sent(source, Lang::En)
            .map(|_| both(|lang| not_sent(source, lang).unwrap_or_default())),
        code: String::from_utf8_lossy(&source.file()).into_owned(),
    }
}
