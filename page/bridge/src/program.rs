//! A text as a person has written it, and what there is to show of it.
//!
//! Owns what a page is told of a program as a whole. Must not know how it is drawn or run.

use crate::facts;
use crate::given::Given;
#[cfg(not(feature = "full"))]
use crate::start::Known;
use crate::tell::{Problem, colours, problems, warnings};
use crate::words::{self, Both, No, both};
use serde::Serialize;
use std::collections::BTreeMap;
use unoclp_client::diagnostics::Kept;
use unoclp_core::{Board, Delay};
#[cfg(feature = "full")]
use unoclp_lang::declared;
use unoclp_program::used::Used;
use unoclp_program::{
    Lang, Language, Refused, Seal, Source, Written, WrittenIn, lacks, not_sent, point_names,
};

/// The longest text that is looked at, bytes.
pub const LONGEST: usize = 1 << 20;

/// A text, and what it is called.
#[derive(Clone, Debug)]
pub struct Text {
    /// The name of its file, whose end says its language.
    pub name: String,
    /// What it says.
    pub text: String,
    /// The board that it is for.
    pub board: Board,
}

/// What there is to say of a text.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Checked {
    /// `il`, `st`, `scl`, `iscl`, `lce`, `numeric`; empty for a text in none of them.
    language: &'static str,
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

/// What has become of a text.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Made {
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

/// How much of the board it takes: bytes, each of so many.
#[derive(Debug, Serialize)]
struct Size {
    codes: u16,
    stored: [usize; 2],
    linked: [usize; 2],
    text: Both,
}

/// The numbers that it names.
#[derive(Clone, Debug, Serialize)]
pub struct Uses {
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

/// How a board keeps a program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Stored {
    version: u8,
    bytes: u16,
    sum: u16,
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
            reals: list(reals),
            counters: list(counters),
            timers: timers
                .filter_map(|step| Delay::of(step.opcode).map(Delay::letters))
                .collect(),
        }
    }
}

/// What is known of the program that a page begins with, if this is it.
#[cfg(not(feature = "full"))]
fn start(written: &Written) -> Option<Known> {
    let text = std::str::from_utf8(&written.bytes).ok()?;
    let is_list = written.language == Ok(WrittenIn::Il);
    is_list.then(|| crate::start::known(text)).flatten()
}

impl Text {
    /// As a request gives it.
    ///
    /// # Errors
    /// Where it gives none.
    pub fn of(given: &mut Given) -> Result<Text, Both> {
        Ok(Text {
            name: given.text("name")?,
            text: given.text("text")?,
            board: facts::board(given)?,
        })
    }

    /// Compiles and checks it.
    ///
    /// # Errors
    /// What is wrong with it; the outer one where nobody looks at it.
    pub fn open(self) -> Result<Result<Source, Refused>, No> {
        if self.text.len() > LONGEST {
            return Err(both(|lang| words::too_long(lang, LONGEST)).into());
        }
        let written = Written::new(self.name, self.text.into_bytes(), self.board);
        #[cfg(feature = "full")]
        return Ok(written.check(None));
        #[cfg(not(feature = "full"))]
        return match start(&written) {
            Some(start) => Ok(Ok(written
                .known(&start.code, start.map)
                .map_err(|_| No::More)?)),
            None => written.check_numeric().ok_or(No::More),
        };
    }

    /// Its coloured parts, as [`Checked`] has them.
    fn colours(&self) -> Vec<u32> {
        if self.text.len() > LONGEST {
            return Vec::new();
        }
        let bytes = self.text.clone().into_bytes();
        let written = Written::new(self.name.clone(), bytes, self.board);
        #[cfg(feature = "full")]
        let parts = written.colours();
        #[cfg(not(feature = "full"))]
        let parts = match start(&written) {
            Some(start) => return start.colours,
            None => written.colours_numeric(),
        };
        colours(&self.text, &parts)
    }

    /// Whether this module compiles its language.
    ///
    /// # Errors
    /// [`No::More`] where it does not.
    pub fn needs_no_more(&self) -> Result<(), No> {
        #[cfg(not(feature = "full"))]
        {
            let bytes = self.text.clone().into_bytes();
            let written = Written::new(self.name.clone(), bytes, self.board);
            let is_compiled = written.is_text() && start(&written).is_none();
            if is_compiled {
                return Err(No::More);
            }
        }
        Ok(())
    }

    /// Whether no instruction stands in it yet: one can draw the first.
    pub fn is_blank(&self) -> bool {
        #[cfg(feature = "full")]
        let declares = || {
            let is_list = self.name.to_ascii_lowercase().ends_with(".il");
            is_list && self.text.len() <= LONGEST && declared(&self.text).is_blank
        };
        // What else the module knows has instructions.
        #[cfg(not(feature = "full"))]
        let declares = || false;
        self.text.trim().is_empty() || declares()
    }

    /// The program, where there is one.
    ///
    /// # Errors
    /// That there is none.
    pub fn program(self) -> Result<Source, No> {
        self.open()?.map_err(|_| both(words::faulty).into())
    }
}

/// Says what there is to say of a text.
///
/// # Errors
/// That it is too long to be looked at.
pub fn check(text: Text) -> Result<Checked, No> {
    let guessed = WrittenIn::of(text.name.as_ref(), text.text.as_bytes());
    let written = text.text.clone();
    let blank = text.is_blank();
    let colours = text.colours();
    Ok(match text.open()? {
        Ok(source) => {
            let (problems, more) = warnings(&source);
            Checked {
                language: language(&source.language),
                problems,
                more,
                colours,
                // What is cut off is no program that anybody has written.
                program: (source.seal() != Seal::Cut).then(|| made(source)),
                blank,
            }
        }
        Err(refused) => {
            let (problems, more) = problems(&written, &refused);
            Checked {
                language: guessed.map_or("", WrittenIn::name),
                problems,
                more,
                colours,
                program: None,
                blank,
            }
        }
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

fn made(source: Source) -> Made {
    let places = source.map.steps.iter();
    let map = places.map(|place| [place.line as u32, *place.codes.start(), *place.codes.end()]);
    let held_by = held_by(&source);
    let first = Board::ALL.into_iter().find(Board::has_firmware);
    let lacking = |board| both(|lang| lacks(&source, board, lang).unwrap_or_default());
    Made {
        lacking: first.filter(|_| held_by.is_empty()).map(lacking),
        held_by,
        symbols: point_names(&source),
        map: map.collect(),
        size: Size {
            codes: source.size.codes,
            stored: [source.size.stored_bytes, source.board().stored_bytes.into()],
            linked: [source.size.linked_bytes, source.board().linked_bytes.into()],
            text: both(|lang| source.size.text(lang)),
        },
        uses: Uses::of(&source),
        kept: Kept::of(source.program()).into(),
        unsent: not_sent(&source, Lang::En)
            .map(|_| both(|lang| not_sent(&source, lang).unwrap_or_default())),
        code: String::from_utf8_lossy(&source.file()).into_owned(),
    }
}
