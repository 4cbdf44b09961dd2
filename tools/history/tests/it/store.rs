//! What is asked of every history, wherever it is kept.

use unoclp_history::{Query, Row, Sample, Store, csv};
use unoclp_journal::Entry;

pub fn sample(at: i64, value: impl Into<Option<f64>>) -> Sample {
    Sample {
        board: "estufa".into(),
        point: "level".into(),
        at,
        value: value.into(),
    }
}

pub fn entry(number: u64, at: i64, value: impl Into<Option<f64>>) -> Entry {
    Entry {
        number,
        sample: sample(at, value),
    }
}

pub fn query(from: i64, to: i64, step: i64) -> Query {
    Query {
        board: "estufa".into(),
        point: "level".into(),
        from,
        to,
        step,
        most: usize::MAX,
    }
}

pub fn row(at: i64, least: f64, most: f64, last: impl Into<Option<f64>>) -> Row {
    Row {
        at,
        least: Some(least),
        most: Some(most),
        last: last.into(),
    }
}

/// Takes these on from what was taken.
fn take(store: &mut dyn Store, samples: Vec<Sample>) {
    let before = store.taken("test").unwrap().unwrap_or(0);
    let numbers = before + 1..;
    let entries: Vec<Entry> = numbers
        .zip(samples)
        .map(|(number, sample)| Entry { number, sample })
        .collect();
    store.take("test", &entries).unwrap();
}

pub fn changes_come_back_and_steps_of_them(store: &mut dyn Store) {
    let samples = [(5, 1.0), (10, 2.0), (12, -3.0), (25, 4.0), (40, 5.0)];
    take(store, samples.map(|(at, value)| sample(at, value)).into());
    let other = Sample {
        board: "x".into(),
        ..sample(11, 9.0)
    };
    take(store, vec![sample(30, None), other]);
    let mut rows = |from, to, step| store.rows(&query(from, to, step)).unwrap();
    let none = |at| Row {
        at,
        least: None,
        most: None,
        last: None,
    };
    assert_eq!(
        rows(10, 31, 0),
        [
            row(10, 1.0, 1.0, 1.0),
            row(10, 2.0, 2.0, 2.0),
            row(12, -3.0, -3.0, -3.0),
            row(25, 4.0, 4.0, 4.0),
            none(30)
        ]
    );
    assert_eq!(
        rows(8, 50, 10),
        [
            row(8, -3.0, 2.0, -3.0),
            row(18, 4.0, 4.0, 4.0),
            none(28),
            row(38, 5.0, 5.0, 5.0)
        ]
    );
    assert_eq!(rows(5, 20, 100), [row(5, -3.0, 2.0, -3.0)]);
    assert_eq!(rows(100, 200, 10), [row(100, 5.0, 5.0, 5.0)]);
    assert_eq!(rows(0, 5, 10), []);
    assert_eq!(
        csv(&rows(28, 50, 10)),
        "time,least,most,last\n1970-01-01T00:00:00.028Z,4,4,\n1970-01-01T00:00:00.038Z,5,5,5\n"
    );
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
}

pub fn a_clock_that_is_set_back_loses_nothing(store: &mut dyn Store) {
    for (at, value) in [(100, 1.0), (200, 2.0), (100, 3.0), (100, 4.0), (150, 5.0)] {
        take(store, vec![sample(at, value)]);
    }
    let rows = store.rows(&query(0, 1000, 0)).unwrap();
    let values: Vec<f64> = rows.iter().filter_map(|row| row.last).collect();
    assert_eq!(values, [1.0, 3.0, 4.0, 5.0, 2.0]);
}

pub fn each_entry_is_taken_once(store: &mut dyn Store) {
    assert_eq!(store.taken("a"), Ok(None));
    let entries = |from: u64, to: u64| -> Vec<Entry> {
        (from..=to)
            .map(|number| entry(number, number as i64, number as f64))
            .collect()
    };
    store.take("a", &entries(1, 5)).unwrap();
    // It was not heard that they were taken, and so they come again.
    store.take("a", &entries(1, 5)).unwrap();
    store.take("a", &entries(3, 8)).unwrap();
    store.take("a", &entries(2, 4)).unwrap();
    store.take("a", &[]).unwrap();
    assert_eq!(store.taken("a"), Ok(Some(8)));
    // Another gateway counts by itself.
    store.take("b", &[entry(1, 100, 100.0)]).unwrap();
    assert_eq!(store.taken("b"), Ok(Some(1)));
    let rows = store.rows(&query(0, 1000, 0)).unwrap();
    let values: Vec<f64> = rows.iter().filter_map(|row| row.last).collect();
    assert_eq!(values, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 100.0]);
}

/// A number from 0 to below `of`.
fn random(state: &mut u64, of: u64) -> u64 {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*state >> 33) % of
}

const HOUR: i64 = 3_600_000;

/// Random samples are thinned, and the hours stay the same.
pub fn thinned(store: &mut dyn Store, seed: u64) {
    let mut state = seed;
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
        take(store, samples);
    }
    let hours = query(-HOUR, at + HOUR, HOUR);
    let all = query(-HOUR, at + HOUR, 0);
    let before = store.rows(&hours).unwrap();
    let samples = store.rows(&all).unwrap().len();
    for (now, keep) in [(at / 2, HOUR), (at, HOUR), (at, HOUR / 4), (at, 0)] {
        while store.thin(now, keep).unwrap() {}
        assert_eq!(store.rows(&hours).unwrap(), before, "seed {seed}");
    }
    let left = store.rows(&all).unwrap().len();
    assert!(left < samples / 4, "seed {seed}: {left} of {samples}");
}
