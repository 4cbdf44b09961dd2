//! A program with the text that it was written in.
//!
//! Owns what belongs together from here on: the text, the checked program, and the map from one to the other.
//! Must not know how the program was checked, nor how it runs.

use crate::Size;
use crate::seal::{Seal, sealed};
use crate::written_in::WrittenIn;
use std::collections::BTreeMap;
use unoclp_checked::{Checked, SourceMap};
use unoclp_core::isa::Opcode;
use unoclp_core::{Board, Fault, Program};
use unoclp_draw::{Ladder, Names};
use unoclp_lang::{Dialect, Holding, TextLanguage, Told, Trace, Variable};
use unoclp_point::Kind;
use unoclp_sfc::{Document as Chart, Origin};

/// A program that has been read, compiled and checked: only [`Written::check`](crate::Written::check) and its like make one.
#[derive(Debug)]
#[non_exhaustive]
pub struct Source {
    /// What it is called.
    pub name: String,
    /// What a person reads and changes.
    pub text: String,
    /// The same as numeric code, as it stands on a card.
    pub code: Vec<u8>,
    /// What the text is written in.
    pub language: Language,
    /// How much of the board it takes.
    pub size: Size,
    /// Where its steps stand in the text.
    pub map: SourceMap,
    /// Its variables, where its language declares them with types.
    pub variables: Vec<Variable>,
    /// What its lines show of a scan, where its language has statements.
    pub traces: Vec<Trace>,
    /// Its charts.
    pub charts: Vec<Chart>,
    /// What of each chart each step of the program comes from.
    pub origins: Vec<Vec<Option<Origin>>>,
    /// The program.
    pub checked: Checked,
}

/// What a text is written in.
#[derive(Clone, Debug)]
pub enum Language {
    /// Numeric code.
    Numeric,
    /// Instruction List.
    Il {
        /// Whose it was taken to be.
        dialect: Dialect,
        /// What is worth a second look.
        warnings: Told,
    },
    /// A typed language: Structured Text, InterSCL, LCE.
    Typed {
        /// Which.
        language: TextLanguage,
        /// What is worth a second look.
        warnings: Told,
    },
    /// A project in PLCopen XML.
    Xml {
        /// What is worth a second look.
        warnings: Told,
    },
}

impl Language {
    /// The same by its name alone.
    pub fn written_in(&self) -> WrittenIn {
        match self {
            Language::Numeric => WrittenIn::Numeric,
            Language::Il { .. } => WrittenIn::Il,
            Language::Typed { language, .. } => WrittenIn::Typed(*language),
            Language::Xml { .. } => WrittenIn::Xml,
        }
    }

    /// What is worth a second look; nothing of numeric code.
    pub fn warnings(&self) -> Option<&Told> {
        match self {
            Language::Numeric => None,
            Language::Il { warnings, .. }
            | Language::Typed { warnings, .. }
            | Language::Xml { warnings } => Some(warnings),
        }
    }
}

impl Source {
    /// The program, to look at.
    pub fn program(&self) -> &Program<'_> {
        self.checked.program()
    }

    /// The board that it has been checked for.
    pub fn board(&self) -> Board {
        self.program().board()
    }

    /// Where a line of numeric code stands in the text, which the faults of a running program name: the line of the text,
    /// counted from 1, and what it says.
    pub fn line_of(&self, code: u32) -> Option<(usize, &str)> {
        let line = self.map.of_code(code)?.line;
        let text = self.text.lines().nth(line.checked_sub(1)?)?;
        Some((line, text.trim()))
    }

    /// The program file that a person keeps or puts on a card: the numeric code with its seal.
    pub fn file(&self) -> Vec<u8> {
        sealed(&self.code)
    }

    /// What the seal of a program file in numeric code says; no other text has one.
    pub fn seal(&self) -> Seal {
        match self.language {
            Language::Numeric => Seal::of(&self.code),
            _ => Seal::None,
        }
    }

    /// Whether its ladder is none that a person would draw: a compiler wrote it with instructions that only a compiler uses.
    pub fn is_code(&self) -> bool {
        let is_compiled = !matches!(self.language, Language::Numeric | Language::Il { .. });
        let is_code = |opcode| {
            use Opcode::{LoadTable, Push, StoreTable};
            matches!(opcode, Push | LoadTable | StoreTable)
        };
        is_compiled && self.program().steps().any(|step| is_code(step.opcode))
    }

    /// Whether it was written in a language that is compiled.
    pub fn is_text(&self) -> bool {
        !matches!(self.language, Language::Numeric)
    }
}

/// What a text calls the points of this ladder, whose steps stand in it so.
pub fn names(map: &SourceMap, ladder: &Ladder) -> Names {
    let mut names = Names::new();
    for element in &ladder.elements {
        let place = element.steps.last().and_then(|&step| map.steps.get(step));
        let name = place.and_then(|place| place.name.as_ref());
        if let (Some(point), Some(name)) = (element.point, name) {
            names.entry(point).or_insert_with(|| name.clone());
        }
    }
    names
}

/// What the text of a program calls its points: `lamp` after `Q1`.
pub fn point_names(source: &Source) -> BTreeMap<String, String> {
    let ladder = Ladder::new(source.program().steps());
    symbols(source, &names(&source.map, &ladder))
}

/// The same, where it is known what the symbols of its ladder are called.
pub fn symbols(source: &Source, names: &Names) -> BTreeMap<String, String> {
    let names = names.iter();
    let mut names: BTreeMap<String, String> = names
        .map(|(point, name)| (point.to_string(), name.clone()))
        .collect();
    for variable in &source.variables {
        let Holding::One((point, _)) = variable.holding else {
            continue;
        };
        if matches!(point.kind(), Kind::Register | Kind::Marker | Kind::System) {
            continue;
        }
        let point = point.to_string();
        // A timer and a counter are called as their block: `pause` of `pause.Q`.
        match variable.name.rsplit_once('.') {
            Some((block, _)) if point.starts_with(['T', 'C']) => {
                names.insert(point, block.to_owned());
            }
            _ => {
                names.entry(point).or_insert_with(|| variable.name.clone());
            }
        }
    }
    names
}

/// The program of a file in numeric code, for what shows neither its text nor all of its faults.
///
/// # Errors
/// The first fault of the file.
pub fn load(file: &[u8], board: Board) -> Result<Checked, Fault> {
    Checked::read(file, board)
}
