//! The file: what comes back of what was written, whatever clocks and files do.

use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;
use unoclp_history::{Failure, Query, Row, Sample, Store, csv};

struct Folder(TempDir);

impl Folder {
    fn new() -> Folder {
        Folder(tempfile::tempdir().unwrap())
    }

    fn file(&self) -> PathBuf {
        self.0.path().join("history.db")
    }
}

fn sample(at: i64, value: impl Into<Option<f64>>) -> Sample {
    Sample {
        board: "estufa".into(),
        point: "level".into(),
        at,
        value: value.into(),
    }
}

fn query(from: i64, to: i64, step: i64) -> Query {
    Query {
        board: "estufa".into(),
        point: "level".into(),
        from,
        to,
        step,
        most: usize::MAX,
    }
}

fn row(at: i64, least: f64, most: f64, last: impl Into<Option<f64>>) -> Row {
    Row {
        at,
        least: Some(least),
        most: Some(most),
        last: last.into(),
    }
}

#[test]
fn changes_come_back_and_steps_of_them() {
    let folder = Folder::new();
    let mut store = Store::open(&folder.file()).unwrap();
    let samples = [(5, 1.0), (10, 2.0), (12, -3.0), (25, 4.0), (40, 5.0)];
    store
        .append(&samples.map(|(at, value)| sample(at, value)))
        .unwrap();
    store
        .append(&[
            sample(30, None),
            Sample {
                board: "x".into(),
                ..sample(11, 9.0)
            },
        ])
        .unwrap();
    let rows = |from, to, step| store.rows(&query(from, to, step)).unwrap();
    let [one, none] = [
        row(10, 2.0, 2.0, 2.0),
        Row {
            at: 30,
            least: None,
            most: None,
            last: None,
        },
    ];
    assert_eq!(
        rows(10, 31, 0),
        [
            row(10, 1.0, 1.0, 1.0),
            one,
            row(12, -3.0, -3.0, -3.0),
            row(25, 4.0, 4.0, 4.0),
            none
        ]
    );
    assert_eq!(
        rows(8, 50, 10),
        [
            row(8, -3.0, 2.0, -3.0),
            row(18, 4.0, 4.0, 4.0),
            Row {
                at: 28,
                least: None,
                most: None,
                last: None
            },
            row(38, 5.0, 5.0, 5.0)
        ]
    );
    assert_eq!(rows(5, 20, 100), [row(5, -3.0, 2.0, -3.0)]);
    assert_eq!(rows(100, 200, 10), [row(100, 5.0, 5.0, 5.0)]);
    assert_eq!(rows(0, 5, 10), []);
    let most = Query {
        most: 2,
        ..query(10, 31, 0)
    };
    assert_eq!(store.rows(&most).unwrap().len(), 2);
    assert_eq!(
        store.points().unwrap(),
        [
            ("estufa".into(), "level".into()),
            ("x".into(), "level".into())
        ]
    );
    let unknown = Query {
        point: "flow".into(),
        ..query(0, 100, 0)
    };
    assert_eq!(store.rows(&unknown).unwrap(), []);
    assert_eq!(
        csv(&rows(28, 50, 10)),
        "time,least,most,last\n1970-01-01T00:00:00.028Z,4,4,\n1970-01-01T00:00:00.038Z,5,5,5\n"
    );
}

#[test]
fn a_clock_that_is_set_back_loses_nothing() {
    let folder = Folder::new();
    let mut store = Store::open(&folder.file()).unwrap();
    for (at, value) in [(100, 1.0), (200, 2.0), (100, 3.0), (100, 4.0), (150, 5.0)] {
        store.append(&[sample(at, value)]).unwrap();
    }
    let rows = store.rows(&query(0, 1000, 0)).unwrap();
    let values: Vec<f64> = rows.iter().filter_map(|row| row.last).collect();
    assert_eq!(values, [1.0, 3.0, 4.0, 5.0, 2.0]);
}

#[test]
fn a_file_of_something_else_is_left_as_it_is() {
    let folder = Folder::new();
    let refused = |path: &Path| {
        let before = fs::read(path).unwrap();
        let [open, read] =
            [Store::open(path), Store::read(path)].map(|opened| opened.err().unwrap());
        assert_eq!(fs::read(path).unwrap(), before);
        assert_eq!(format!("{open:?}"), format!("{read:?}"));
        open
    };
    let path = folder.file();
    drop(Store::open(&path).unwrap());
    let other = rusqlite::Connection::open(&path).unwrap();
    other.pragma_update(None, "user_version", 2).unwrap();
    drop(other);
    assert!(matches!(refused(&path), Failure::Version(2)));
    let foreign = folder.0.path().join("foreign.db");
    rusqlite::Connection::open(&foreign)
        .unwrap()
        .execute_batch("CREATE TABLE t (x)")
        .unwrap();
    assert!(matches!(refused(&foreign), Failure::Foreign));
    let text = folder.0.path().join("text.db");
    fs::write(
        &text,
        "my notes, long enough for a head of a file".repeat(9),
    )
    .unwrap();
    assert!(matches!(refused(&text), Failure::Foreign));
    assert!(Store::open(&folder.0.path().join("none/h.db")).is_err());
    assert!(Store::read(&folder.0.path().join("none.db")).is_err());
}

#[test]
fn what_is_read_beside_a_writer_is_what_it_has_committed() {
    let folder = Folder::new();
    let mut writer = Store::open(&folder.file()).unwrap();
    let reader = Store::read(&folder.file()).unwrap();
    for count in 1..20_usize {
        writer
            .append(&[sample(count as i64, count as f64)])
            .unwrap();
        assert_eq!(reader.rows(&query(0, 100, 0)).unwrap().len(), count);
    }
}

/// A number from 0 to below `of`.
fn random(state: &mut u64, of: u64) -> u64 {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*state >> 33) % of
}

const HOUR: i64 = 3_600_000;

#[test]
fn random_samples_are_thinned_and_the_hours_stay_the_same() {
    let mut state = 7;
    let mut thinned_something = false;
    for round in 0..6 {
        let folder = Folder::new();
        let mut store = Store::open(&folder.file()).unwrap();
        let mut at = 0;
        for _ in 0..20 {
            let samples: Vec<Sample> = (0..random(&mut state, 120))
                .map(|_| {
                    at += random(&mut state, 200_000) as i64;
                    // Now and then the clock is set back, and the board is away.
                    if random(&mut state, 50) == 0 {
                        at -= HOUR / 2;
                    }
                    let value = random(&mut state, 9) as f64 - 4.0;
                    sample(at, (random(&mut state, 20) > 0).then_some(value))
                })
                .collect();
            store.append(&samples).unwrap();
        }
        let hours = query(-HOUR, at + HOUR, HOUR);
        let count = |store: &Store| store.rows(&query(-HOUR, at + HOUR, 0)).unwrap().len();
        let (before, samples) = (store.rows(&hours).unwrap(), count(&store));
        for (now, keep) in [(at / 2, HOUR), (at, HOUR), (at, HOUR / 4), (at, 0)] {
            while store.thin(now, keep).unwrap() {}
            assert_eq!(store.rows(&hours).unwrap(), before, "round {round}");
        }
        thinned_something |= count(&store) < samples / 4;
    }
    assert!(thinned_something);
}
