//! The file of a journal: what comes back, who has taken what, what is dropped, and which files are refused.

use std::fs;
use std::path::Path;
use std::time::Duration;
use tempfile::TempDir;
use unoclp_journal::{Entry, Failure, File, Journal, Place, Policy, Sample};

const ENDLESS: u64 = u64::MAX;

fn sample(number: u64) -> Sample {
    Sample {
        board: "estufa".into(),
        point: format!("p{}", number % 3),
        at: 1_000 - number as i64,
        value: (!number.is_multiple_of(5)).then_some(number as f64),
    }
}

fn samples(from: u64, to: u64) -> Vec<Sample> {
    (from..=to).map(sample).collect()
}

fn folder() -> TempDir {
    tempfile::tempdir().unwrap()
}

fn open(folder: &TempDir) -> File {
    File::open(&folder.path().join("site.journal")).unwrap()
}

fn numbers(entries: &[Entry]) -> Vec<u64> {
    entries.iter().map(|entry| entry.number).collect()
}

#[test]
fn entries_come_back_in_order_with_their_numbers_until_all_have_taken_them() {
    let folder = folder();
    let mut file = open(&folder);
    file.set_readers(&["history", "mqtt"]).unwrap();
    let source = file.source().to_owned();
    assert_eq!(source.len(), 32);
    file.commit(&samples(1, 5), &[], ENDLESS).unwrap();
    let expected: Vec<Entry> = (1..=5)
        .map(|number| Entry {
            number,
            sample: sample(number),
        })
        .collect();
    assert_eq!(file.read(0, 100).unwrap(), expected);
    assert_eq!(numbers(&file.read(2, 2).unwrap()), [3, 4]);
    file.commit(&[], &[("history".into(), 4)], ENDLESS).unwrap();
    assert_eq!(file.read(0, 100).unwrap().len(), 5);
    file.commit(&samples(6, 6), &[("mqtt".into(), 3)], ENDLESS)
        .unwrap();
    assert_eq!(numbers(&file.read(0, 100).unwrap()), [4, 5, 6]);
    drop(file);
    // After a restart all of it is so still, and the numbers go on.
    let mut file = open(&folder);
    assert_eq!((file.source(), file.last()), (&*source, 6));
    assert_eq!(file.place("history").number, 4);
    file.set_readers(&["history", "mqtt"]).unwrap();
    file.commit(&samples(7, 7), &[("mqtt".into(), 7)], ENDLESS)
        .unwrap();
    assert_eq!(numbers(&file.read(0, 100).unwrap()), [5, 6, 7]);
    // A reader that is no more is not waited for; a new one has what is there.
    file.set_readers(&["mqtt", "other"]).unwrap();
    assert_eq!(file.place("other").number, 4);
    file.commit(&[], &[("other".into(), 7)], ENDLESS).unwrap();
    assert_eq!(file.read(0, 100).unwrap(), []);
    file.skip_to(100).unwrap();
    file.skip_to(50).unwrap();
    file.commit(&samples(1, 1), &[], ENDLESS).unwrap();
    assert_eq!(numbers(&file.read(0, 100).unwrap()), [101]);
}

#[test]
fn the_file_stays_in_its_bound_and_what_is_dropped_is_counted() {
    let folder = folder();
    let mut file = open(&folder);
    file.set_readers(&["fast", "slow"]).unwrap();
    let bound = 300_000;
    let mut last = 0;
    for _ in 0..60 {
        file.commit(
            &samples(last + 1, last + 1_000),
            &[("fast".into(), last)],
            bound,
        )
        .unwrap();
        last += 1_000;
        assert!(file.used().unwrap() <= bound);
    }
    let kept = numbers(&file.read(0, usize::MAX).unwrap());
    let first = kept[0];
    assert!(kept.len() > 5_000 && first > 10_000, "{first}");
    assert_eq!(kept, (first..=last).collect::<Vec<_>>());
    let missed = Place {
        number: first - 1,
        dropped: first - 1,
    };
    assert_eq!(file.place("slow"), missed);
    assert_eq!(file.place("fast").dropped, 0);
    let on_disk: u64 = fs::read_dir(folder.path())
        .unwrap()
        .map(|file| file.unwrap().metadata().unwrap().len())
        .sum();
    // The file itself, and what is written ahead of it.
    assert!(on_disk < 2 * bound + (5 << 20), "{on_disk}");
    // It may be too small for anything at all.
    file.commit(&samples(1, 10), &[], 1).unwrap();
    assert_eq!(file.read(0, 100).unwrap(), []);
    assert_eq!(file.place("slow").dropped, last + 10);
}

#[test]
fn a_file_of_something_else_is_left_as_it_is() {
    let folder = folder();
    let refused = |path: &Path| {
        let before = fs::read(path).unwrap();
        let why = File::open(path).err().unwrap();
        assert_eq!(fs::read(path).unwrap(), before);
        why
    };
    let path = folder.path().join("site.journal");
    drop(File::open(&path).unwrap());
    let other = rusqlite::Connection::open(&path).unwrap();
    other.pragma_update(None, "user_version", 2).unwrap();
    drop(other);
    assert_eq!(refused(&path), Failure::Version(2));
    let foreign = folder.path().join("foreign.db");
    rusqlite::Connection::open(&foreign)
        .unwrap()
        .execute_batch("CREATE TABLE t (x)")
        .unwrap();
    assert_eq!(refused(&foreign), Failure::Foreign);
    let text = folder.path().join("text");
    fs::write(
        &text,
        "my notes, long enough for a head of a file".repeat(9),
    )
    .unwrap();
    assert_eq!(refused(&text), Failure::Foreign);
    assert!(File::open(&folder.path().join("none/j")).is_err());
}

#[test]
fn a_file_is_one_process_s_at_a_time() {
    let folder = folder();
    let first = open(&folder);
    let path = folder.path().join("site.journal");
    assert_eq!(File::open(&path).err(), Some(Failure::Busy));
    drop(first);
    assert!(File::open(&path).is_ok());
}

#[test]
fn who_takes_entries_hears_of_them_and_of_the_end() {
    let folder = folder();
    let policy = Policy {
        every: Duration::from_millis(5),
        bound: ENDLESS,
    };
    let journal = Journal::begin(open(&folder), policy, &["r"], Box::new(|_| ())).unwrap();
    let reader = journal.reader("r");
    let (heard, hears) = std::sync::mpsc::channel();
    reader.listen(move || {
        // After the end of the test nobody listens.
        let _ = heard.send(());
    });
    let taking = std::thread::spawn(move || {
        let mut all = Vec::new();
        loop {
            let after = all.last().copied().unwrap_or(0);
            let more = reader.wait(after, Duration::from_secs(20));
            all.extend(numbers(&reader.read(after, 7).unwrap()));
            reader.take(all.last().copied().unwrap_or(0));
            if !more && reader.is_over() {
                return all;
            }
        }
    });
    for number in 1..=200 {
        journal.put(vec![sample(number)]);
    }
    journal.end();
    assert_eq!(taking.join().unwrap(), (1..=200).collect::<Vec<_>>());
    assert!(hears.try_recv().is_ok());
    assert_eq!(journal.state().committed, 200);
    // What comes after the end is given up, and counted.
    journal.put(samples(1, 3));
    assert_eq!(journal.state().dropped, 3);
    drop(journal);
    let file = open(&folder);
    assert_eq!(file.place("r").number, 200);
}
