//! Which files are programs of a class.

use super::handin::is_hand_in;
use crate::messages;
use anyhow::{anyhow, bail};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use unoclp_program::{WrittenIn, shown};

/// What a class has handed in.
#[derive(Debug, Default)]
pub struct Found {
    /// The programs, those of a folder in the order of their names.
    pub programs: Vec<PathBuf>,
    /// Files of folders that are not called like a program.
    pub left_out: Vec<PathBuf>,
    /// Folders and files of folders that cannot be looked at, and why.
    pub unreadable: Vec<(PathBuf, String)>,
}

/// The files that were named, and those below folders.
///
/// # Errors
/// If one is not there, or a folder has no program.
pub fn find(named: &[PathBuf]) -> anyhow::Result<Found> {
    let mut found = Found::default();
    for path in named {
        let there = fs::metadata(path).map_err(cannot_read(path))?;
        if !there.is_dir() {
            found.programs.push(path.clone());
            continue;
        }
        let before = found.programs.len();
        walk(path, &mut found);
        if found.programs.len() == before && found.unreadable.is_empty() {
            bail!(messages::no_programs(shown(path), messages::languages()));
        }
    }
    Ok(found)
}

/// What is in a folder and those below it. A link to a folder may lead back, so none is followed.
fn walk(folder: &Path, found: &mut Found) {
    let entries = fs::read_dir(folder).and_then(|entries| entries.collect::<io::Result<Vec<_>>>());
    let mut entries = match entries {
        Ok(entries) => entries,
        Err(error) => {
            let why = why(folder, &error);
            found.unreadable.push((folder.to_owned(), why));
            return;
        }
    };
    entries.sort_by_key(fs::DirEntry::path);
    for entry in entries {
        let path = entry.path();
        let kind = match entry.file_type() {
            Ok(kind) => kind,
            Err(error) => {
                let why = why(&path, &error);
                found.unreadable.push((path, why));
                continue;
            }
        };
        if kind.is_dir() {
            walk(&path, found);
        } else if !entry.file_name().as_encoded_bytes().starts_with(b".") && !path.is_dir() {
            match is_program(&path) || is_hand_in(&path) {
                true => found.programs.push(path),
                false => found.left_out.push(path),
            }
        }
    }
}

/// Whether a file is called like a program.
fn is_program(path: &Path) -> bool {
    let numeric = path
        .extension()
        .is_some_and(|end| end.eq_ignore_ascii_case("txt"));
    numeric || WrittenIn::of_name(path).is_some()
}

fn cannot_read(path: &Path) -> impl Fn(io::Error) -> anyhow::Error {
    move |error| anyhow!(why(path, &error))
}

/// That it cannot be read, and why.
fn why(path: &Path, error: &io::Error) -> String {
    messages::cannot_read(shown(path), messages::io(error))
}
