//! A file of SQLite.

use crate::store;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;
use unoclp_history::{Failure, Query, Sample, Sqlite, Store};
use unoclp_journal::Entry;

struct Folder(TempDir);

impl Folder {
    fn new() -> Folder {
        Folder(tempfile::tempdir().unwrap())
    }

    fn file(&self) -> PathBuf {
        self.0.path().join("history.db")
    }
}

fn each(check: impl Fn(&mut dyn Store)) {
    let folder = Folder::new();
    check(&mut Sqlite::open(&folder.file()).unwrap());
}

#[test]
fn changes_come_back_and_steps_of_them() {
    each(store::changes_come_back_and_steps_of_them);
}

#[test]
fn a_clock_that_is_set_back_loses_nothing() {
    each(store::a_clock_that_is_set_back_loses_nothing);
}

#[test]
fn each_entry_is_taken_once() {
    each(store::each_entry_is_taken_once);
}

#[test]
fn random_samples_are_thinned_and_the_hours_stay_the_same() {
    (0..6).for_each(|seed| each(|store| store::thinned(store, seed)));
}

#[test]
fn a_file_of_something_else_is_left_as_it_is() {
    let folder = Folder::new();
    let refused = |path: &Path| {
        let before = fs::read(path).unwrap();
        let [open, read] =
            [Sqlite::open(path), Sqlite::read(path)].map(|opened| opened.err().unwrap());
        assert_eq!(fs::read(path).unwrap(), before);
        assert_eq!(open, read);
        open
    };
    let path = folder.file();
    drop(Sqlite::open(&path).unwrap());
    let other = rusqlite::Connection::open(&path).unwrap();
    other.pragma_update(None, "user_version", 4).unwrap();
    drop(other);
    assert_eq!(refused(&path), Failure::Version(4));
    let foreign = folder.0.path().join("foreign.db");
    rusqlite::Connection::open(&foreign)
        .unwrap()
        .execute_batch("CREATE TABLE t (x)")
        .unwrap();
    assert_eq!(refused(&foreign), Failure::Foreign);
    let text = folder.0.path().join("text.db");
    fs::write(
        &text,
        "my notes, long enough for a head of a file".repeat(9),
    )
    .unwrap();
    assert_eq!(refused(&text), Failure::Foreign);
    assert!(Sqlite::open(&folder.0.path().join("none/h.db")).is_err());
    assert!(Sqlite::read(&folder.0.path().join("none.db")).is_err());
}

#[test]
fn a_file_of_the_version_before_is_brought_to_this_one_and_keeps_all() {
    let folder = Folder::new();
    let path = folder.file();
    drop(Sqlite::open(&path).unwrap());
    let before = rusqlite::Connection::open(&path).unwrap();
    let back = "DROP TABLE taken; DROP TABLE recent; PRAGMA user_version = 1;
        INSERT INTO point VALUES (1, 'estufa', 'level'); INSERT INTO sample VALUES (1, 5, 0, 7.5); UPDATE next SET seq = 1;";
    before.execute_batch(back).unwrap();
    drop(before);
    let read = |store: &mut dyn Store| store.rows(&store::query(0, 100, 0)).unwrap();
    let all = [store::row(5, 7.5, 7.5, 7.5)];
    assert_eq!(read(&mut Sqlite::read(&path).unwrap()), all);
    let mut store = Sqlite::open(&path).unwrap();
    assert_eq!(store.taken("s"), Ok(None));
    store.take("s", &[store::entry(1, 6, 8.0)]).unwrap();
    assert_eq!(
        read(&mut store),
        [all[0].clone(), store::row(6, 8.0, 8.0, 8.0)]
    );
}

#[test]
fn what_is_read_beside_a_writer_is_what_it_has_committed() {
    let folder = Folder::new();
    let mut writer = Sqlite::open(&folder.file()).unwrap();
    let mut reader = Sqlite::read(&folder.file()).unwrap();
    for count in 1..20_usize {
        writer
            .append(&[store::sample(count as i64, count as f64)])
            .unwrap();
        assert_eq!(reader.rows(&store::query(0, 100, 0)).unwrap().len(), count);
    }
}

#[test]
fn of_many_samples_each_stands_in_its_place_once() {
    let folder = Folder::new();
    let mut store = Sqlite::open(&folder.file()).unwrap();
    let mut reader = Sqlite::read(&folder.file()).unwrap();
    let names = ["level", "flow", "heat"];
    let all = 150_000_u64;
    // Of each point one after the other, and now and then an hour back.
    let at = |number: u64| number as i64 * 10 - if number % 7_000 < 3 { 3_600_000 } else { 0 };
    let sample = |number: u64| Sample {
        point: names[number as usize % names.len()].into(),
        ..store::sample(at(number), number as f64)
    };
    for first in (0..all).step_by(9_000) {
        let numbers = first..(first + 9_000).min(all);
        let entry = |number| Entry {
            number: number + 1,
            sample: sample(number),
        };
        let entries: Vec<Entry> = numbers.clone().map(entry).collect();
        store.take("s", &entries).unwrap();
        for (of, name) in names.iter().enumerate() {
            let query = Query {
                point: (*name).into(),
                ..store::query(i64::MIN, i64::MAX, 0)
            };
            let found = reader.rows(&query).unwrap();
            let values: Vec<u64> = found.iter().map(|row| row.last.unwrap() as u64).collect();
            let mut expected: Vec<u64> = (0..numbers.end)
                .filter(|number| *number as usize % names.len() == of)
                .collect();
            expected.sort_by_key(|number| (at(*number), *number));
            assert!(values == expected, "{name} after {}", numbers.end);
        }
    }
    assert_eq!(store.taken("s"), Ok(Some(all)));
}
