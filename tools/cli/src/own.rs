//! A teacher's folder: its exercises and machines are in the page before those that it has anyway. A file is read and checked
//! again only where it has changed.
//!
//! Owns which files of the folder are what, and the form in which the page takes them. Must not know who serves them.

use crate::messages;
use anyhow::anyhow;
use serde::Serialize;
use serde_json::Value;
use std::borrow::Cow;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::SystemTime;
use unoclp_core::Board;
use unoclp_exercise::scenario::Exercise;
use unoclp_plant::{Plant, Text};
use unoclp_program::shown;

/// The page takes no longer file, bytes.
const LONGEST: u64 = 1 << 20;
/// Nor more of them.
const MOST: usize = 500;

/// The folder of a teacher.
#[derive(Clone, Debug)]
pub struct Own {
    folder: PathBuf,
    /// What its programs are for, where a machine names no other.
    board: Board,
    /// What was found in it last.
    kept: Arc<Mutex<Arc<Found>>>,
}

/// What is in it, as far as its files are the same.
#[derive(Debug, Default)]
struct Found {
    /// The files that say exercises and machines.
    files: Vec<PathBuf>,
    /// All files that were read, and how they were then.
    read: Vec<(PathBuf, Option<Stamp>)>,
    exercises: Vec<Value>,
    machines: Vec<Value>,
    mistakes: Vec<String>,
}

/// By what a file is known to be the same: its size and the time of its last change.
type Stamp = (u64, SystemTime);

#[derive(Serialize)]
struct Named<'a> {
    name: &'a str,
    text: &'a str,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct OwnExercise<'a> {
    name: String,
    language: &'a str,
    scenario: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    plant: Option<Named<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    program: Option<Named<'a>>,
    is_own: bool,
}

#[derive(Serialize)]
struct Both<'a> {
    en: &'a str,
    pt: &'a str,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct OwnMachine<'a> {
    name: &'a str,
    text: &'a str,
    title: Both<'a>,
    about: Both<'a>,
    is_own: bool,
}

impl<'a> From<&'a Text> for Both<'a> {
    fn from(Text { en, pt }: &'a Text) -> Both<'a> {
        Both { en, pt }
    }
}

impl Own {
    /// This folder. Says what it has, and what is wrong with its files: those are left out.
    ///
    /// # Errors
    /// Where it cannot be read.
    pub fn open(folder: &Path, board: Board) -> anyhow::Result<Own> {
        let wrong = |error| anyhow!(messages::cannot_read(shown(folder), messages::io(&error)));
        fs::read_dir(folder).map_err(wrong)?;
        let own = Own {
            folder: folder.to_owned(),
            board,
            kept: Arc::default(),
        };
        let found = own.found();
        for mistake in &found.mistakes {
            anstream::eprintln!("{mistake}");
        }
        let (exercises, machines) = (found.exercises.len(), found.machines.len());
        anstream::eprintln!("{}", messages::own(shown(folder), exercises, machines));
        Ok(own)
    }

    /// A file of the page with what is this folder's in it, as it is now.
    pub fn among(&self, path: &str, file: Cow<'static, [u8]>) -> Cow<'static, [u8]> {
        let own = match path {
            "exercises.json" => self.found().exercises.clone(),
            "machines.json" => self.found().machines.clone(),
            _ => return file,
        };
        let Ok(others) = serde_json::from_slice::<Vec<Value>>(&file) else {
            return file;
        };
        let all: Vec<Value> = own.into_iter().chain(others).collect();
        serde_json::to_vec(&all).map_or(file, Cow::Owned)
    }

    /// What is in it now: read and checked again where a file has changed.
    fn found(&self) -> Arc<Found> {
        let files = self.files();
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if kept.files != files || !kept.is_same() {
            *kept = Arc::new(self.read(files));
        }
        kept.clone()
    }

    /// The files that say exercises and machines.
    fn files(&self) -> Vec<PathBuf> {
        let entries = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        let mut files: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
        files.retain(|file| {
            let end = file.extension().and_then(|end| end.to_str());
            end.is_some_and(|end| end.eq_ignore_ascii_case("toml"))
        });
        files.sort();
        files.truncate(MOST);
        files
    }

    fn read(&self, files: Vec<PathBuf>) -> Found {
        let mut found = Found::default();
        for file in &files {
            match found.text(file) {
                Ok(text) if is_machine(&text) => found.machine(file, &text, self.board),
                Ok(text) => found.exercise(self, file, &text),
                Err(why) => found.mistakes.push(why),
            }
        }
        found.files = files;
        found
    }
}

impl Found {
    /// Whether all files are as they were read.
    fn is_same(&self) -> bool {
        self.read.iter().all(|(file, was)| stamp(file) == *was)
    }

