//! The students that the rows belong to.
//!
//! Owns how students are distinguished. Must not know what a row is worth.

use super::row::Row;
use std::path::Path;

/// What is in the name of a folder in which Moodle hands out what was handed in: `Ana Lima_4711_assignsubmission_file`.
const MOODLE: &str = "_assignsubmission_";

/// A student, as far as files tell.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Who {
    /// As Moodle numbers them in an assignment; empty where it has not handed out the file.
    pub identifier: String,
    /// Their name; of a program that says none, the name of its file.
    pub name: String,
    /// The number or the address by which their school knows them; empty where they gave none.
    pub number: String,
}

/// Each student with all that they have handed in, in the order of the rows.
pub fn students<'r, 'c>(rows: &'r [Row<'c>]) -> Vec<(Who, Vec<&'r Row<'c>>)> {
    let mut all: Vec<(Who, Vec<&Row<'_>>)> = Vec::new();
    for row in rows {
        let who = who(row);
        match all.iter_mut().find(|(other, _)| other.is_same(&who)) {
            Some((_, own)) => own.push(row),
            None => all.push((who, vec![row])),
        }
    }
    all
}

impl Who {
    /// By what is surest: Moodle's number, the school's, the name.
    fn is_same(&self, other: &Who) -> bool {
        let surest = |who: &Who| {
            let all = [&who.identifier, &who.number, &who.name];
            all.into_iter().position(|text| !text.is_empty())
        };
        let text =
            |who: &Who| [&who.identifier, &who.number, &who.name].map(|it| it.to_lowercase());
        match (surest(self), surest(other)) {
            (Some(one), Some(another)) => one == another && text(self)[one] == text(other)[one],
            _ => false,
        }
    }
}

fn who(row: &Row<'_>) -> Who {
    let path = Path::new(&row.file);
    let folders = path.iter().filter_map(|part| part.to_str());
    let moodle = folders.rev().find_map(|part| {
        let (who, _) = part.split_once(MOODLE)?;
        let (name, number) = who.rsplit_once('_')?;
        Some((name.to_owned(), number.to_owned()))
    });
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let (named, identifier) = moodle.unwrap_or_else(|| (stem.into_owned(), String::new()));
    let student = row.student.as_ref();
    Who {
        // What Moodle says is surer than what a file says of itself.
        name: match (identifier.is_empty(), student) {
            (true, Some(student)) => student.name.clone(),
            _ => named,
        },
        identifier,
        number: student.map_or(String::new(), |it| it.number.clone()),
    }
}
