//! Reading scenario files.
//!
//! The file's words are first taken as they stand, each with its place in the file; what they say
//! is checked after that, so that every error names a line.

use super::keys::{FileKeys, Repeated, Slip, TextKey, TextPart, keys, slip};
use super::program::bytes;
use super::{Exercise, LONGEST, LoadError, ProgramFile, Scenario, Unreadable, Wrong};
use std::io::{self, ErrorKind};
use std::path::Path;
use toml::Spanned;
use unoclp_core::Board;
use unoclp_program::{Source, Written, shown};

impl Exercise {
    /// Reads a scenario file, but not the program that it names.
    ///
    /// # Errors
    /// What is wrong with it, and where.
    pub fn load(path: &Path, board: Board) -> Result<Exercise, LoadError> {
        with_keys(path, |name, keys, folder| {
            Exercise::of_keys(name, keys, folder, board)
        })
    }

    /// Reads the text of a scenario file, which goes by this name.
    ///
    /// # Errors
    /// What is wrong with it, and where.
    pub fn of_text(name: &str, source: &str, board: Board) -> Result<Exercise, LoadError> {
        let result =
            keys(source).and_then(|keys| Exercise::of_keys(name, &keys, Path::new(""), board));
        result.map_err(|slip| slip.in_file(name.to_owned(), source))
    }
}

impl Scenario {
    /// Reads a scenario file, and the program file that it names; one in Instruction List is compiled.
    ///
    /// # Errors
    /// What is wrong with it, and where; that it has several cases.
    pub fn load(path: &Path, board: Board) -> Result<Scenario, LoadError> {
        with_keys(path, |name, keys, folder| {
            let program = named_program(name, keys, folder, board)?;
            only(Exercise::of_keys(name, keys, folder, board)?, &program)
        })
    }

    /// Reads all cases of a scenario file, and the program file that it names.
    ///
    /// # Errors
    /// What is wrong with it, and where.
    pub fn load_all(path: &Path, board: Board) -> Result<Vec<Scenario>, LoadError> {
        with_keys(path, |name, keys, folder| {
            let program = named_program(name, keys, folder, board)?;
            Ok(Exercise::of_keys(name, keys, folder, board)?.scenarios(&program))
        })
    }

    /// Reads a scenario file to run it with this program, whichever it names, or none.
    ///
    /// # Errors
    /// What is wrong with it, and where; that it has several cases.
    pub fn load_for(
        path: &Path,
        program: ProgramFile,
        board: Board,
    ) -> Result<Scenario, LoadError> {
        with_keys(path, |name, keys, folder| {
            only(Exercise::of_keys(name, keys, folder, board)?, &program)
        })
    }
}

/// The case of a file that has one alone.
fn only(exercise: Exercise, program: &ProgramFile) -> Result<Scenario, Slip> {
    let mut scenarios = exercise.scenarios(program);
    match (scenarios.pop(), scenarios.len()) {
        (Some(scenario), 0) => Ok(scenario),
        (_, others) => {
            let count = others + 1;
            Err(slip(None, Wrong::SeveralCases { count }))
        }
    }
}

/// Reads the keys of a scenario file; `make` makes something of them, its name and its folder.
fn with_keys<T>(
    path: &Path,
    make: impl FnOnce(&str, &FileKeys, &Path) -> Result<T, Slip>,
) -> Result<T, LoadError> {
    let name = shown(path);
    let folder = path.parent().unwrap_or(Path::new(""));
    let (source, result) = match text(path) {
        Ok(source) => {
            let result = keys(&source).and_then(|keys| make(&name, &keys, folder));
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

/// The program that a scenario file of this name gives.
fn named_program(
    name: &str,
    keys: &FileKeys,
    folder: &Path,
    usual: Board,
) -> Result<ProgramFile, Slip> {
    let board = keys.board(usual)?;
    match (&keys.program, &keys.text) {
        (Some(path), None) => program_file(path, keys, folder, board),
        (None, Some(text)) => Ok(ProgramFile {
            name: format!("{name} (text)"),
            bytes: program_text(text)?,
        }),
        (Some(_), Some(text)) => Err(slip(Some(text.span()), Wrong::TwoPrograms)),
        (None, None) => Err(slip(None, Wrong::NoProgram)),
    }
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
    board: Board,
) -> Result<ProgramFile, Slip> {
    let file = folder.join(path.get_ref());
    let name = shown(&file);
    let bytes = bytes(&file).map_err(|why| {
        let name = name.clone();
        slip(Some(path.span()), Wrong::Program { name, why })
    })?;
    let written = Written::new(name.clone(), bytes, board);
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