    /// The text of a file, or why there is none.
    fn text(&mut self, file: &Path) -> Result<String, String> {
        self.read.push((file.to_owned(), stamp(file)));
        text(file)
    }

    fn machine(&mut self, file: &Path, text: &str, board: Board) {
        match plant(file, text, board) {
            Ok(plant) => self.machines.extend(serde_json::to_value(OwnMachine {
                name: &name(file),
                text,
                title: (&plant.title).into(),
                about: (&plant.about).into(),
                is_own: true,
            })),
            Err(why) => self.mistakes.push(why),
        }
    }

    fn exercise(&mut self, Own { folder, board, .. }: &Own, file: &Path, scenario: &str) {
        let exercise = match Exercise::of_text(&shown(file), scenario, *board) {
            Ok(exercise) => exercise,
            Err(error) => return self.mistakes.push(error.text(messages::spoken())),
        };
        let mut beside = |path: &PathBuf| {
            let path = folder.join(path);
            self.text(&path).map(|text| (name(&path), text))
        };
        let machine = exercise.plant.as_ref().map(|path| {
            let (name, text) = beside(path)?;
            plant(&folder.join(path), &text, exercise.board)?;
            Ok((name, text))
        });
        // Where a fault is to be found, the program is right and given; else it is the solution.
        let program = exercise
            .program
            .as_ref()
            .filter(|_| exercise.find.is_some());
        let (machine, program) = match (machine.transpose(), program.map(&mut beside).transpose()) {
            (Ok(machine), Ok(program)) => (machine, program),
            (Err(why), _) | (_, Err(why)) => return self.mistakes.push(why),
        };
        let language = exercise.program.as_deref().and_then(Path::extension);
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        self.exercises.extend(serde_json::to_value(OwnExercise {
            name: format!("own/{stem}"),
            language: language.and_then(|end| end.to_str()).unwrap_or("il"),
            scenario,
            plant: machine.as_ref().map(|(name, text)| Named { name, text }),
            program: program.as_ref().map(|(name, text)| Named { name, text }),
            is_own: true,
        }));
    }
}

/// How a file is now; none where there is none.
fn stamp(file: &Path) -> Option<Stamp> {
    let about = fs::metadata(file).ok()?;
    Some((about.len(), about.modified().ok()?))
}

/// Whether a text says parts of a machine.
fn is_machine(text: &str) -> bool {
    text.lines()
        .any(|line| line.trim_start().starts_with("[[part]]"))
}

fn name(file: &Path) -> String {
    let name = file.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

/// The text of a file, or why there is none.
fn text(file: &Path) -> Result<String, String> {
    let wrong = |error| messages::cannot_read(shown(file), messages::io(&error));
    let about = fs::metadata(file).map_err(wrong)?;
    if !about.is_file() || about.len() > LONGEST {
        return Err(messages::own_too_long(shown(file), LONGEST));
    }
    fs::read_to_string(file).map_err(wrong)
}

/// The machine of a file, or the first mistake in it.
fn plant(file: &Path, text: &str, board: Board) -> Result<Plant, String> {
    let plant = unoclp_plant::read(text, board);
    plant.map_err(|mistakes| {
        let told = mistakes.first();
        told.map_or_else(String::new, |told| {
            told.text(&shown(file), messages::spoken())
        })
    })
}
