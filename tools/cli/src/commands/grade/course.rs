//! The exercises that a class is graded in: one, or those of a folder.

use super::super::plant::machine;
use crate::messages;
use anyhow::{anyhow, bail};
use std::fs;
use std::path::Path;
use unoclp_core::Board;
use unoclp_exercise::scenario::{Exercise, LONGEST};
use unoclp_plant::Plant;
use unoclp_program::shown;

/// No folder has more exercises.
const MOST: usize = 1000;

/// An exercise with its machine.
pub struct Task {
    /// Its path in the folder, without the end of its name: by this the page calls it.
    pub key: String,
    /// What it asks.
    pub exercise: Exercise,
    /// The machine that a program controls.
    pub plant: Option<Plant>,
}

/// All exercises of a class.
pub struct Course {
    /// At least one.
    pub tasks: Vec<Task>,
    /// What is wrong with others of the folder, which were left out.
    pub mistakes: Vec<String>,
}

impl Course {
    /// That of an exercise, or of a folder of them. Nothing where the machine of the only one is wrong, which is reported.
    ///
    /// # Errors
    /// If the exercise is wrong, or the folder has none.
    pub fn load(path: &Path, board: Board) -> anyhow::Result<Option<Course>> {
        let mut course = Course {
            tasks: Vec::new(),
            mistakes: Vec::new(),
        };
        if path.is_dir() {
            course.walk(path, "", board);
            if course.tasks.is_empty() {
                let why = course.mistakes.first().cloned();
                bail!(why.unwrap_or_else(|| messages::no_exercises(shown(path))));
            }
            return Ok(Some(course));
        }
        let exercise = Exercise::load(path, board);
        let exercise = exercise.map_err(|error| anyhow!(error.text(messages::spoken())))?;
        let plant = match &exercise.plant {
            Some(path) => match machine(path, exercise.board)? {
                Some(plant) => Some(plant),
                None => return Ok(None),
            },
            None => None,
        };
        course.tasks.push(Task {
            key: stem(path),
            exercise,
            plant,
        });
        Ok(Some(course))
    }

    /// The only exercise; none where there are several.
    pub fn only(&self) -> Option<&Task> {
        match self.tasks.as_slice() {
            [task] => Some(task),
            _ => None,
        }
    }

    /// The exercise of this name. The page names those of a served folder `own/…`, and those of a file by that alone.
    pub fn named(&self, name: &str) -> Option<&Task> {
        let name = name.strip_prefix("own/").unwrap_or(name);
        let exact = self.tasks.iter().find(|task| task.key == name);
        let last = |path: &str| path.rsplit('/').next().map(str::to_owned);
        exact.or_else(|| {
            let mut alike = self
                .tasks
                .iter()
                .filter(|task| last(&task.key) == last(name));
            alike.next().filter(|_| alike.next().is_none())
        })
    }

    /// The exercises in a folder and those below it. A link to a folder may lead back, so none is followed.
    fn walk(&mut self, folder: &Path, under: &str, board: Board) {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        let mut entries: Vec<_> = entries.collect();
        entries.sort_by_key(fs::DirEntry::path);
        for entry in entries {
            let path = entry.path();
            if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
                let name = entry.file_name().to_string_lossy().into_owned();
                self.walk(&path, &format!("{under}{name}/"), board);
            } else if path.extension().is_some_and(|end| end == "toml") && !is_machine(&path) {
                if self.tasks.len() == MOST {
                    return;
                }
                match task(&path, format!("{under}{}", stem(&path)), board) {
                    Ok(task) => self.tasks.push(task),
                    Err(why) => self.mistakes.push(why),
                }
            }
        }
    }
}

/// An exercise of a folder, or the first mistake in it.
fn task(path: &Path, key: String, board: Board) -> Result<Task, String> {
    let speak = messages::spoken();
    let exercise = Exercise::load(path, board).map_err(|error| error.text(speak))?;
    let plant = exercise.plant.as_ref().map(|path| {
        let text = fs::read_to_string(path);
        let text = text.map_err(|why| messages::cannot_read(shown(path), messages::io(&why)))?;
        unoclp_plant::read(&text, exercise.board).map_err(|mistakes| {
            let first = mistakes.first();
            first.map_or_else(String::new, |one| one.text(&shown(path), speak))
        })
    });
    let plant = plant.transpose()?;
    Ok(Task {
        key,
        exercise,
        plant,
    })
}

/// Whether a file lists the parts of a machine.
fn is_machine(path: &Path) -> bool {
    let is_short = fs::metadata(path).is_ok_and(|there| there.len() <= LONGEST);
    let text = is_short.then(|| fs::read_to_string(path).ok()).flatten();
    text.is_some_and(|text| {
        text.lines()
            .any(|line| line.trim_start().starts_with("[[part]]"))
    })
}

fn stem(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}
